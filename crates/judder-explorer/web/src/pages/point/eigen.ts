/** Eigenvalues in the complex plane: modes, their path along a key, and their trail. */

import { classOf } from "../../chart/palette";
import { type Range, rangeOf } from "../../chart/scale";
import type { Axis, ChartSpec, Layer, LineLayer, PointsLayer } from "../../chart/spec";
import type { Pair } from "../../wire/api";

/** Eigenvalues that belong together: a conjugate pair, or one real value. */
export interface Mode {
  readonly name: string;
  /** The one with the positive frequency. */
  readonly value: Pair;
  readonly oscillates: boolean;
  /** Its place among the eigenvalues as they came. */
  readonly index: number;
}

/** Frequencies below this share of the magnitude are rounding. */
const REAL = 1e-9;

/** Modes from the lowest frequency to the highest, real ones first by their growth. */
export function modesOf(eigenvalues: readonly Pair[]): readonly Mode[] {
  const found = eigenvalues
    .map((value, index) => ({ value, index, oscillates: Math.abs(value[1]) > REAL * Math.hypot(...value) }))
    .filter(({ value, oscillates }) => !oscillates || value[1] > 0)
    .sort((a, b) => (a.oscillates && b.oscillates ? a.value[1] - b.value[1] : a.oscillates !== b.oscillates ? (a.oscillates ? 1 : -1) : b.value[0] - a.value[0]));
  return found.map((mode, index) => ({ ...mode, name: `mode ${index + 1}` }));
}

export interface Path {
  /** Values of the key. */
  readonly along: Float64Array;
  /** One line an eigenvalue. */
  readonly lines: readonly { readonly re: Float64Array; readonly im: Float64Array }[];
}

/** Orders of `n` things. */
function orders(n: number): readonly (readonly number[])[] {
  if (n === 0) return [[]];
  return orders(n - 1).flatMap((order) => Array.from({ length: n }, (_, at) => [...order.slice(0, at), n - 1, ...order.slice(at)]));
}

/** Joins eigenvalues (real and imaginary parts in turn, `count` a row) to lines: in all as near to the row before as can be. */
export function joined(along: Float64Array, data: Float64Array, count: number): Path {
  const lines = Array.from({ length: count }, () => ({ re: new Float64Array(along.length), im: new Float64Array(along.length) }));
  const possible = orders(count);
  let last: readonly Pair[] | undefined;
  for (let row = 0; row < along.length; row += 1) {
    const values = Array.from({ length: count }, (_, i): Pair => [data[2 * (row * count + i)] as number, data[2 * (row * count + i) + 1] as number]);
    const before = last;
    const order = before ? nearestOrder(possible, before, values) : (possible[0] as readonly number[]);
    last = order.map((i) => values[i] as Pair);
    last.forEach(([re, im], i) => {
      (lines[i] as { re: Float64Array }).re[row] = re;
      (lines[i] as { im: Float64Array }).im[row] = im;
    });
  }
  return { along, lines };
}

