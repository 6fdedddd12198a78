/** The bursts of a march; a click moves the cursor to where one is loudest. */

import { Digits } from "../../ui/Digits";
import { Label } from "../../ui/Label";
import type { Burst } from "./march";
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
  const columns: readonly (readonly [keyof Burst, string])[] = [
    ["time_s", "Time (s)"],
    ["frequency_hz", "Frequency (Hz)"],
    ["peak", `Peak${unit ? ` (${unitMarkup(unit)})` : ""}`],
    ["duration_s", "Duration (s)"],
    ["measured_amplification", "e-folds of growth, measured"],
    ["expected_amplification", "e-folds, expected"],
  ];
  return (
    <div class="zone-table">
      <table class="study-table">
        <caption>{bursts.length === 1 ? "One burst" : `${bursts.length} bursts`}</caption>
        <thead>
          <tr>
            <th scope="col">Position (m)</th>
            {columns.map(([name, words]) => (
              <th scope="col" key={name}>
                <Label text={words} />
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {bursts.map((burst, index) => (
            <tr key={index} class={at === burst.position_m ? "picked" : ""}>
              <td>
                <button type="button" onClick={() => onMove(burst.position_m)} title="Moves the cursor here">
                  <Digits dataKey={`${analysis}.bursts.${index}.position_m`} value={burst.position_m} />
                </button>
              </td>
              {columns.map(([name]) => (
                <td key={name}>
                  <Digits dataKey={`${analysis}.bursts.${index}.${name}`} value={burst[name]} />
                </td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
