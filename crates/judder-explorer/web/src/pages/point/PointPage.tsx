/** The point page: one operating point with all that moves there. */

import { useMemo } from "preact/hooks";
import { useView } from "../../state/store";
import { options } from "../../state/view";
import { useApp } from "../../ui/app";
import { ErrorNote, unlessSaid } from "../../ui/ErrorNote";
import { useCaseFile } from "../../ui/files";
import { Page } from "../../ui/Page";
import { PointValues } from "../../ui/PointValues";
import { StandingNote } from "../../ui/StandingNote";
import { type Standing, StandingContext, useStanding } from "../../ui/standing";
import { usePoint } from "../../ui/usePoint";
import { Value } from "../../ui/Value";
import { type Point, fetchCaseFile } from "../../wire/api";
import { outcomeOf } from "../../wire/outcome";
import { type Branch, collectBranch } from "./branch";
import { BranchSection } from "./BranchSection";
import { collectCycle, loopOf } from "./cycle";
import { CycleSection } from "./CycleSection";
import { EigenSection } from "./EigenSection";
import { type Mode, modesOf } from "./eigen";
import { GrowthShares } from "./GrowthShares";
import { valueOf } from "./keys";
import { type Motion, collectMotion, strongest } from "./motion";
import { MotionSection } from "./MotionSection";
import { ShapesSection } from "./ShapesSection";
import { type Track, modeTrack } from "./sound";
import { type Source, SoundSection } from "./SoundSection";
import { type PointState, caseAnalysis, readPoint } from "./state";
import { type Run, useRun } from "./useRun";
import "../map/map.css";
import "./point.css";

export function PointPage() {
  const { session, store, keys, values, error: refused } = useApp();
  const view = useView(store);
  const state = useMemo(() => readPoint(view, session, keys, (key) => valueOf(key, values)), [view, session, keys, values]);
  const set = options(view);
  const live = usePoint(set);
  const { point } = live;
  const modes = useMemo(() => modesOf(point?.point.eigenvalues ?? []), [point]);
  const frequency = values?.scales["natural_frequency"] ?? null;
  const { motion, cycle, branch } = useRuns(state, set, values !== null);
  const scale = values?.scales["length"] ?? null;
  const speed = point?.dimensional["velocity_m_per_s"];
  const belt = speed != null && scale !== null && frequency !== null ? speed / (scale * frequency) : null;
  const loop = useMemo(() => (cycle.result && !cycle.isStale ? loopOf(cycle.result) : null), [cycle.result, cycle.isStale]);
  const sources = useSources(motion, cycle, modes, frequency, scale);
  usePointCaseFile(state);
  const isStale = live.set !== JSON.stringify(set);
  const failure = isStale ? (live.error ?? refused) : null;
  const standing = useStanding({ has: point !== null, isCurrent: !isStale, busy: !failure, what: "the operating point", error: failure }, point);
  return (
    <Page title="Operating point">
      <ErrorNote error={unlessSaid(live.error, refused)} />
      <StandingNote standing={standing} spoken />
      <div class="point-cards">
        <StandingContext.Provider value={standing}>
          <div class={`point-column${standing ? " stale" : ""}`}>
            <EigenSection state={state} eigenvalues={point?.point.eigenvalues ?? null} modes={modes} />
            {point && frequency !== null && <ShapesSection state={state} point={point} modes={modes} frequency={frequency} />}
          </div>
          {point && <Numbers point={point} standing={standing} stale={isStale} busy={isStale && !failure} />}
        </StandingContext.Provider>
        <MotionSection state={state} run={motion} cycle={loop} modes={modes} belt={belt} steady={point?.point.equilibrium["x"] ?? null} />
        <CycleSection state={state} run={cycle} frequency={frequency} />
        <SoundSection state={state} sources={sources} hasModes={point !== null && frequency !== null} />
        <BranchSection state={state} run={branch} />
      </div>
    </Page>
  );
}

interface NumbersProps {
  readonly point: Point;
  readonly standing: Standing | null;
  readonly stale: boolean;
  readonly busy: boolean;
}

