/** One number of a list of results: six of its digits, all of them on hovering and for whoever reads the page by program. */

import { Label } from "./Label";
import { readable } from "./readable";

interface ValueProps {
  readonly name: string;
  /** The path of the number in the document it comes from, such as `growth_rate`. */
  readonly dataKey: string;
  readonly value: number | string | null | undefined;
  readonly unit?: string;
}

export function Value({ name, dataKey, value, unit = "1" }: ValueProps) {
  const known = value !== null && value !== undefined;
  const shown = typeof value === "number" ? readable(value, unit) : { text: known ? value : "—", unit: known ? unit : "1" };
  const whole = known ? String(value) : "";
  return (
    <div class="value">
      <dt>
        <Label text={name} />
      </dt>
      <dd title={typeof value === "number" ? `${whole} ${unit === "1" ? "" : unit}`.trim() : undefined}>
        <span data-key={dataKey} data-value={whole}>
          {shown.text}
        </span>
        {shown.unit !== "1" && <span class="value-unit"> {shown.unit}</span>}
      </dd>
    </div>
  );
}
