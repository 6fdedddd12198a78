/** The place that all charts share: a slider and a field. */

import { useEffect, useState } from "preact/hooks";
import type { Axis } from "../../chart/spec";
import type { Keep } from "../../state/store";
import { Label } from "../../ui/Label";
import { Slider } from "../../ui/Slider";

interface PlaceProps {
  readonly axis: Axis;
  readonly unit: string;
  readonly at: number;
  readonly range: readonly [number, number];
  readonly step: number;
  readonly onMove: (value: number, keep?: Keep) => void;
}

export function Place({ axis, unit, at, range, step, onMove }: PlaceProps) {
  const [text, setText] = useState(String(at));
  useEffect(() => setText(String(at)), [at]);
  const wrong = text.trim() === "" || !Number.isFinite(Number(text));
  const take = () => {
    if (wrong) setText(String(at));
    else if (Number(text) !== at) onMove(Number(text));
  };
  return (
    <div class="place" role="group" aria-label="Cursor">
      <span>
        <Label text={axis.label} />
      </span>
      <Slider spoken="Cursor" from={range[0]} to={range[1]} step={step} value={at} onMove={onMove} />
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
