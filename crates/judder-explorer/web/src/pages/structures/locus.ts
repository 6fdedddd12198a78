/** Eigenvalues over a position or a key: what they say, and their charts. */

import { UNSTABLE_ZONE } from "../../chart/palette";
import { brief } from "../../chart/readout";
import { apart } from "../../chart/runs";
import type { Axis, BandsLayer, ChartSpec, Layer, LineLayer, PointsLayer } from "../../chart/spec";
import { type Arrays, numbers } from "./useArrays";
import { type StudyAnalysis, axisLabel, hasVariables, variable } from "./study";
import { verdictOf, verdictsOf } from "./verdicts";

export interface Zone {
  readonly from: number;
  readonly to: number;
  /** Where it grows fastest. */
  readonly peak: number;
  readonly frequency: number;
  readonly growth: number;
  /** How far the growth rate may be off; null where the study does not say. */
  readonly error: number | null;
}

export interface Locus {
  /** What the eigenvalues are over. */
  readonly axis: Axis;
  readonly unit: string;
  readonly along: Float64Array;
  readonly branches: number;
  /** Growth rates in 1/s, a row a value, NaN where a branch is not. */
  readonly growth: Float64Array;
  /** Frequencies in Hz. */
  readonly frequency: Float64Array;
  /** What the study says of every eigenvalue; empty where it says nothing. */
  readonly verdicts: readonly string[];
  readonly zones: readonly Zone[];
}

const ZONE_ARRAYS = ["zone_from", "zone_to", "zone_peak", "zone_frequency", "zone_growth_rate"] as const;

/** What has to be asked for. */
export function locusVariables(analysis: StudyAnalysis): readonly string[] {
  const along = variable(analysis, "eigenvalue")?.dimensions[0] ?? "";
  return ["eigenvalue", along, ...(variable(analysis, "verdict") ? ["verdict"] : []), ...(hasVariables(analysis, ...ZONE_ARRAYS) ? ZONE_ARRAYS : []), ...(variable(analysis, "zone_error") ? ["zone_error"] : [])];
}

export function readLocus(analysis: StudyAnalysis, arrays: Arrays): Locus | null {
  const eigenvalue = arrays.get("eigenvalue");
  const name = eigenvalue?.dimensions[0] ?? "";
  const coordinate = variable(analysis, name);
  if (!eigenvalue || !coordinate || eigenvalue.shape.length !== 2) return null;
  const pairs = numbers(arrays, "eigenvalue");
  const count = pairs.length / 2;
  const growth = Float64Array.from({ length: count }, (_, i) => pairs[2 * i] as number);
  const frequency = Float64Array.from({ length: count }, (_, i) => (pairs[2 * i + 1] as number) / (2 * Math.PI));
  const [from, to, peak, at, rate] = ZONE_ARRAYS.map((name) => numbers(arrays, name)) as [Float64Array, Float64Array, Float64Array, Float64Array, Float64Array];
  const error = numbers(arrays, "zone_error");
  const zones = Array.from(from, (start, i) => ({
    from: start,
    to: to[i] as number,
    peak: peak[i] as number,
    frequency: at[i] as number,
    growth: rate[i] as number,
    error: error[i] ?? null,
  }));
  return {
    axis: { label: axisLabel(coordinate), scale: arrays.get(name)?.attributes["scale"] === "log" ? "log" : "linear" },
    unit: coordinate.units ?? "1",
    along: numbers(arrays, name),
    branches: eigenvalue.shape[1] as number,
    growth,
    frequency,
    verdicts: verdictsOf(arrays),
    zones,
  };
}

export interface Mode {
  readonly branch: number;
  readonly growth: number;
  readonly frequency: number;
  readonly verdict: string | undefined;
}

/** The number of the value that is nearest. */
export function rowAt(locus: Locus, at: number): number {
  let best = 0;
  for (let i = 1; i < locus.along.length; i += 1) {
    if (Math.abs((locus.along[i] as number) - at) < Math.abs((locus.along[best] as number) - at)) best = i;
  }
  return best;
}

/** The eigenvalues at the stored value that is nearest. */
export function modesAt(locus: Locus, at: number): readonly Mode[] {
  const row = rowAt(locus, at);
  return Array.from({ length: locus.branches }, (_, branch) => {
    const index = row * locus.branches + branch;
    return { branch, growth: locus.growth[index] as number, frequency: locus.frequency[index] as number, verdict: locus.verdicts[index] };
  }).filter((mode) => Number.isFinite(mode.growth) && Number.isFinite(mode.frequency));
}