function Numbers({ point, standing, stale, busy }: NumbersProps) {
  const thresholds = (name: "critical_shear_strength" | "critical_load", title: string) =>
    point.point[name].map((value, index) => <Value key={`${name}${index}`} name={title} dataKey={`${name}.${index}`} value={value} />);
  const ranges = (name: "critical_shear_strength_within_law" | "critical_load_within_law", title: string) =>
    (point.point[name] ?? []).flatMap((range, index) =>
      (["from", "to"] as const).map((end, side) => (
        <Value key={`${name}${index}${end}`} name={`${title}, within the law ${end}`} dataKey={`${name}.${index}.${side}`} value={range[side]} />
      )),
    );
  return (
    <section class={`card numbers${stale ? " stale" : ""}`} aria-label="Numbers of the operating point" aria-busy={busy}>
      <h2>Operating point</h2>
      <StandingNote standing={standing} />
      <GrowthShares shares={point.point.growth_shares} />
      <h3>Thresholds</h3>
      <dl class="values">
        {thresholds("critical_shear_strength", "critical shear strength $τ_{0}$/$E_{0}$*")}
        {ranges("critical_shear_strength_within_law", "$τ_{0}$/$E_{0}$*")}
        {thresholds("critical_load", "critical load $F_{n}$/($E_{0}$* $R$²)")}
        {ranges("critical_load_within_law", "$F_{n}$/($E_{0}$* $R$²)")}
      </dl>
      {point.point.critical_shear_strength.length + point.point.critical_load.length === 0 && <p class="note">There is none in the range that is searched.</p>}
      <PointValues point={point} shares={false} />
    </section>
  );
}

function useRuns(state: PointState, set: readonly string[], hasValues: boolean) {
  const { run, live } = state;
  const asked = { set, live: false, address: "/api/analysis" } as const;
  const motion = useRun<Motion>({ set, live, address: "/api/motion", purpose: "motion", analyses: [state.motion], collect: collectMotion, wanted: run.includes("motion") });
  const cycle = useRun<Motion>({ ...asked, purpose: "cycle", analyses: [state.cycle], collect: collectCycle, wanted: run.includes("cycle") });
  // the swept key's own value does not matter, but without values the range about it is not known
  const others = set.filter((option) => !option.startsWith(`${state.branch.key}=`));
  const branch = useRun<Branch>({ ...asked, set: others, purpose: "branch", analyses: state.diagrams, collect: collectBranch, wanted: hasValues && run.includes("branch") });
  return { motion, cycle, branch };
}

/** What can be heard: with scales in SI units a motion has its real pitch and velocity. */
function useSources(motion: Run<Motion>, cycle: Run<Motion>, modes: readonly Mode[], frequency: number | null, scale: number | null): readonly Source[] {
  const heard = useMemo(() => (frequency !== null && scale !== null ? trackOf(motion.result, frequency, scale, false) : null), [motion.result, frequency, scale]);
  const looped = useMemo(() => (frequency !== null && scale !== null ? trackOf(cycle.result, frequency, scale, true) : null), [cycle.result, frequency, scale]);
  const tones = useMemo(
    () =>
      modes.flatMap((mode): Source[] => {
        if (!mode.oscillates || frequency === null) return [];
        const [re, im] = mode.value;
        const track = modeTrack([re * frequency, im * frequency]);
        return [{ id: mode.name.replace(" ", "-"), name: `${mode.name}, ${re > 0 ? "growing" : "dying away"}`, track, unit: "", isStale: false }];
      }),
    [modes, frequency],
  );
  return [
    ...(heard ? [{ id: "motion", name: "motion", track: heard, unit: "m/s", isStale: motion.isStale }] : []),
    ...(looped ? [{ id: "cycle", name: "limit cycle", track: looped, unit: "m/s", isStale: cycle.isStale }] : []),
    ...tones,
  ];
}

/** A whole motion over real time; a cycle's frequency is that of its oscillations. */
function trackOf(motion: Motion | null, frequency: number, scale: number, loops: boolean): Track | null {
  if (!motion?.outcome) return null;
  const { fine, outcome, spectrum } = motion;
  const { period, oscillations } = outcomeOf(outcome).scalars;
  const turns = loops ? Math.max(Number(oscillations ?? 1), 1) : 1;
  const rate = typeof period === "number" && period > 0 ? (2 * Math.PI * turns) / period : (strongest(spectrum) ?? 0);
  return {
    time: fine.time.map((time) => time / frequency),
    x: fine.x.map((x) => x * scale),
    velocity: fine.velocity.map((velocity) => velocity * scale * frequency),
    frequency: (rate * frequency) / (2 * Math.PI),
    loops,
  };
}

/** The exported case asks for what was last started here. */
function usePointCaseFile(state: PointState): void {
  const { session, store } = useApp();
  useCaseFile(() => ({ text: fetchCaseFile(options(store.view), caseAnalysis(state, session)) }));
}
