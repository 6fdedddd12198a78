/** A body of points and lines that swings in a complex shape, and how it lies on the paper. */

import { table } from "../../chart/csv";
import { plainText } from "../../chart/markup";
import type { ChartSpec, Layer } from "../../chart/spec";
import type { Look } from "./state";

export interface Body {
  /** Places at rest, m, three numbers a point: x to the right, y upwards, z towards who looks. */
  readonly points: Float64Array;
  /** The numbers of the nodes; counted from 1 where the study does not say. */
  readonly nodes: Float64Array | null;
  /** Pairs of points. */
  readonly lines: Uint32Array;
  /** Pairs of points that show how it is meshed, where that is known. */
  readonly mesh: Uint32Array;
  /** Whether all points lie in one plane, which is looked at from the front. */
  readonly planar: boolean;
  /** The diagonal of the box about it, m. */
  readonly diagonal: number;
  readonly centre: readonly [number, number, number];
  /** The names of the bodies that it is made of; empty where it is one. */
  readonly parts: readonly string[];
  /** To which of them each point belongs. */
  readonly part: Uint16Array;
}

/** A displacement of every point, in the axes of the body: real and imaginary parts. */
export interface Swing {
  readonly real: Float64Array;
  readonly imaginary: Float64Array;
  /** The largest displacement that a point reaches, each of it between 0 and 1 of the largest of all. */
  readonly reach: Float64Array;
  /** What the largest displacement is in the unit of the shape. */
  readonly largest: number;
}

/** The largest displacement that is drawn at first, over the diagonal of the body. */
export const DISPLACEMENT = 0.08;

interface Known {
  /** The numbers of the nodes. */
  readonly nodes?: Float64Array;
  /** The body of each point. */
  readonly names?: readonly string[];
  /** Pairs of points. */
  readonly mesh?: ArrayLike<number>;
}

/** A body of the study's axes, and what else is known of it: in a plane y is upwards, in space z. */
export function bodyOf(places: Float64Array, lines: ArrayLike<number>, { nodes, names = [], mesh = [] }: Known = {}): Body {
  const count = places.length / 3;
  let planar = true;
  for (let i = 0; i < count && planar; i += 1) planar = places[3 * i + 2] === places[2];
  const points = turned(places, planar);
  const low = [0, 1, 2].map((axis) => extreme(points, axis, Math.min)) as [number, number, number];
  const high = [0, 1, 2].map((axis) => extreme(points, axis, Math.max)) as [number, number, number];
  const centre = [0, 1, 2].map((axis) => ((low[axis] as number) + (high[axis] as number)) / 2) as [number, number, number];
  const diagonal = Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  const inside = (ends: ArrayLike<number>) => (Array.from(ends).every((end) => end >= 0 && end < count) ? Uint32Array.from(ends) : new Uint32Array(0));
  const parts = names.length === count ? [...new Set(names)] : [];
  const index = new Map(parts.map((name, k) => [name, k]));
  const part = Uint16Array.from({ length: count }, (_, i) => index.get(names[i] ?? "") ?? 0);
  return { points, nodes: nodes?.length === count ? nodes : null, lines: inside(lines), mesh: inside(mesh), planar, diagonal, centre, parts, part };
}

/** Vectors of the study's axes in those of the body. */
export function turned(vectors: Float64Array, planar: boolean): Float64Array {
  if (planar) return Float64Array.from(vectors);
  const out = new Float64Array(vectors.length);
  for (let i = 0; i < vectors.length; i += 3) {
    out[i] = vectors[i] as number;
    out[i + 1] = vectors[i + 2] as number;
    out[i + 2] = -(vectors[i + 1] as number);
  }
  return out;
}

/** Vectors of the body's axes in those of the study. */
function turnedBack([x, y, z]: Vector, planar: boolean): Vector {
  return planar ? [x, y, z] : [x, -z, y];
}

