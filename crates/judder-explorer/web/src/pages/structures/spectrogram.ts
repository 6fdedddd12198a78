/** Levels over time and frequency, with the zones of the locus over them. */

import { chartCsv } from "../../chart/csv";
import type { Range, Window } from "../../chart/scale";
import type { ChartSpec, Layer } from "../../chart/spec";
import { type Motion, passed } from "./motion";
import { type StudyAnalysis, attribute, axisLabel, variable } from "./study";
import { checkExported } from "./thinning";
import { type Arrays, numbers } from "./useArrays";

export type Over = "time" | "position";

export const SPECTROGRAM = ["time", "frequency", "level"] as const;
const OPTIONAL = ["position", "zone_from", "zone_to", "zone_frequency"] as const;

export function spectrogramVariables(analysis: StudyAnalysis): readonly string[] {
  return [...SPECTROGRAM, ...OPTIONAL.filter((name) => variable(analysis, name))];
}

/** Levels that are shown below the highest where the case does not say, dB. */
const SHOWN = 80;
/** Frequencies that are shown at first beside zones, over the highest of theirs. */
const ABOVE_ZONES = 1.5;
/** Half the height of the outline of a zone, as a share of the frequencies that are shown. */
const HALF = 0.02;
/** Columns of the drawn map; each holds the highest levels in it. */
const COLUMNS = 800;

export interface Levels {
  readonly motion: Motion;
  readonly frequency: Float64Array;
  /** Columns of the map: times or positions. */
  readonly time: Float64Array;
  readonly position: Float64Array;
  /** dB, a row a frequency; the highest of `group` times in each column. */
  readonly values: Float64Array;
  readonly group: number;
  /** dB, a row a time, as stored. */
  readonly stored: Float64Array;
  readonly range: Range;
  readonly zones: readonly { readonly from: number; readonly to: number; readonly frequency: number }[];
}

export function readLevels(analysis: StudyAnalysis, arrays: Arrays): Levels | null {
  const [time, frequency, level] = SPECTROGRAM.map((name) => numbers(arrays, name)) as [Float64Array, Float64Array, Float64Array];
  if (time.length === 0 || level.length !== time.length * frequency.length) return null;
  const position = numbers(arrays, "position");
  const group = Math.max(Math.ceil(time.length / COLUMNS), 1);
  const columns = Math.ceil(time.length / group);
  const values = highestOf(level, time.length, frequency.length, group);
  const highest = level.reduce((most, value) => (value > most ? value : most), Number.NEGATIVE_INFINITY);
  const stated = analysis.attributes["range_db"];
  const range: Range = Array.isArray(stated) && Number(stated[0]) < Number(stated[1]) ? [Number(stated[0]), Number(stated[1])] : [highest - SHOWN, highest];
  const middle = (values: Float64Array) =>
    Float64Array.from({ length: values.length === 0 ? 0 : columns }, (_, k) => ((values[k * group] as number) + (values[Math.min((k + 1) * group, values.length) - 1] as number)) / 2);
  const [from, to, at] = [numbers(arrays, "zone_from"), numbers(arrays, "zone_to"), numbers(arrays, "zone_frequency")];
  const zones = Array.from(from, (start, i) => ({ from: Math.min(start, to[i] as number), to: Math.max(start, to[i] as number), frequency: at[i] as number }));
  return { motion: { time, position }, frequency, time: middle(time), position: middle(position), values, group, stored: level, range, zones };
}

/** The highest level of every column at every frequency, frequencies as rows. */
export function highestOf(level: Float64Array, times: number, frequencies: number, group: number): Float64Array {
  const columns = Math.ceil(times / group);
  const values = new Float64Array(columns * frequencies).fill(Number.NEGATIVE_INFINITY);
  for (let t = 0; t < times; t += 1) {
    const column = Math.floor(t / group);
    for (let f = 0; f < frequencies; f += 1) {
      const value = level[t * frequencies + f] as number;
      if (value > (values[f * columns + column] as number)) values[f * columns + column] = value;
    }
  }
  return values;
}

