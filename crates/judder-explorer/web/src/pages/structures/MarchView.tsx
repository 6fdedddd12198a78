/** The signals of a march over time, its bursts and its sounds. */

import { useMemo, useState } from "preact/hooks";
import type { Range, Window } from "../../chart/scale";
import { parseRanges } from "../../state/fields";
import { useView } from "../../state/store";
import { withFields } from "../../state/view";
import { Switch } from "../../ui/choices";
import { useApp } from "../../ui/app";
import { ErrorNote } from "../../ui/ErrorNote";
import { Label } from "../../ui/Label";
import { Busy } from "./Busy";
import { BurstTable } from "./BurstTable";
import { type Burst, MOST, type MarchZone, partOf, shownSignals, signalCsv, signalSpec, signalsOf, tablesOf, toldOfSignals, traceOf, zoneTimes } from "./march";
import { type Motion, positionAt, timeAt } from "./motion";
import { type SoundFile, SoundPlayer } from "./SoundPlayer";
import { StudyChart } from "./StudyChart";
import { numberField, placed } from "./state";
import { type Study, type StudyAnalysis, axisLabel, variable } from "./study";
import { type Arrays, type LiveArrays, numbers, useArrays } from "./useArrays";

interface MarchViewProps {
  readonly study: Study;
  readonly analysis: StudyAnalysis;
}

export function MarchView({ study, analysis }: MarchViewProps) {
  const { store } = useApp();
  const view = useView(store);
  const shown = shownSignals(analysis, view.fields["signals"]);
  const motion = variable(analysis, "position") ? ["time", "position"] : ["time"];
  const coarse = useArrays(analysis.name, [...motion, ...shown], { most: MOST });
  const time = numbers(coarse.arrays, "time");
  const whole: Range = [time[0] ?? 0, time.at(-1) ?? 1];
  const window = parseRanges(view.fields["zoom"])?.["time"];
  const part = partOf(window, whole, variable(analysis, "time")?.shape[0] ?? 0);
  const isPart = part.from !== undefined && time.length > 0;
  const fine = useArrays(analysis.name, isPart ? ["time", ...shown] : [], part, "window");
  const choose = (name: string, on: boolean) => {
    const next = signalsOf(analysis).map((signal) => signal.name).filter((one) => (one === name ? on : shown.includes(one)));
    store.update((view) => withFields(view, { signals: next.join() }));
  };
  return (
    <>
      <fieldset class="signals">
        <legend>Signals</legend>
        {signalsOf(analysis).map((signal) => (
          <Switch key={signal.name} name={<Label text={axisLabel(signal)} />} on={shown.includes(signal.name)} onChange={(on) => choose(signal.name, on)} />
        ))}
      </fieldset>
      {coarse.arrays ? (
        <Signals study={study} analysis={analysis} shown={shown} coarse={coarse.arrays} fine={isPart && fine.arrays ? fine : null} whole={whole} window={window} />
      ) : (
        <Busy live={coarse} words="Reading the signals…" />
      )}
      <ErrorNote error={coarse.arrays ? (coarse.error ?? fine.error) : null} />
      <p class="study-status" role="status">
        {isPart && fine.busy ? "Reading the finer window…" : ""}
      </p>
    </>
  );
}

interface SignalsProps extends MarchViewProps {
  readonly shown: readonly string[];
  readonly coarse: Arrays;
  /** Finer values of the window, once they are there. */
  readonly fine: LiveArrays | null;
  readonly whole: Range;
  readonly window: Range | undefined;
}

function Signals(signals: SignalsProps) {
  const { study, analysis, shown, coarse, fine, whole } = signals;
  const { store } = useApp();
  const view = useView(store);
  const [heard, setHeard] = useState<number | null>(null);
  const motion: Motion = useMemo(() => ({ time: numbers(coarse, "time"), position: numbers(coarse, "position") }), [coarse]);
  const charts = useCharts(signals, motion);
  const at = numberField(view, "at");
  const known = motion.position.length > 0;
  const mark = at === undefined ? null : known ? timeAt(motion, at) : at;
  const cursor = mark !== null && Number.isFinite(mark) ? mark : null;
  const toTime = (time: number) => {
    const next = known ? positionAt(motion, time) : time;
    const range: Range = known ? [motion.position[0] as number, motion.position.at(-1) as number] : whole;
    if (Number.isFinite(next)) store.update((view) => withFields(view, { at: String(placed(next, range)) }));
  };
  const toPosition = (position: number) => store.update((view) => withFields(view, { at: String(position) }));
  const told = tablesOf<SoundFile>(analysis, "sound");
  return (
    <>
      <p class="march-cursor">
        {cursor === null ? (
          "A click or Enter in a chart sets the cursor, which the locus shares."
        ) : (
          <>
            Cursor at <span data-key="cursor.time">{Number(cursor.toPrecision(7))}</span> s
            {known && (
              <>
                , position <span data-key="at">{at}</span> m
              </>
            )}
          </>
        )}
        {Steps(analysis)}
      </p>
      <SoundPlayer study={study} sounds={told} start={whole[0]} cursor={cursor} onHeard={setHeard} />
      {shown.length === 0 && <p>No signal is chosen.</p>}
      {charts.map(({ name, spec, dataOf }) => (
        <StudyChart
          key={name}
          spec={spec}
          names={{ x: "time" }}
          height={charts.length > 1 ? 250 : 380}
          mark={heard ?? cursor}
          onPick={({ x }) => toTime(x)}
          dataOf={dataOf}
          note={toldOfSignals(analysis, fine?.part ?? null)}
        />
      ))}
      <BurstTable analysis={analysis.name} bursts={tablesOf<Burst>(analysis, "bursts")} unit={String(analysis.scalars["signal_unit"] ?? "")} at={at} onMove={toPosition} />
    </>
  );
}

/** The charts of the signals with the zones that the contact passes, and where the samples behind them come from. */
function useCharts({ analysis, shown, coarse, fine, whole, window }: SignalsProps, motion: Motion) {
  const bands = useMemo(() => zoneTimes(tablesOf<MarchZone>(analysis, "zones"), motion), [analysis, motion]);
  const finer = fine?.arrays ?? null;
  return useMemo(
    () =>
      shown.filter((name) => coarse.has(name)).map((name) => {
        const parts = { analysis, name, trace: traceOf(name, coarse, finer), whole, bands, window };
        return { name, spec: signalSpec(parts), dataOf: (window: Window) => signalCsv(parts, coarse, window) };
      }),
    [analysis, coarse, finer, bands, shown.join(), whole[0], whole[1], window?.[0], window?.[1]],
  );
}

const STEPS = [
  ["slip_steps", "slip"],
  ["stick_steps", "stick"],
  ["open_steps", "open"],
  ["reversed_steps", "reversed"],
] as const;

/** How many steps the contact was in each state: the states themselves are not stored. */
function Steps(analysis: StudyAnalysis) {
  const told = STEPS.filter(([name]) => typeof analysis.scalars[name] === "number");
  if (told.length === 0) return null;
  return (
    <span class="march-steps">
      Steps of contact:{" "}
      {told.map(([name, words], index) => (
        <span key={name}>
          {index > 0 ? ", " : ""}
          {words} <span data-key={`${analysis.name}.${name}`}>{String(analysis.scalars[name])}</span>
        </span>
      ))}
    </span>
  );
}
