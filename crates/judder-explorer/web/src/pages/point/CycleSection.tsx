/** The limit cycle that a motion settles to: stability, period, size. */

import { Digits } from "../../ui/Digits";
import { useMemo } from "preact/hooks";
import { SettingControls } from "../../ui/SettingControls";
import { StandingContext } from "../../ui/standing";
import { brief } from "../../chart/readout";
import { beyond, floquetSpec, multipliers } from "./cycle";
import type { Motion } from "./motion";
import { RunBar } from "./RunBar";
import { type Entry, Summary } from "./Summary";
import type { PointState } from "./state";
import { StillChart } from "./StillChart";
import { type Run, useRunStanding } from "./useRun";

const ENTRIES: readonly Entry[] = [
  { path: "stable", name: "stable" },
  { path: "period", name: "period $θ$" },
  { path: "rms", name: "rms of $x$/$x_{0}$" },
  { path: "mean", name: "mean of $x$/$x_{0}$" },
  { path: "stick_fraction", name: "share of the time in stick" },
  { path: "lift_off_fraction", name: "in lift-off" },
  { path: "oscillations", name: "oscillations" },
  { path: "pattern", name: "contact states" },
  { path: "residual", name: "residual of the return map" },
  { path: "newton_iterations", name: "Newton iterations" },
  { path: "energy.residual", name: "residual of the energy" },
];

interface CycleSectionProps {
  readonly state: PointState;
  readonly run: Run<Motion>;
  /** ω_nx in rad/s. */
  readonly frequency: number | null;
}

export function CycleSection({ state, run, frequency }: CycleSectionProps) {
  const outcome = run.result?.outcome ?? null;
  const list = useMemo(() => (outcome ? multipliers(outcome) : []), [outcome]);
  const spec = useMemo(() => floquetSpec(list), [list]);
  const far = beyond(list);
  const standing = useRunStanding(run);
  const period = Number((outcome?.header["scalars"] as { period?: number } | undefined)?.period ?? Number.NaN);
  return (
    <section class="card" aria-labelledby="cycle-title">
      <h2 id="cycle-title">Limit cycle</h2>
      <RunBar kind="cycle" name="Find the cycle" run={run} analysis={state.cycle}>
        <SettingControls kind="limit-cycle" error={run.error} />
      </RunBar>
      {!outcome && <p class="note">Followed from the disturbance above until it repeats, then closed by Newton's method. It is drawn in the phase portrait.</p>}
      {outcome && (
        <div class={`two-columns${standing ? " stale" : ""}`}>
          <div>
            <StandingContext.Provider value={standing}>
              <StillChart spec={spec} height={300} />
            </StandingContext.Provider>
            {far > 0 && <p class="note">{far} of them lie farther out: zoom out to see them.</p>}
          </div>
          <div>
            <Summary outcome={outcome} prefix="cycle" entries={ENTRIES} />
            {frequency !== null && Number.isFinite(period) && (
              <p class="note">
                {brief(period / frequency)} s a period, {brief(frequency / period)} Hz
              </p>
            )}
            <h3>Floquet multipliers</h3>
            <ul class="multipliers">
              {list.map(([re, im], index) => (
                <li key={index}>
                  <Digits dataKey={`cycle.floquet_multipliers.${index}.0`} value={re} />
                  {im !== 0 && (
                    <>
                      , <Digits dataKey={`cycle.floquet_multipliers.${index}.1`} value={im} /> i
                    </>
                  )}{" "}
                  <span class="note">magnitude {brief(Math.hypot(re, im))}</span>
                </li>
              ))}
            </ul>
          </div>
        </div>
      )}
    </section>
  );
}
