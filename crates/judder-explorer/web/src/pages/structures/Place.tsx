/** The place that all charts share: a slider and a field. */

import { useEffect, useState } from "preact/hooks";
import type { Axis } from "../../chart/spec";
import type { Keep } from "../../state/store";
import { useHand } from "../../ui/hand";
import { Label } from "../../ui/Label";

interface PlaceProps {
  readonly axis: Axis;
  readonly unit: string;
  readonly at: number;
  readonly range: readonly [number, number];
  readonly step: number;
  readonly onMove: (value: number, keep?: Keep) => void;
}

export function Place({ axis, unit, at, range, step, onMove }: PlaceProps) {
  const hand = useHand();
  const [text, setText] = useState(String(at));
  useEffect(() => setText(String(at)), [at]);
  const wrong = text.trim() === "" || !Number.isFinite(Number(text));
  const take = () => {
    if (wrong) setText(String(at));
    else if (Number(text) !== at) onMove(Number(text));
  };
  const number = (event: Event) => Number((event.currentTarget as HTMLInputElement).value);
  return (
    <div class="place" role="group" aria-label="Cursor">
      <span>
        <Label text={axis.label} />
      </span>
      <input
        type="range"
        aria-label="Cursor"
        min={range[0]}
        max={range[1]}
        step={step}
        value={at}
        onInput={(event) => onMove(number(event), "drag")}
        onChange={(event) => onMove(number(event), hand.keep())}
        {...hand.on}
      />
      <input
        type="text"
        inputMode="decimal"
        aria-label={`Cursor${unit === "1" ? "" : ` in ${unit}`}`}
        aria-invalid={wrong}
        data-key="at"
        value={text}
        onInput={(event) => setText((event.currentTarget as HTMLInputElement).value)}
        onChange={take}
        onBlur={take}
      />
      {unit !== "1" && <span>{unit}</span>}
    </div>
  );
}