function nearestOrder(possible: readonly (readonly number[])[], before: readonly Pair[], values: readonly Pair[]): readonly number[] {
  // square roots of sums: `Math.hypot` takes several times as long, and this runs at every step of a drag
  const away = values.map((a) => before.map((b) => Math.sqrt((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2)));
  let [best, least] = [possible[0] as readonly number[], Number.POSITIVE_INFINITY];
  for (const order of possible) {
    let cost = 0;
    for (let place = 0; place < order.length; place += 1) cost += away[order[place] as number]?.[place] as number;
    if (cost < least) [best, least] = [order, cost];
  }
  return best;
}

/** The growth rate along the path: the largest real part. */
export function growthAlong(path: Path): Float64Array {
  return path.along.map((_, row) => Math.max(...path.lines.map((line) => line.re[row] as number)));
}

/** Beyond all that is shown. */
const FAR = 1e200;
/** A path is shown as far as so many magnitudes of the present eigenvalues. */
const PATH_REACH = 3;

export interface EigenParts {
  readonly modes: readonly Mode[];
  /** Sets of eigenvalues from the oldest to the newest. */
  readonly trail: readonly (readonly Pair[])[];
  readonly path: Path | null;
  readonly pathName: string;
  /** The header of the path's key in exported data. */
  readonly alongName: string;
}

export function eigenSpec({ modes, trail, path, pathName, alongName }: EigenParts): ChartSpec {
  const both = modes.map((mode): Pair[] => (mode.oscillates ? [mode.value, [mode.value[0], -mode.value[1]]] : [mode.value]));
  const layers: Layer[] = [
    { kind: "bands", label: "stable half-plane", from: [-FAR], to: [0], style: classOf("stable"), scenery: true },
    { kind: "rule", label: "", across: "y", at: 0, role: "reference" },
    { kind: "rule", label: "", across: "x", at: 0, role: "full-boundary" },
  ];
  if (path) {
    layers.push(...pathLayers(path, pathName, alongName));
    const [re, im] = [path.lines.map((line) => line.re[0] as number), path.lines.map((line) => line.im[0] as number)];
    layers.push({ kind: "points", label: "its start", x: re, y: im, role: { series: 4 }, hollow: true, size: 7, scenery: true });
  }
  layers.push(...trailLayers(trail));
  modes.forEach((mode, i) => {
    const points = both[i] ?? [];
    const label = mode.oscillates ? mode.name : `${mode.name} (real)`;
    layers.push({ kind: "points", label, x: points.map(([re]) => re), y: points.map(([, im]) => im), role: { mode: i }, size: 11 });
  });
  const ranges = planeRange([...both.flat(), ...trail.flat()], path);
  return {
    title: "Eigenvalues",
    x: axis("Growth rate Re $λ$/$ω_{nx}$", ranges.x),
    y: axis("Frequency Im $λ$/$ω_{nx}$", ranges.y),
    layers,
  };
}

/** One line in the legend, and a name for each in data. */
function pathLayers({ along, lines }: Path, label: string, alongName: string): LineLayer[] {
  return lines.map(({ re, im }, i) => ({
    kind: "line",
    label: i === 0 ? label : "",
    name: `${label}: eigenvalue ${i + 1}`,
    x: re,
    y: im,
    role: { series: 4 },
    dash: "solid",
    along: { name: alongName, values: along },
  }));
}

const axis = (label: string, range: Range): Axis => ({ label, scale: "linear", range });

/** Room for the eigenvalues, their trail, the origin, and of the path what is not far beyond them. */
function planeRange(points: readonly Pair[], path: Path | null): { x: Range; y: Range } {
  const reach = PATH_REACH * Math.max(...points.map(([re, im]) => Math.hypot(re, im)), 1e-12);
  const near = (values: Float64Array) => values.filter((value) => Math.abs(value) <= reach);
  const re = [points.map(([re]) => re), [0], ...(path?.lines.map((line) => near(line.re)) ?? [])];
  const im = [points.map(([, im]) => im), [0], ...(path?.lines.map((line) => near(line.im)) ?? [])];
  const [x, y] = [rangeOf("linear", re, 0.08), rangeOf("linear", im, 0.08)];
  // both half-planes are always in sight
  const edge = 0.12 * (x[1] - x[0]);
  return { x: [Math.min(x[0], -edge), Math.max(x[1], edge)], y };
}

const AGES = 4;

/** Where eigenvalues were: the older the smaller. */
function trailLayers(trail: readonly (readonly Pair[])[]): PointsLayer[] {
  return Array.from({ length: AGES }, (_, age): PointsLayer => {
    const part = trail.slice(Math.floor((age * trail.length) / AGES), Math.floor(((age + 1) * trail.length) / AGES)).flat();
    return { kind: "points", label: age === AGES - 1 ? "before" : "", name: "before", x: part.map(([re]) => re), y: part.map(([, im]) => im), role: "reference", size: 3 + age };
  }).filter((layer) => layer.x.length > 0);
}

/** Growth rate over the key of the path, with the present value. */
export function growthSpec(path: Path, axis: Axis, now: number | null): ChartSpec {
  const growth = growthAlong(path);
  const layers: Layer[] = [
    { kind: "rule", label: "", across: "y", at: 0, role: "full-boundary" },
    { kind: "line", label: "growth rate", x: path.along, y: growth, role: { series: 0 } },
  ];
  if (now !== null) layers.push({ kind: "rule", label: "present value", across: "x", at: now, role: "decoupled-boundary" });
  return { title: "Growth rate along the key", x: axis, y: { label: "max Re $λ$/$ω_{nx}$", scale: "linear" }, layers };
}
