/** The sounds of a march: as recorded, at its own speed. */

import { Select } from "../../ui/choices";
import { Slider } from "../../ui/Slider";
import { Digits } from "../../ui/Digits";
import { useEffect, useRef, useState } from "preact/hooks";
import { ErrorNote } from "../../ui/ErrorNote";
import { Label } from "../../ui/Label";
import { RequestError, asRequestError, isAbort } from "../../wire/request";
import { type Study, unitMarkup } from "./study";

/** What the summary says of a sound. */
export interface SoundFile {
  readonly file: string;
  readonly signal: string;
  readonly gain: number;
  readonly gain_unit: string;
  readonly sample_rate: number;
}

interface SoundPlayerProps {
  readonly study: Study;
  readonly sounds: readonly SoundFile[];
  /** The time of the march at which sounds begin, s. */
  readonly start: number;
  /** The time of the cursor. */
  readonly cursor: number | null;
  /** The time that is heard; null while nothing is. */
  readonly onHeard: (time: number | null) => void;
}

/** The file as an address of its own: a browser can only seek in what it has. */
function useSound(file: string | undefined, onError: (error: RequestError | null) => void): string | undefined {
  const [sound, setSound] = useState<{ file: string; address: string } | null>(null);
  useEffect(() => {
    if (!file) return;
    const abort = new AbortController();
    let made: string | undefined;
    onError(null);
    fetchSound(file, abort.signal).then(
      (blob) => {
        if (abort.signal.aborted) return;
        made = URL.createObjectURL(blob);
        setSound({ file, address: made });
      },
      (failure) => !isAbort(failure) && onError(asRequestError(failure)),
    );
    return () => {
      abort.abort();
      if (made) URL.revokeObjectURL(made);
    };
  }, [file]);
  return sound?.file === file ? sound?.address : undefined;
}

async function fetchSound(file: string, signal: AbortSignal): Promise<Blob> {
  const response = await fetch(`/api/study/sound/${file.split("/").map(encodeURIComponent).join("/")}`, { credentials: "same-origin", signal });
  if (!response.ok) throw new RequestError(`${file} cannot be read`, response.status, null, "Is it still in the folder of the study?");
  return response.blob();
}

/** How often the moment that is heard is shown, in milliseconds. */
const EVERY = 50;

/** The element that plays: its volume, its moment, its start and end. */
function usePlayer(volume: number, onHeard: (time: number | null) => void, onError: (error: RequestError | null) => void) {
  const audio = useRef<HTMLAudioElement>(null);
  const [playing, setPlaying] = useState(false);
  const heard = useRef(onHeard);
  heard.current = onHeard;
  useEffect(() => {
    if (audio.current) audio.current.volume = volume;
  });
  useEffect(() => {
    if (!playing) return heard.current(null);
    const timer = setInterval(() => audio.current && heard.current(audio.current.currentTime), EVERY);
    return () => clearInterval(timer);
  }, [playing]);
  useEffect(() => () => audio.current?.pause(), []);
  const play = (from: number) => {
    const node = audio.current;
    if (!node) return;
    onError(null);
    node.currentTime = Math.max(from, 0);
    node.play().catch((failure: unknown) => {
      // a stop before the start is no error
      if (failure instanceof DOMException && failure.name === "AbortError") return;
      onError(new RequestError("the sound cannot be played", 0, null, failure instanceof Error ? failure.message : null));
    });
  };
  const end = () => setPlaying(false);
  return { audio, playing, play, stop: () => audio.current?.pause(), on: { onPlay: () => setPlaying(true), onPause: end, onEnded: end } };
}

export function SoundPlayer({ study, sounds, start, cursor, onHeard }: SoundPlayerProps) {
  const there = sounds.filter((sound) => study.sounds.some(({ path }) => path === sound.file));
  const [file, setFile] = useState(there[0]?.file);
  const [volume, setVolume] = useState(0.5);
  const [length, setLength] = useState<number | null>(null);
  const [error, setError] = useState<RequestError | null>(null);
  const sound = there.find((one) => one.file === file) ?? there[0];
  const address = useSound(sound?.file, setError);
  const { audio, playing, play, stop, on } = usePlayer(volume, (time) => onHeard(time === null ? null : start + time), setError);
  if (!sound) return null;
  return (
    <section class="sound" aria-label="Sound">
      <audio
        ref={audio}
        {...(address ? { src: address } : {})}
        onLoadedMetadata={(event) => setLength(event.currentTarget.duration)}
        {...on}
        onError={() => setError(new RequestError(`${sound.file} cannot be played`, 0, null, null))}
      />
      <label>
        <span>Sound of </span>
        <Select value={sound.file} options={there.map((one) => [one.file, one.signal])} onChange={setFile} />
      </label>
      <button type="button" onClick={() => (playing ? stop() : play(0))} aria-pressed={playing} disabled={!address}>
        {playing ? "Stop" : "Play"}
      </button>
      <button type="button" onClick={() => play((cursor ?? start) - start)} disabled={cursor === null || !address}>
        Play from the cursor
      </button>
      <label>
        <span>Volume </span>
        <Slider from={0} to={1} step={0.01} value={volume} onMove={setVolume} />
      </label>
      <span class="sound-words">
        {length !== null && Number.isFinite(length) && (
          <>
            <span data-key="sound.length">{Number(length.toFixed(3))}</span> s, at its own speed;{" "}
          </>
        )}
        full scale is the signal times <Digits dataKey="sound.gain" value={sound.gain} /> <Label text={unitMarkup(sound.gain_unit)} />
      </span>
      <ErrorNote error={error} />
    </section>
  );
}
