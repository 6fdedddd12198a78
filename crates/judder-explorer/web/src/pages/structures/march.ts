/** The signals of a march, and their charts. */

import { chartCsv } from "../../chart/csv";
import { UNSTABLE_ZONE } from "../../chart/palette";
import { type Range, type Window, rangeOf } from "../../chart/scale";
import type { BandsLayer, ChartSpec } from "../../chart/spec";
import { type Motion, passed } from "./motion";
import { type StudyAnalysis, type StudyVariable, attribute, axisLabel, variable } from "./study";
import { checkExported, fetchRows, inSight, rowsWithin, thinningOf, toldOf } from "./thinning";
import { type Arrays, type Part, numbers } from "./useArrays";

/** Values of a signal that are asked for at once: some for every pixel. */
export const MOST = 4000;

export interface Burst {
  readonly position_m: number;
  readonly time_s: number;
  readonly frequency_hz: number;
  readonly peak: number;
  readonly duration_s: number;
  readonly measured_amplification: number | null;
  readonly expected_amplification: number | null;
}

export interface MarchZone {
  readonly from_m: number;
  readonly to_m: number;
}

/** What is stored over time, beside time and position themselves. */
export function signalsOf(analysis: StudyAnalysis): readonly StudyVariable[] {
  const own = (one: StudyVariable) => one.dimensions.length === 1 && one.dimensions[0] === "time";
  return analysis.variables.filter((one) => own(one) && one.name !== "time" && one.name !== "position");
}

const FIRST = ["normal_force", "sliding_velocity"];

/** The signals of the view; at first the one that the case names, the normal force and the velocity. */
export function shownSignals(analysis: StudyAnalysis, text: string | undefined): readonly string[] {
  const names = signalsOf(analysis).map((signal) => signal.name);
  const wanted = text === undefined ? [attribute(analysis, "signal") ?? names[0] ?? "", ...FIRST] : text.split(",");
  return [...new Set(wanted)].filter((name) => names.includes(name));
}

export function tablesOf<T>(analysis: StudyAnalysis, name: string): readonly T[] {
  const value = analysis.scalars[name];
  return Array.isArray(value) ? (value as readonly T[]) : [];
}

/** The numbers of the samples within a window of times, with one beyond each end; the whole where nearly all is shown. */
export function partOf(window: Range | undefined, whole: Range, count: number): Part {
  const length = whole[1] - whole[0];
  const seen = window ? Math.min(window[1], whole[1]) - Math.max(window[0], whole[0]) : length;
  if (!window || count < 2 || !(seen > 0) || seen > 0.9 * length) return { most: MOST };
  const index = (time: number) => ((time - whole[0]) / length) * (count - 1);
  const from = Math.min(Math.max(Math.floor(index(window[0])) - 1, 0), count - 1);
  const to = Math.min(Math.max(Math.ceil(index(window[1])) + 2, from + 1), count);
  return { from, to, most: MOST };
}

export interface Trace {
  readonly x: ArrayLike<number>;
  readonly y: ArrayLike<number>;
}

/** A signal: finer where finer values are known. */
export function traceOf(name: string, coarse: Arrays, fine: Arrays | null): Trace {
  const [x, y] = [numbers(coarse, "time"), numbers(coarse, name)];
  const [fineX, fineY] = [numbers(fine, "time"), numbers(fine, name)];
  if (fineX.length === 0 || fineY.length !== fineX.length) return { x, y };
  const [first, last] = [fineX[0] as number, fineX.at(-1) as number];
  const before = x.findIndex((time) => time >= first);
  const after = x.findIndex((time) => time > last);
  const [head, tail] = [before < 0 ? x.length : before, after < 0 ? x.length : after];
  const joined = (coarse: Float64Array, fine: Float64Array) => Float64Array.from([...coarse.subarray(0, head), ...fine, ...coarse.subarray(tail)]);
  return { x: joined(x, fineX), y: joined(y, fineY) };
}

/** Unstable zones of a locus as stretches of time. */
export function zoneTimes(zones: readonly MarchZone[], motion: Motion): BandsLayer[] {
  const times = zones.flatMap((zone) => {
    const found = passed(motion, Math.min(zone.from_m, zone.to_m), Math.max(zone.from_m, zone.to_m));
    return found ? [found] : [];
  });
  if (times.length === 0) return [];
  return [{ kind: "bands", label: "in an unstable zone", from: times.map(([from]) => from), to: times.map(([, to]) => to), style: UNSTABLE_ZONE }];
}

export interface SignalParts {
  readonly analysis: StudyAnalysis;
  readonly name: string;
  readonly trace: Trace;
  readonly whole: Range;
  readonly bands: readonly BandsLayer[];
  /** The times that are shown, whose values fill the height; left out, all of them. */
  readonly window: Range | undefined;
}

/** The range of the values within a window; undefined where there are none. */
export function rangeWithin({ x, y }: Trace, window: Range): Range | undefined {
  const kept = Array.from({ length: x.length }, (_, i) => i).filter((i) => (x[i] as number) >= window[0] && (x[i] as number) <= window[1]);
  return kept.length < 2 ? undefined : rangeOf("linear", [kept.map((i) => y[i] as number)], 0.06);
}

/** The samples themselves within a window of the chart of a signal. */
export async function signalCsv(parts: SignalParts, coarse: Arrays, window: Window): Promise<string> {
  const { analysis, name } = parts;
  const thinning = thinningOf({ most: MOST }, variable(analysis, "time")?.shape[0] ?? 0);
  if (!thinning) return chartCsv(inSight(signalSpec(parts), window));
  const rows = rowsWithin(thinning, numbers(coarse, "time"), window.x);
  checkExported(rows.to - rows.from, 1);
  const arrays = await fetchRows(analysis.name, ["time", name], rows);
  return chartCsv(inSight(signalSpec({ ...parts, trace: traceOf(name, arrays, null) }), window));
}

/** What is said of the curves: of which samples they are the extremes; nothing where they are the samples themselves. */
export function toldOfSignals(analysis: StudyAnalysis, fine: Part | null): string | undefined {
  const thinning = thinningOf(fine ?? { most: MOST }, variable(analysis, "time")?.shape[0] ?? 0);
  return thinning ? toldOf(thinning) : undefined;
}

export function signalSpec({ analysis, name, trace, whole, bands, window }: SignalParts): ChartSpec {
  const own = variable(analysis, name);
  const time = variable(analysis, "time");
  const bursts = name === attribute(analysis, "signal") ? tablesOf<Burst>(analysis, "bursts") : [];
  const range = window ? rangeWithin(trace, window) : undefined;
  const at = { x: bursts.map((burst) => burst.time_s), y: bursts.map((burst) => burst.peak) };
  return {
    title: `${analysis.name}: ${own?.long_name ?? name}`,
    x: { label: time ? axisLabel(time) : "Time (s)", scale: "linear", range: whole },
    y: { label: own ? axisLabel(own) : name, scale: "linear", ...(range ? { range } : {}) },
    layers: [
      ...bands,
      { kind: "line", label: "", ...trace, role: { series: 0 } },
      ...(bursts.length > 0 ? [{ kind: "points" as const, label: "peak of a burst", ...at, role: { series: 1 }, size: 9 }] : []),
    ],
  };
}