/** The shape itself, in the axes of the study: every point at rest, and its complex displacement. */
export function bodyCsv(body: Body, { real, imaginary }: Swing, unit: string): string {
  const inUnit = unit === "" || unit === "1" ? "" : ` (${plainText(unit)})`;
  const displacements = ["x", "y", "z"].flatMap((axis) => [`Re u_${axis}${inUnit}`, `Im u_${axis}${inUnit}`]);
  const vectorAt = (values: Float64Array, i: number) => turnedBack([values[3 * i] as number, values[3 * i + 1] as number, values[3 * i + 2] as number], body.planar);
  const rows = Array.from({ length: body.points.length / 3 }, (_, i) => {
    const [re, im] = [vectorAt(real, i), vectorAt(imaginary, i)];
    const name = body.parts[body.part[i] as number];
    return [...(name === undefined ? [] : [name]), body.nodes?.[i] ?? i + 1, ...vectorAt(body.points, i), re[0], im[0], re[1], im[1], re[2], im[2]];
  });
  return table([...(body.parts.length > 0 ? ["body"] : []), body.nodes ? "node" : "point", "x (m)", "y (m)", "z (m)", ...displacements], rows);
}

function extreme(points: Float64Array, axis: number, pick: (a: number, b: number) => number): number {
  let found = points[axis] ?? 0;
  for (let i = axis; i < points.length; i += 3) found = pick(found, points[i] as number);
  return found;
}

/** A shape of the study: real numbers, or pairs of real and imaginary parts. */
export function swingOf(body: Body, shape: Float64Array, complex: boolean): Swing {
  const count = body.points.length;
  const part = (offset: number) => Float64Array.from({ length: count }, (_, i) => (complex ? (shape[2 * i + offset] ?? 0) : offset === 0 ? (shape[i] ?? 0) : 0));
  const real = turned(part(0), body.planar);
  const imaginary = turned(part(1), body.planar);
  const reach = new Float64Array(count / 3);
  let largest = 0;
  for (let i = 0; i < reach.length; i += 1) {
    reach[i] = ellipse(real, imaginary, i);
    largest = Math.max(largest, reach[i] as number);
  }
  if (largest > 0) reach.forEach((value, i) => (reach[i] = value / largest));
  return { real, imaginary, reach, largest };
}

/** The larger half axis of the ellipse on which a point swings. */
function ellipse(real: Float64Array, imaginary: Float64Array, point: number): number {
  let [rr, ii, ri] = [0, 0, 0];
  for (let k = 3 * point; k < 3 * point + 3; k += 1) {
    const [a, b] = [real[k] as number, imaginary[k] as number];
    rr += a * a;
    ii += b * b;
    ri += a * b;
  }
  return Math.sqrt((rr + ii) / 2 + Math.hypot((rr - ii) / 2, ri));
}

/** Where the points are at a phase: at rest plus `factor` Re(φ e^{i phase}). */
export function placesAt(body: Body, swing: Swing, phase: number, factor: number, out: Float32Array | Float64Array): void {
  const [c, s] = [factor * Math.cos(phase), factor * Math.sin(phase)];
  for (let i = 0; i < out.length; i += 1) {
    out[i] = (body.points[i] as number) + c * (swing.real[i] as number) - s * (swing.imaginary[i] as number);
  }
}

/** By how much a shape is drawn larger than its numbers, in m over the unit of the shape. */
export function drawnFactor(body: Body, swing: Swing, scale: number): number {
  return swing.largest > 0 ? (scale * DISPLACEMENT * body.diagonal) / swing.largest : 0;
}

export type Vector = readonly [number, number, number];

/** The directions of the paper: to the right, upwards, and towards who looks. */
export function basis({ azimuth, elevation }: Look): { readonly right: Vector; readonly up: Vector; readonly towards: Vector } {
  const [a, e] = [(azimuth * Math.PI) / 180, (elevation * Math.PI) / 180];
  const [ca, sa, ce, se] = [Math.cos(a), Math.sin(a), Math.cos(e), Math.sin(e)];
  return { right: [ca, 0, -sa], up: [-sa * se, ce, -ca * se], towards: [sa * ce, se, ca * ce] };
}

