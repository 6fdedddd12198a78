/** A slider: drags are kept as one step each, presses of keys that follow one another as one. */

import { useRef } from "preact/hooks";
import type { Keep } from "../state/store";

interface SliderProps {
  readonly from: number;
  readonly to: number;
  readonly step: number;
  readonly value: number;
  /** Its name, where it stands in no label. */
  readonly spoken?: string;
  /** Its value in words, where the number alone is none. */
  readonly spokenValue?: string;
  readonly onMove: (value: number, keep: Keep) => void;
}

export function Slider({ from, to, step, value, spoken, spokenValue, onMove }: SliderProps) {
  const isKeyed = useRef(false);
  const by = (keyed: boolean) => () => {
    isKeyed.current = keyed;
  };
  return (
    <input
      type="range"
      min={from}
      max={to}
      step={step}
      value={value}
      {...(spoken ? { "aria-label": spoken } : {})}
      {...(spokenValue ? { "aria-valuetext": spokenValue } : {})}
      onInput={(event) => onMove(Number(event.currentTarget.value), "drag")}
      onChange={(event) => onMove(Number(event.currentTarget.value), isKeyed.current ? "step" : "push")}
      onKeyDown={by(true)}
      onPointerDown={by(false)}
    />
  );
}
