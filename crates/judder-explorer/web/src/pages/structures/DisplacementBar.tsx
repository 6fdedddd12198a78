/** The bar that tells the colours of displacements. */

import { type Theme, hex, shade } from "../../chart/palette";
import { short } from "./locus";

const STEPS = 24;

interface DisplacementBarProps {
  readonly theme: Theme;
  readonly largest: number;
  readonly unit: string;
}

export function DisplacementBar({ theme, largest, unit }: DisplacementBarProps) {
  const height = 160;
  const step = height / STEPS;
  const share = (k: number) => (k + 0.5) / STEPS;
  const colour = (k: number) => hex(shade(share(k), theme));
  return (
    <div class="shape-bar">
      <p>Displacement{unit !== "" && unit !== "1" ? ` (${unit})` : ""}</p>
      <div class="shape-bar-scale">
        <svg width={16} height={height} aria-hidden="true">
          {Array.from({ length: STEPS }, (_, k) => (
            <rect key={k} x={0} y={height - (k + 1) * step} width={16} height={step + 0.5} fill={colour(k)} />
          ))}
        </svg>
        <div class="shape-bar-labels">
          <span data-key="shape.largest">{short(largest)}</span>
          <span>{short(largest / 2)}</span>
          <span>0</span>
        </div>
      </div>
    </div>
  );
}