/** Where to look first: the fastest growth. */
export function homePlace(locus: Locus): number {
  const loudest = locus.zones.reduce<Zone | null>((best, zone) => (best && best.growth >= zone.growth ? best : zone), null);
  if (loudest) return loudest.peak;
  let best = 0;
  for (let i = 0; i < locus.growth.length; i += 1) if ((locus.growth[i] as number) > (locus.growth[best] as number)) best = i;
  return locus.along[Math.floor(best / Math.max(locus.branches, 1))] ?? 0;
}

/** Half the height of the frame of a zone at its frequency, as a share of the frequencies that are shown. */
const HALF = 0.02;
/** What an even axis of growth rates shows below zero and above, over the fastest growth. */
const [BELOW, ABOVE] = [0.25, 1.1];

function zoneBands(zones: readonly Zone[]): BandsLayer[] {
  if (zones.length === 0) return [];
  return [{ kind: "bands", label: "unstable zone", from: zones.map((zone) => zone.from), to: zones.map((zone) => zone.to), style: UNSTABLE_ZONE }];
}

/** A frame about every zone at its frequency. */
function zoneFrames(zones: readonly Zone[], half: number): LineLayer[] {
  if (zones.length === 0) return [];
  const frames = zones.map(({ from, to, frequency: at }) => ({ x: [from, from, to, to, from], y: [at - half, at + half, at + half, at - half, at - half] }));
  return [{ kind: "line", label: "its frequency", ...apart(frames), role: { series: 1 }, dash: "solid" }];
}

/** One line a branch over the rows from the first to before the last, as one line with gaps. */
function branchLines(locus: Locus, [first, last]: readonly [number, number], across: (row: number, index: number) => number, up: Float64Array) {
  const rows = Array.from({ length: last - first }, (_, k) => first + k);
  const branches = Array.from({ length: locus.branches }, (_, branch) => rows.map((row) => [row, row * locus.branches + branch] as const));
  return apart(branches.map((places) => ({ x: places.map(([row, index]) => across(row, index)), y: places.map(([, index]) => up[index] as number) })));
}

/** The branches over the values. */
function branchLine(locus: Locus, values: Float64Array, label: string): LineLayer {
  const lines = branchLines(locus, [0, locus.along.length], (row) => locus.along[row] as number, values);
  return { kind: "line", label, ...lines, role: { series: 0 } };
}

/** Where a branch is at one value alone: its line does not show it. */
function lonePoints(locus: Locus, values: Float64Array): PointsLayer[] {
  const isThere = (row: number, branch: number) => row >= 0 && row < locus.along.length && Number.isFinite(values[row * locus.branches + branch]);
  const [x, y]: [number[], number[]] = [[], []];
  locus.along.forEach((at, row) => {
    for (let branch = 0; branch < locus.branches; branch += 1) {
      if (!isThere(row, branch) || isThere(row - 1, branch) || isThere(row + 1, branch)) continue;
      x.push(at);
      y.push(values[row * locus.branches + branch] as number);
    }
  });
  return x.length === 0 ? [] : [{ kind: "points", label: "branches at one value alone", x, y, role: { series: 0 }, size: 4 }];
}

/** Upper ends of classes of growth rates, 1/s: 1, 3, 10, 30 … that split the largest one well. */
export function growthClasses(largest: number): readonly number[] {
  if (!(largest > 0)) return [];
  const power = Math.floor(Math.log10(largest));
  const steps = [power - 1, power, power + 1].flatMap((power) => [Number(`1e${power}`), Number(`3e${power}`)]);
  const top = steps.findIndex((step) => step >= largest);
  return steps.slice(Math.max(top - 3, 0), top + 1);
}

/** Unstable points in classes: the faster they grow, the larger and the further along the colours. */
function growthPoints(locus: Locus): PointsLayer[] {
  const largest = locus.growth.reduce((most, growth) => (growth > most ? growth : most), 0);
  const classes = growthClasses(largest);
  return classes.map((end, k): PointsLayer => {
    const start = k === 0 ? 0 : (classes[k - 1] as number);
    const [x, y]: [number[], number[]] = [[], []];
    locus.growth.forEach((growth, index) => {
      if (!(growth > start && growth <= end) || verdictOf(growth, locus.verdicts[index]) !== "unstable") return;
      x.push(locus.along[Math.floor(index / locus.branches)] as number);
      y.push(locus.frequency[index] as number);
    });
    const label = k === 0 ? `grows by up to ${end} s^{−1}` : `${start} … ${end} s^{−1}`;
    return { kind: "points", label, x, y, role: { graded: classes.length - 1 - k, of: classes.length }, size: 4 + 2 * k };
  }).filter((layer) => layer.x.length > 0);
}

