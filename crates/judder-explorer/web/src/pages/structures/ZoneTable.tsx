/** Unstable zones; a click moves the cursor to where one grows fastest. */

import type { Zone } from "./locus";
import { PickTable } from "./PickTable";

interface ZoneTableProps {
  readonly analysis: string;
  readonly zones: readonly Zone[];
  readonly unit: string;
  readonly at: number;
  readonly onMove: (value: number) => void;
}

export function ZoneTable({ analysis, zones, unit, at, onMove }: ZoneTableProps) {
  if (zones.length === 0) return <p>No unstable zone is stored.</p>;
  const column = (head: string, name: string, value: (zone: Zone) => number | null) => ({ head, value, dataKey: (index: number) => `${analysis}.zone_${name}.${index}` });
  const columns = [
    column(`Fastest at${unit === "1" ? "" : ` (${unit})`}`, "peak", (zone) => zone.peak),
    column("From", "from", (zone) => zone.from),
    column("To", "to", (zone) => zone.to),
    column("Frequency (Hz)", "frequency", (zone) => zone.frequency),
    column("Growth rate (1/s)", "growth_rate", (zone) => zone.growth),
    column("Its error (1/s)", "error", (zone) => zone.error),
  ];
  const caption = zones.length === 1 ? "One unstable zone" : `${zones.length} unstable zones`;
  return <PickTable caption={caption} rows={zones} columns={columns} isPicked={(zone) => at >= zone.from && at <= zone.to} onPick={(zone) => onMove(zone.peak)} />;
}
