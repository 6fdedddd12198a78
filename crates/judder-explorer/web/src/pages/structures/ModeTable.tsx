/** The modes of which one is shown. */

import { Digits } from "../../ui/Digits";
import { verdictOf } from "./verdicts";

interface ModeRow {
  /** Hz. */
  readonly frequency: number;
  /** 1/s; null where there is no damping. */
  readonly growth: number | null;
  /** −Re λ/|λ|; left out where it is not stored. */
  readonly dampingRatio?: number | undefined;
  /** What the study says of it. */
  readonly verdict?: string | undefined;
}

interface ModeTableProps {
  readonly title: string;
  readonly modes: readonly ModeRow[];
  readonly picked: number;
  readonly onPick: (index: number) => void;
  /** What the numbers are of, in the document they come from. */
  readonly dataKey: string;
}

export function ModeTable({ title, modes, picked, onPick, dataKey }: ModeTableProps) {
  const grows = modes.some((mode) => mode.growth !== null);
  const hasRatios = modes.some((mode) => mode.dampingRatio !== undefined);
  return (
    <div class={grows ? "mode-table mode-table-wide" : "mode-table"}>
      <table class="study-table">
        <caption>{title}</caption>
        <thead>
          <tr>
            <th scope="col">Mode</th>
            <th scope="col">Frequency (Hz)</th>
            {grows && <th scope="col">Growth rate (1/s)</th>}
            {hasRatios && <th scope="col">Damping ratio</th>}
            {grows && <th scope="col">Verdict</th>}
          </tr>
        </thead>
        <tbody>
          {modes.map((mode, index) => {
            const verdict = mode.growth === null ? "" : verdictOf(mode.growth, mode.verdict);
            const unstable = verdict === "unstable";
            return (
              <tr key={index} class={[index === picked ? "picked" : "", unstable ? "unstable" : ""].join(" ")}>
                <td>
                  <button type="button" aria-pressed={index === picked} onClick={() => onPick(index)}>
                    {index + 1}
                  </button>
                </td>
                <td>
                  <Digits dataKey={`${dataKey}.frequency.${index}`} value={mode.frequency} />
                </td>
                {grows && (
                  <td>
                    <Digits dataKey={`${dataKey}.growth.${index}`} value={mode.growth} />
                  </td>
                )}
                {hasRatios && (
                  <td>
                    <Digits dataKey={`${dataKey}.damping_ratio.${index}`} value={mode.dampingRatio} />
                  </td>
                )}
                {grows && <td>{unstable ? "unstable ▲" : verdict}</td>}
              </tr>
            );
          })}
        </tbody>
      </table>
    </div>
  );
}