function highest(values: Float64Array): number {
  return values.reduce((most, value) => (value > most ? value : most), 0);
}

function zonePeaks(zones: readonly Zone[]): PointsLayer[] {
  if (zones.length === 0) return [];
  return [{ kind: "points", label: "fastest growth of a zone", x: zones.map((zone) => zone.peak), y: zones.map((zone) => zone.growth), role: { series: 1 }, size: 8, hollow: true }];
}

export function frequencySpec(locus: Locus, name: string): ChartSpec {
  return {
    title: `Frequencies of ${name}`,
    x: { ...locus.axis, range: ends(locus.along) },
    y: { label: "Frequency (Hz)", scale: "linear" },
    layers: [
      ...zoneBands(locus.zones),
      branchLine(locus, locus.frequency, "branches"),
      ...lonePoints(locus, locus.frequency),
      ...growthPoints(locus),
      ...zoneFrames(locus.zones, HALF * highest(locus.frequency)),
    ],
  };
}

export function growthSpec(locus: Locus, name: string): ChartSpec {
  const most = highest(locus.growth);
  return {
    title: `Growth rates of ${name}`,
    x: { ...locus.axis, range: ends(locus.along) },
    y: { label: "Growth rate Re $λ$ (s^{−1})", scale: "linear", ...(most > 0 ? { range: [-BELOW * most, ABOVE * most] as const } : {}) },
    layers: [
      ...zoneBands(locus.zones),
      { kind: "rule", label: "", across: "y", at: 0, role: "reference" },
      branchLine(locus, locus.growth, "branches"),
      ...lonePoints(locus, locus.growth),
      ...zonePeaks(locus.zones),
    ],
  };
}

/** Shades of the path in the complex plane. */
const SHADES = 8;

/** The complex plane, shaded along the way; the eigenvalues at the place are marked. */
export function planeSpec(locus: Locus, name: string, at: number): ChartSpec {
  const most = highest(locus.growth);
  const rows = locus.along.length;
  const shades = Math.min(SHADES, Math.max(rows - 1, 1));
  const paths = Array.from({ length: shades }, (_, shade): LineLayer => {
    const [first, last] = [Math.round((shade * (rows - 1)) / shades), Math.round(((shade + 1) * (rows - 1)) / shades)];
    const label = `${short(locus.along[first] as number)} … ${short(locus.along[last] as number)}${locus.unit === "1" ? "" : ` ${locus.unit}`}`;
    const lines = branchLines(locus, [first, last + 1], (_, index) => locus.growth[index] as number, locus.frequency);
    return { kind: "line", label, ...lines, role: { graded: shade, of: shades } };
  });
  const start = modesAt(locus, locus.along[0] ?? 0);
  const here = modesAt(locus, at);
  const points = (modes: readonly Mode[]) => ({ x: modes.map((mode) => mode.growth), y: modes.map((mode) => mode.frequency) });
  const layers: Layer[] = [
    { kind: "rule", label: "", across: "x", at: 0, role: "full-boundary" },
    ...paths,
    { kind: "points", label: "start", ...points(start), role: "reference", size: 5, hollow: true },
    { kind: "points", label: "at the cursor", ...points(here), role: "decoupled-boundary", size: 9, hollow: true },
  ];
  return {
    title: `Complex plane of ${name}`,
    x: { label: "Growth rate Re $λ$ (s^{−1})", scale: "linear", ...(most > 0 ? { range: [-BELOW * 4 * most, ABOVE * most] as const } : {}) },
    y: { label: "Frequency Im $λ$/2π (Hz)", scale: "linear" },
    layers,
  };
}

/** The value at the eigenvalue that lies nearest to a place of the plane, in shares of what is shown. */
export function valueNear(locus: Locus, growth: number, frequency: number, width: number, height: number): number {
  let [best, distance] = [0, Number.POSITIVE_INFINITY];
  for (let i = 0; i < locus.growth.length; i += 1) {
    const away = Math.hypot(((locus.growth[i] as number) - growth) / width, ((locus.frequency[i] as number) - frequency) / height);
    if (away < distance) [best, distance] = [i, away];
  }
  return locus.along[Math.floor(best / locus.branches)] ?? 0;
}

function ends(values: Float64Array): readonly [number, number] {
  const [first, last] = [values[0] ?? 0, values.at(-1) ?? 1];
  return first < last ? [first, last] : first > last ? [last, first] : [first - 0.5, first + 0.5];
}

/** A number in three digits. */
export function short(value: number): string {
  return brief(value, 3);
}
