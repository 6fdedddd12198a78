/** The bursts of a march; a click moves the cursor to where one is loudest. */

import type { Burst } from "./march";
import { PickTable } from "./PickTable";
import { unitMarkup } from "./study";

interface BurstTableProps {
  readonly analysis: string;
  readonly bursts: readonly Burst[];
  readonly unit: string;
  readonly at: number | undefined;
  readonly onMove: (position: number) => void;
}

export function BurstTable({ analysis, bursts, unit, at, onMove }: BurstTableProps) {
  if (bursts.length === 0) return <p>No burst was found.</p>;
  const column = (name: keyof Burst, head: string) => ({ head, value: (burst: Burst) => burst[name], dataKey: (index: number) => `${analysis}.bursts.${index}.${name}` });
  const columns = [
    column("position_m", "Position (m)"),
    column("time_s", "Time (s)"),
    column("frequency_hz", "Frequency (Hz)"),
    column("peak", `Peak${unit ? ` (${unitMarkup(unit)})` : ""}`),
    column("duration_s", "Duration (s)"),
    column("measured_amplification", "e-folds of growth, measured"),
    column("expected_amplification", "e-folds, expected"),
  ];
  const caption = bursts.length === 1 ? "One burst" : `${bursts.length} bursts`;
  return <PickTable caption={caption} rows={bursts} columns={columns} isPicked={(burst) => at === burst.position_m} onPick={(burst) => onMove(burst.position_m)} />;
}
