/** The bar that tells the colours of a picture. */

import type { Range } from "../../chart/scale";
import { type Theme, hex, shade } from "../../chart/palette";
import { sized } from "./words";

const STEPS = 24;

interface ColourBarProps {
  readonly theme: Theme;
  readonly name: string;
  readonly unit: string;
  readonly range: Range;
  /** What the upper end is, in the document it comes from. */
  readonly dataKey: string;
}

export function ColourBar({ theme, name, unit, range: [low, high], dataKey }: ColourBarProps) {
  const height = 160;
  const step = height / STEPS;
  const share = (k: number) => (k + 0.5) / STEPS;
  const colour = (k: number) => hex(shade(share(k), theme));
  const told = sized(unit, [low, high]);
  return (
    <div class="shape-bar">
      <p>
        {name}
        {told.unit === "" ? "" : ` (${told.unit})`}
      </p>
      <div class="shape-bar-scale">
        <svg width={16} height={height} aria-hidden="true">
          {Array.from({ length: STEPS }, (_, k) => (
            <rect key={k} x={0} y={height - (k + 1) * step} width={16} height={step + 0.5} fill={colour(k)} />
          ))}
        </svg>
        <div class="shape-bar-labels">
          <span data-key={dataKey} data-value={high}>
            {told.text(high)}
          </span>
          <span>{told.text((low + high) / 2)}</span>
          <span>{told.text(low)}</span>
        </div>
      </div>
    </div>
  );
}