/** Points on the paper, about the middle of the body. */
export function projected(points: Float32Array | Float64Array, look: Look, centre: Vector): { x: Float64Array; y: Float64Array } {
  const { right, up } = basis(look);
  const count = points.length / 3;
  const [x, y] = [new Float64Array(count), new Float64Array(count)];
  for (let i = 0; i < count; i += 1) {
    const [a, b, c] = [0, 1, 2].map((k) => (points[3 * i + k] as number) - (centre[k] as number)) as [number, number, number];
    x[i] = a * right[0] + b * right[1] + c * right[2];
    y[i] = a * up[0] + b * up[1] + c * up[2];
  }
  return { x, y };
}

/** Classes of displacement among the lines of the projected picture. */
const CLASSES = 5;

/** The projected lines as a chart: what is exported, and what is shown where there is no WebGL. Under layers that lie over it the body is grey. */
export function bodySpec(title: string, body: Body, swing: Swing, look: Look, phase: number, factor: number, over: readonly Layer[] = []): ChartSpec {
  const moved = new Float64Array(body.points.length);
  placesAt(body, swing, phase, factor, moved);
  const rest = projected(body.points, look, body.centre);
  const now = projected(moved, look, body.centre);
  const layers: Layer[] = [];
  if (body.lines.length === 0) {
    layers.push({ kind: "points", label: "at rest", ...rest, role: "reference", size: 2 });
    layers.push({ kind: "points", label: "shape", ...now, role: { series: 0 }, size: 3 });
  } else {
    layers.push({ kind: "line", label: "at rest", ...segments(body.lines, rest, () => true), role: "reference", dash: "solid" });
    if (over.length > 0) layers.push(...partLayers(body, now));
    for (let k = 0; k < (over.length > 0 ? 0 : CLASSES); k += 1) {
      const within = (a: number, b: number) => classOf(swing, a, b) === k;
      const label = `${(k / CLASSES).toFixed(1)} … ${((k + 1) / CLASSES).toFixed(1)} of the largest`;
      layers.push({ kind: "line", label, ...segments(body.lines, now, within), role: { graded: k, of: CLASSES } });
    }
  }
  layers.push(...over);
  const half = 0.5 * body.diagonal * 1.04 + Math.abs(factor) * swing.largest;
  const extent = (values: Float64Array) => {
    const reach = values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
    return Math.min(reach + Math.abs(factor) * swing.largest, half) * 1.05 || 1;
  };
  const [across, high] = [extent(rest.x), extent(rest.y)];
  return {
    title,
    x: { label: "Across the picture (m)", scale: "linear", range: [-across, across] },
    y: { label: "Up (m)", scale: "linear", range: [-high, high] },
    layers,
    equal: true,
  };
}

/** The moved lines of each body in its grey. */
function partLayers(body: Body, now: { x: Float64Array; y: Float64Array }): Layer[] {
  const names = body.parts.length > 0 ? body.parts : ["moved"];
  return names.map((label, k) => ({ kind: "line", label, ...segments(body.lines, now, (a) => body.part[a] === k), role: { body: k, of: names.length } }));
}

function classOf(swing: Swing, a: number, b: number): number {
  const reach = ((swing.reach[a] as number) + (swing.reach[b] as number)) / 2;
  return Math.min(Math.floor(reach * CLASSES), CLASSES - 1);
}

/** The lines that are wanted, with gaps between them. */
function segments(lines: Uint32Array, at: { x: Float64Array; y: Float64Array }, wanted: (a: number, b: number) => boolean): { x: number[]; y: number[] } {
  const [x, y]: [number[], number[]] = [[], []];
  for (let i = 0; i + 1 < lines.length; i += 2) {
    const [a, b] = [lines[i] as number, lines[i + 1] as number];
    if (!wanted(a, b)) continue;
    x.push(at.x[a] as number, at.x[b] as number, Number.NaN);
    y.push(at.y[a] as number, at.y[b] as number, Number.NaN);
  }
  return { x, y };
}
