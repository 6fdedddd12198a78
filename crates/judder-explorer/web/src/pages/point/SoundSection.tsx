/** Hear it: the velocity of the motion, of the cycle, or of a mode, scaled to the audible. */

import { useEffect, useRef, useState } from "preact/hooks";
import { brief } from "../../chart/readout";
import type { Keep } from "../../state/store";
import { withFields } from "../../state/view";
import { Select } from "../../ui/choices";
import { useApp } from "../../ui/app";
import { download, fileName } from "../../ui/files";
import { Slider } from "../../ui/Slider";
import { TextField, isPositive } from "../../ui/TextField";
import { Player } from "./player";
import { LONGEST, RATE, type Sound, type Track, faded, octaveFactor, render, wav } from "./sound";
import { VOLUME, type PointState } from "./state";

/** Seconds below which there is little to hear. */
const SHORT = 0.3;

/** What can be heard, by the name that the address keeps. */
export interface Source {
  readonly id: string;
  readonly name: string;
  readonly track: Track;
  /** The unit of the velocity: m/s, or none for a mode, whose size is free. */
  readonly unit: string;
  /** Whether it belongs to values that have moved since. */
  readonly isStale: boolean;
}

interface SoundProps {
  readonly state: PointState;
  readonly sources: readonly Source[];
  /** Whether the modes are known: without a source, none of them oscillates. */
  readonly hasModes: boolean;
}

export function SoundSection({ state, sources, hasModes }: SoundProps) {
  const { store } = useApp();
  const source = sources.find((source) => source.id === state.sound) ?? sources[0];
  const factor = state.factor ?? octaveFactor(source?.track.frequency ?? 0);
  const sound = useSound(source?.track ?? null, factor);
  const keep = (change: Readonly<Record<string, string | undefined>>, how: Keep = "push") => store.update((view) => withFields(view, change), how);
  return (
    <section class="card" aria-labelledby="sound-title">
      <h2 id="sound-title">Sound</h2>
      {!source && <p class="note">Run the motion or find the cycle: their velocity can then be heard.{hasModes && " Here no mode oscillates."}</p>}
      {source && sound && (
        <>
          <div class="run-bar">
            <label class="choice">
              hear{" "}
              <Select value={source.id} options={sources.map(({ id, name }) => [id, name])} onChange={(sound) => keep({ sound, factor: undefined })} />
            </label>
            <PlayButtons source={source} sound={sound} volume={state.volume} />
            <label class="choice">
              volume{" "}
              <Slider from={0} to={1} step={0.05} value={state.volume} onMove={(volume, how) => keep({ volume: how !== "drag" && volume === VOLUME ? undefined : String(volume) }, how)} />
            </label>
          </div>
          <FactorControls factor={factor} own={state.factor !== null} onFactor={(factor, how) => keep({ factor }, how)} />
          <Facts source={source} sound={sound} factor={factor} />
        </>
      )}
    </section>
  );
}

/** Milliseconds: while a slider moves nothing is rendered. */
const REST = 150;

/** The sound of a track, once it and the factor rest. */
function useSound(track: Track | null, factor: number): Sound | null {
  const [sound, setSound] = useState<Sound | null>(null);
  useEffect(() => {
    if (!track) return setSound(null);
    const timer = setTimeout(() => setSound(render(track, factor)), REST);
    return () => clearTimeout(timer);
  }, [track, factor]);
  return sound;
}

interface FactorControlsProps {
  readonly factor: number;
  readonly own: boolean;
  readonly onFactor: (factor: string | undefined, how: Keep) => void;
}

/** The slider moves by twelfths of an octave. */
function FactorControls({ factor, own, onFactor }: FactorControlsProps) {
  return (
    <div class="run-bar">
      <label class="choice factor">
        time factor{" "}
        <Slider from={-8} to={20} step={1 / 12} value={Math.log2(factor)} spokenValue={`${brief(factor)} times`} onMove={(octaves, how) => onFactor(String(Number((2 ** octaves).toPrecision(5))), how)} />
      </label>
      <TextField name="×" title="how many times faster than real it is played" value={factor} accepts={isPositive} onChange={(text) => onFactor(text, "push")} />
      <button type="button" disabled={!own} onClick={() => onFactor(undefined, "push")}>
        Nearest octave
      </button>
    </div>
  );
}

function Facts({ source, sound, factor }: { readonly source: Source; readonly sound: Sound; readonly factor: number }) {
  const { frequency, loops } = source.track;
  const played = frequency * factor;
  const facts = [
    ["real frequency", `${brief(frequency)} Hz`],
    ["played frequency", `${brief(played)} Hz`],
    ["time", factor >= 1 ? `${brief(factor)} times faster than real` : `${brief(1 / factor)} times slower than real`],
    ["length", `${brief(sound.samples.length / RATE)} s${loops ? ", in a loop" : ""}`],
    ["gain", source.unit === "" ? "the mode's size is free" : `full scale is ${brief(1 / sound.gain)} ${source.unit}`],
  ] as const;
  return (
    <>
      <dl class="values sound-facts">
        {facts.map(([name, text]) => (
          <div class="value" key={name}>
            <dt>{name}</dt>
            <dd>{text}</dd>
          </div>
        ))}
      </dl>
      {!loops && sound.samples.length < SHORT * RATE && (
        <p class="note">
          So short that little is heard.{" "}
          {source.unit === "" ? "The mode grows or dies within few of its oscillations." : "A longer duration of the motion, a smaller factor, or the limit cycle in its loop gives more."}
        </p>
      )}
      {sound.cut && <p class="note">Only its first {LONGEST} s are played: a larger factor shortens it.</p>}
      {!(played >= 20 && played <= 20_000) && <p class="point-warning">At this factor the frequency lies outside what is heard.</p>}
      {source.isStale && <p class="note">Of other values: the parameters have moved since.</p>}
    </>
  );
}

function PlayButtons({ source, sound, volume }: { readonly source: Source; readonly sound: Sound; readonly volume: number }) {
  const [playing, setPlaying] = useState(false);
  const player = useRef<Player | null>(null);
  const { loops } = source.track;
  useEffect(() => () => player.current?.close(), []);
  useEffect(() => player.current?.setVolume(volume), [volume]);
  const start = async () => {
    player.current ??= new Player();
    player.current.setVolume(volume);
    setPlaying(true);
    await player.current.play(loops ? sound.samples : faded(sound.samples), loops, () => setPlaying(false));
  };
  // what is heard follows the factor and the motion
  useEffect(() => {
    if (playing) void start();
  }, [sound]);
  const stop = () => {
    player.current?.stop();
    setPlaying(false);
  };
  const save = () => download(`${fileName(`sound of ${source.name}`)}.wav`, wav(faded(sound.samples)), "audio/wav");
  return (
    <>
      <button type="button" class="run-start" aria-pressed={playing} onClick={() => void start().catch(() => setPlaying(false))}>
        Play
      </button>
      <button type="button" disabled={!playing} onClick={stop}>
        Stop
      </button>
      <button type="button" onClick={save}>
        WAV
      </button>
    </>
  );
}
