/** The phase of a mode that moves, or that is held at one moment. */

import { useState } from "preact/hooks";
import type { ViewStore } from "../../state/store";
import { type View, withFields } from "../../state/view";
import { numberField } from "./state";

export interface Playback {
  /** In radians. */
  readonly phase: number;
  /** The phase as it moves on by itself. */
  readonly onPhase: (phase: number) => void;
  readonly playing: boolean;
  readonly play: (on: boolean) => void;
  /** Stops at a phase, which the address keeps. */
  readonly hold: (phase: number) => void;
}

export function usePlayback(store: ViewStore, view: View): Playback {
  const kept = numberField(view, "phase");
  const [phase, setPhase] = useState(((kept ?? 0) * Math.PI) / 180);
  // what moves by itself must not where less motion is wished for, nor where the address asks for one moment
  const [playing, setPlaying] = useState(() => !globalThis.matchMedia?.("(prefers-reduced-motion: reduce)").matches && kept === undefined);
  const keep = (next: number | undefined) =>
    store.update((view) => withFields(view, { phase: next === undefined ? undefined : String(Math.round((next * 180) / Math.PI) % 360) }), "quiet");
  const play = (on: boolean) => {
    setPlaying(on);
    keep(on ? undefined : phase);
  };
  const hold = (next: number) => {
    setPlaying(false);
    setPhase(next);
    keep(next);
  };
  return { phase, onPhase: setPhase, playing, play, hold };
}