/** Rectangles about the zones, what grows in them left in sight. */
export function outlines(levels: Levels, over: Over, half: number): { x: number[]; y: number[] } {
  const [x, y]: [number[], number[]] = [[], []];
  for (const zone of levels.zones) {
    const times = passed(levels.motion, zone.from, zone.to);
    if (!times) continue;
    const [from, to] = over === "time" ? times : [zone.from, zone.to];
    const [below, above] = [zone.frequency - half, zone.frequency + half];
    x.push(from, from, to, to, from, Number.NaN);
    y.push(below, above, above, below, below, Number.NaN);
  }
  return { x, y };
}

/** What is said of the map; nothing where every time has a column. */
export function toldOfLevels({ group }: Levels): string | undefined {
  return group > 1 ? `Of each ${group} times the highest level is drawn; the CSV has every time that is in sight.` : undefined;
}

/** The levels as stored, of the times and frequencies within a window. */
export function levelsCsv(spec: ChartSpec, levels: Levels, over: Over, window: Window): string {
  const within = (values: Float64Array, [low, high]: Range) => Array.from(values.keys()).filter((i) => (values[i] as number) >= low && (values[i] as number) <= high);
  const along = levels.motion[over];
  const [columns, rows] = [within(along, window.x), within(levels.frequency, window.y)];
  checkExported(columns.length, rows.length);
  const count = levels.frequency.length;
  const seen = {
    x: columns.map((t) => along[t] as number),
    y: rows.map((f) => levels.frequency[f] as number),
    values: rows.flatMap((f) => columns.map((t) => levels.stored[t * count + f] as number)),
  };
  return chartCsv({ ...spec, layers: spec.layers.map((layer) => (layer.kind === "values" ? { ...layer, ...seen } : layer)) });
}

export function spectrogramSpec(analysis: StudyAnalysis, levels: Levels, over: Over): ChartSpec {
  const along = variable(analysis, over);
  const [frequency, level] = [variable(analysis, "frequency"), variable(analysis, "level")];
  const top = levels.frequency.at(-1) ?? 1;
  const highest = levels.zones.reduce((most, zone) => Math.max(most, zone.frequency), 0);
  const shown = highest > 0 ? Math.min(ABOVE_ZONES * highest, top) : top;
  const number = (name: string) => (typeof analysis.scalars[name] === "number" ? (analysis.scalars[name] as number) : Number.NaN);
  const peak = { x: number(over === "time" ? "peak_time_s" : "peak_position_m"), y: number("peak_frequency_hz") };
  const layers: Layer[] = [
    {
      kind: "values",
      label: level ? axisLabel(level) : "Level (dB)",
      x: levels[over],
      y: levels.frequency,
      values: levels.values,
      colours: "sequential",
      scale: "linear",
      range: levels.range,
    },
  ];
  const locus = attribute(analysis, "locus");
  const frames = outlines(levels, over, HALF * shown);
  if (frames.x.length > 0) layers.push({ kind: "line", label: `unstable zones of ${locus ?? "the locus"}`, ...frames, role: { series: 1 }, dash: "solid" });
  if (Number.isFinite(peak.x + peak.y)) layers.push({ kind: "points", label: "peak", x: [peak.x], y: [peak.y], role: "decoupled-boundary", size: 13, hollow: true });
  return {
    title: `Levels of ${attribute(analysis, "signal") ?? "the signal"} in ${attribute(analysis, "of") ?? analysis.name}`,
    x: { label: along ? axisLabel(along) : over, scale: "linear" },
    y: { label: frequency ? axisLabel(frequency) : "Frequency (Hz)", scale: "linear", range: [levels.frequency[0] ?? 0, shown] },
    layers,
  };
}
