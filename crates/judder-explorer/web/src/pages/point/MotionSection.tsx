/** The motion from here: histories, phase portrait with the limit cycle, spectrum. */

import { useMemo, useRef } from "preact/hooks";
import { withFields } from "../../state/view";
import { Switch } from "../../ui/choices";
import { useApp } from "../../ui/app";
import { StandingContext } from "../../ui/standing";
import { SettingControls } from "../../ui/SettingControls";
import type { RequestError } from "../../wire/request";
import { LinkedCharts } from "./LinkedCharts";
import type { Mode } from "./eigen";
import { type Loop, type Motion, historySpecs, portraitSpec, spectrumSpec } from "./motion";
import { RunBar } from "./RunBar";
import { type Entry, Summary } from "./Summary";
import type { PointState } from "./state";
import { StillChart } from "./StillChart";
import { type Run, useRunStanding } from "./useRun";

const ENTRIES: readonly Entry[] = [
  { path: "rms", name: "rms of $x$/$x_{0}$" },
  { path: "mean", name: "mean of $x$/$x_{0}$" },
  { path: "period", name: "period $θ$" },
  { path: "repeats", name: "repeats itself" },
  { path: "stick_fraction", name: "share of the time in stick" },
  { path: "slip_ahead_fraction", name: "in slip ahead" },
  { path: "lift_off_fraction", name: "in lift-off" },
  { path: "oscillations", name: "oscillations" },
  { path: "changes", name: "changes of the contact state" },
  { path: "steps", name: "steps" },
  { path: "transient", name: "averaged after $θ$" },
  { path: "energy.friction", name: "work of friction" },
  { path: "energy.normal", name: "work of the normal force" },
  { path: "energy.damping", name: "work of the dampers" },
  { path: "energy.change", name: "change of the energy" },
  { path: "energy.residual", name: "residual of the energy" },
  { path: "quasi_steady.largest", name: "largest (ω − $v_{d}$/$A_{x}$) τ" },
];

interface MotionSectionProps {
  readonly state: PointState;
  readonly run: Run<Motion>;
  readonly cycle: Loop | null;
  readonly modes: readonly Mode[];
  /** The speed of the substrate over x0 ω_nx. */
  readonly belt: number | null;
  /** x of steady sliding. */
  readonly steady: number | null;
}

export function MotionSection({ state, run, cycle, modes, belt, steady }: MotionSectionProps) {
  const motion = run.result;
  // the marks of the values that the motion belongs to: those of newer values wait for a newer motion
  const standing = useRunStanding(run);
  const marks = useRef({ belt, steady, modes });
  if (!run.isStale) marks.current = { belt, steady, modes };
  const { belt: line, steady: middle, modes: marked } = marks.current;
  const { duration } = state.motion;
  const end = run.busy && !run.isStale && typeof duration === "number" ? duration : null;
  const histories = useMemo(() => (motion ? historySpecs(motion, line, end) : []), [motion, line, end]);
  const portrait = useMemo(() => portraitSpec(motion, cycle, line, middle), [motion, cycle, line, middle]);
  const spectrum = useMemo(() => (motion?.spectrum ? spectrumSpec(motion.spectrum, marked) : null), [motion, marked]);
  return (
    <section class="card card-wide" aria-labelledby="motion-title">
      <h2 id="motion-title">Motion from here</h2>
      <RunBar kind="motion" name="Run the motion" run={run} analysis={state.motion} share={shareOf(run, state)}>
        <MotionControls state={state} error={run.error} />
      </RunBar>
      {!motion && !cycle && <p class="note">Event by event through stick, slip and lift-off, from steady sliding with x moved by a share of itself. Drawn while it is computed.</p>}
      {(motion || cycle) && (
        <StandingContext.Provider value={motion ? standing : null}>
          <div class="motion-charts">
            <div>{motion && <LinkedCharts specs={histories} height={200} of={`${duration}`} />}</div>
            <div>
              <StillChart spec={portrait} height={310} />
              {spectrum && <StillChart spec={spectrum} height={250} />}
            </div>
          </div>
        </StandingContext.Provider>
      )}
      <div class={standing ? "stale" : ""}>{motion?.outcome && <Summary outcome={motion.outcome} prefix="motion" entries={ENTRIES} />}</div>
    </section>
  );
}

/** How far a motion has come of its duration, where that is a number. */
function shareOf(run: Run<Motion>, state: PointState): number | null {
  const now = run.isStale ? undefined : run.result?.time.at(-1);
  const { duration } = state.motion;
  return run.busy && now !== undefined && typeof duration === "number" && duration > 0 ? now / duration : null;
}

function MotionControls({ state, error }: { readonly state: PointState; readonly error: RequestError | null }) {
  const { store } = useApp();
  return (
    <>
      <SettingControls kind="motion" first={["duration", "start.disturbance", "points"]} error={error} />
      <Switch name="follow the parameters" title="run again as the parameters move" on={state.live} onChange={(on) => store.update((view) => withFields(view, { live: on ? "on" : undefined }))} />
    </>
  );
}
