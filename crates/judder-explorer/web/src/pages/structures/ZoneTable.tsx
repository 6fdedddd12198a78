/** Unstable zones; a click moves the cursor to where one grows fastest. */

import { Digits } from "../../ui/Digits";
import type { Zone } from "./locus";

interface ZoneTableProps {
  readonly analysis: string;
  readonly zones: readonly Zone[];
  readonly unit: string;
  readonly at: number;
  readonly onMove: (value: number) => void;
}

export function ZoneTable({ analysis, zones, unit, at, onMove }: ZoneTableProps) {
  const unitText = unit === "1" ? "" : ` (${unit})`;
  if (zones.length === 0) return <p>No unstable zone is stored.</p>;
  return (
    <div class="zone-table">
      <table class="study-table">
        <caption>{zones.length === 1 ? "One unstable zone" : `${zones.length} unstable zones`}</caption>
        <thead>
          <tr>
            <th scope="col">Fastest at{unitText}</th>
            <th scope="col">From</th>
            <th scope="col">To</th>
            <th scope="col">Frequency (Hz)</th>
            <th scope="col">Growth rate (1/s)</th>
            <th scope="col">Its error (1/s)</th>
          </tr>
        </thead>
        <tbody>
          {zones.map((zone, index) => (
            <tr key={index} class={at >= zone.from && at <= zone.to ? "picked" : ""}>
              <td>
                <button type="button" onClick={() => onMove(zone.peak)} title="Moves the cursor here">
                  <Digits dataKey={`${analysis}.zone_peak.${index}`} value={zone.peak} />
                </button>
              </td>
              <td>
                <Digits dataKey={`${analysis}.zone_from.${index}`} value={zone.from} />
              </td>
              <td>
                <Digits dataKey={`${analysis}.zone_to.${index}`} value={zone.to} />
              </td>
              <td>
                <Digits dataKey={`${analysis}.zone_frequency.${index}`} value={zone.frequency} />
              </td>
              <td>
                <Digits dataKey={`${analysis}.zone_growth_rate.${index}`} value={zone.growth} />
              </td>
              <td>
                <Digits dataKey={`${analysis}.zone_error.${index}`} value={zone.error} />
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
