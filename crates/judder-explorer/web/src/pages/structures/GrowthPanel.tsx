/** What feeds the growth of a mode, and of which modes it is made. */

import { Digits } from "../../ui/Digits";
import { ShareBars } from "../../ui/ShareBars";
import { growthOf } from "./growth";
import { short } from "./locus";
import type { StudyAnalysis } from "./study";

interface GrowthPanelProps {
  readonly analysis: StudyAnalysis;
  /** Its number, from 1 on. */
  readonly mode: number;
}

export function GrowthPanel({ analysis, mode }: GrowthPanelProps) {
  const growing = growthOf(analysis, mode);
  if (!growing) return null;
  const path = `${analysis.name}.growing.${growing.index}`;
  return (
    <section class="growth" aria-label={`Why mode ${mode} grows`}>
      <h3>Shares of the growth rate of mode {mode} (1/s)</h3>
      <p class="study-note">They add up to it: to the right something feeds the growth, to the left it takes from it.</p>
      <ShareBars rows={growing.shares.map(([name, value]) => ({ key: `${path}.growth.${name}`, name, value }))} />
      {growing.parents.length > 0 && (
        <table class="study-table">
          <caption>Its parents, modes of frictionless contact</caption>
          <thead>
            <tr>
              <th scope="col">Frequency (Hz)</th>
              <th scope="col">Share of the kinetic energy (%)</th>
            </tr>
          </thead>
          <tbody>
            {growing.parents.map(({ frequency, share }, k) => (
              <tr key={k}>
                <td>
                  <Digits dataKey={`${path}.parents.${k}.frequency_hz`} value={frequency} />
                </td>
                <td data-key={`${path}.parents.${k}.share`} data-value={share}>
                  {short(100 * share)}
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      )}
    </section>
  );
}
