/** What moves a slider: keys or a pointer. */

import { useRef } from "preact/hooks";
import type { Keep } from "../state/store";

interface Hand {
  /** Listeners of the slider. */
  readonly on: { readonly onKeyDown: () => void; readonly onPointerDown: () => void };
  /** How the end of a move is kept: presses of keys that follow one another are one step, drags are one each. */
  readonly keep: () => Keep;
}

export function useHand(): Hand {
  const keyed = useRef(false);
  const set = (by: boolean) => () => {
    keyed.current = by;
  };
  return { on: { onKeyDown: set(true), onPointerDown: set(false) }, keep: () => (keyed.current ? "step" : "push") };
}
