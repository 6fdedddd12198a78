/** The fields of one contact: pressure and gap over the surface, and along the sliding direction. */

import { nearest } from "../../chart/readout";
import type { ChartSpec, Layer } from "../../chart/spec";
import { type Frame, reals } from "../../wire/frames";
import { numberAt, outcomeOf } from "../../wire/outcome";

export interface Field {
  readonly x: Float64Array;
  readonly y: Float64Array;
  /** Row-major, y as rows. */
  readonly values: Float64Array;
}

/** An elastic contact to compare with: radius in R, largest pressure in E0*. */
export interface Elastic {
  readonly name: string;
  readonly radius: number;
  readonly pressure: number;
  readonly role: { readonly series: number };
}

export interface Solution {
  readonly pressure: Field;
  readonly gap: Field;
  readonly displacement: Field;
  readonly height: Field;
  readonly depth: number;
  /** Around the cells in contact. */
  readonly boundary: { readonly x: Float64Array; readonly y: Float64Array };
  /** Hertz's contacts; none where the indenter is not round. */
  readonly elastic: readonly Elastic[];
}

export function solutionOf(frame: Frame): Solution {
  const field = (name: string): Field => {
    const [y = "y", x = "x"] = frame.arrays.get(name)?.dimensions ?? [];
    return { x: reals(frame, x), y: reals(frame, y), values: reals(frame, name) };
  };
  const { scalars } = outcomeOf(frame);
  const [pressure, height, depth] = [field("pressure"), field("height"), numberAt(scalars, "indentation")];
  return {
    pressure,
    gap: field("gap"),
    displacement: field("displacement"),
    height,
    depth,
    boundary: boundary(pressure),
    elastic: isRound(height) ? hertz(depth, numberAt(scalars, "force")) : [],
  };
}

/** How far heights may be from r²/2R: a sphere's are a little above a paraboloid's. */
const ROUND = 0.05;
const ROUND_WITHIN = 0.3;

/** Whether the indenter is a paraboloid or a sphere near its lowest point, as Hertz's contact is. */
export function isRound({ x, y, values }: Field): boolean {
  if (y.length < 2) return false;
  return values.every((height, index) => {
    const radius = Math.hypot(x[index % x.length] as number, y[Math.floor(index / x.length)] as number);
    return radius > ROUND_WITHIN || Math.abs(height - radius ** 2 / 2) <= ROUND * (radius ** 2 / 2) + 1e-12;
  });
}

/** Hertz on the rubbery modulus: at the same depth a² = δ, at the same force a³ = 3F/4; p0 = 2a/π (lengths in R, forces in E0* R²). */
export function hertz(depth: number, force: number): readonly Elastic[] {
  const at = (name: string, radius: number, role: Elastic["role"]): Elastic => ({ name, radius, pressure: (2 * radius) / Math.PI, role });
  return [
    at("Hertz with $E_{0}$, same depth", Math.sqrt(depth), { series: 1 }),
    at("Hertz with $E_{0}$, same force", Math.cbrt(0.75 * force), { series: 3 }),
  ].filter(({ radius }) => radius > 0);
}

/** The outline of the cells in contact as closed loops, with a break after each. */
export function boundary({ x, y, values }: Field): { x: Float64Array; y: Float64Array } {
  const [columns, rows] = [x.length, y.length];
  if (columns < 2 || rows < 2) return { x: new Float64Array(0), y: new Float64Array(0) };
  const loops = outlines(columns, rows, (row, column) => (values[row * columns + column] as number) > 0);
  const [wide, high] = [(x[1] as number) - (x[0] as number), (y[1] as number) - (y[0] as number)];
  const corners = loops.flatMap((loop) => [...loop, -1]);
  const at = (first: number, step: number, place: (corner: number) => number) =>
    Float64Array.from(corners, (corner) => (corner < 0 ? Number.NaN : first + step * (place(corner) - 0.5)));
  return {
    x: at(x[0] as number, wide, (corner) => corner % (columns + 1)),
    y: at(y[0] as number, high, (corner) => Math.floor(corner / (columns + 1))),
  };
}

/** Loops of corners of cells around those that touch, which lie to the left; corners are numbered row by row. */
function outlines(columns: number, rows: number, touches: (row: number, column: number) => boolean): readonly (readonly number[])[] {
  const inside = (row: number, column: number) => row >= 0 && row < rows && column >= 0 && column < columns && touches(row, column);
  const corner = (row: number, column: number) => row * (columns + 1) + column;
  const next = new Map<number, number[]>();
  const side = (from: number, to: number) => void (next.get(from)?.push(to) ?? next.set(from, [to]));
  for (let row = 0; row < rows; row += 1) {
    for (let column = 0; column < columns; column += 1) {
      if (!inside(row, column)) continue;
      if (!inside(row - 1, column)) side(corner(row, column), corner(row, column + 1));
      if (!inside(row, column + 1)) side(corner(row, column + 1), corner(row + 1, column + 1));
      if (!inside(row + 1, column)) side(corner(row + 1, column + 1), corner(row + 1, column));
      if (!inside(row, column - 1)) side(corner(row + 1, column), corner(row, column));
    }
  }
  const loops: number[][] = [];
  for (const start of next.keys()) {
    let at = next.get(start)?.pop();
    if (at === undefined) continue;
    const loop = [start];
    for (; at !== undefined; at = next.get(at)?.pop()) loop.push(at);
    loops.push(loop);
  }
  return loops;
}

const X_LABEL = "Position $x$/$R$ (−), sliding →";
const Y_LABEL = "Position $y$/$R$ (−)";
const PRESSURE = "Pressure $p$/$E_{0}^{*}$ (−)";
const GAP = "Gap $g$/$R$ (−)";

export function fieldSpec(solution: Solution | null, name: "pressure" | "gap"): ChartSpec {
  const layers: Layer[] = [];
  if (solution) {
    layers.push({ kind: "values", label: name === "pressure" ? PRESSURE : GAP, ...solution[name], colours: "sequential", scale: "linear" });
    layers.push(...solution.elastic.map((elastic): Layer => ({ kind: "line", label: elastic.name, ...circle(elastic.radius), role: elastic.role })));
    layers.push({ kind: "line", label: "edge of the contact", ...solution.boundary, role: "full-boundary" });
  }
  return {
    title: name === "pressure" ? "Pressure in the contact" : "Gap around the contact",
    x: { label: X_LABEL, name: "x/R", scale: "linear" },
    y: { label: Y_LABEL, name: "y/R", scale: "linear" },
    layers,
    equal: true,
  };
}

const CORNERS = 180;

function circle(radius: number): { x: Float64Array; y: Float64Array } {
  const angle = (i: number) => (2 * Math.PI * i) / CORNERS;
  return {
    x: Float64Array.from({ length: CORNERS + 1 }, (_, i) => radius * Math.cos(angle(i))),
    y: Float64Array.from({ length: CORNERS + 1 }, (_, i) => radius * Math.sin(angle(i))),
  };
}

/** The row of a field along the sliding direction through the middle. */
export function middleRow({ x, y, values }: Field): Float64Array {
  const row = Math.max(nearest(y, 0), 0);
  return values.slice(row * x.length, (row + 1) * x.length);
}

export function pressureCutSpec(solution: Solution | null): ChartSpec {
  const layers: Layer[] = [];
  if (solution) {
    const { x } = solution.pressure;
    layers.push({ kind: "line", label: "sliding contact", x, y: middleRow(solution.pressure), role: { series: 0 } });
    for (const { name, radius, pressure, role } of solution.elastic) {
      const y = x.map((at) => pressure * Math.sqrt(Math.max(1 - (at / radius) ** 2, 0)));
      layers.push({ kind: "line", label: name, x, y, role });
    }
  }
  return {
    title: "Pressure along the sliding direction",
    x: { label: X_LABEL, name: "x/R", scale: "linear" },
    y: { label: PRESSURE, scale: "linear" },
    layers,
  };
}

/** What stands so many times higher than the contact would flatten the picture. */
const HIGHEST = 4;

export function surfaceCutSpec(solution: Solution | null): ChartSpec {
  const layers: Layer[] = [];
  if (solution) {
    const { height, displacement, depth } = solution;
    const [heights, pressures] = [middleRow(height), middleRow(solution.pressure)];
    const touching = heights.filter((_, i) => (pressures[i] as number) > 0);
    const highest = HIGHEST * touching.reduce((most, value) => Math.max(most, value), 0);
    const indenter = heights.map((value) => (value < highest ? value - depth : Number.NaN));
    const surface = middleRow(displacement).map((value) => -value);
    layers.push({ kind: "line", label: "surface of the substrate", x: displacement.x, y: surface, role: { series: 0 } });
    layers.push({ kind: "line", label: "indenter", x: height.x, y: indenter, role: "reference", dash: "dashed" });
  }
  return {
    title: "Surfaces along the sliding direction",
    x: { label: X_LABEL, name: "x/R", scale: "linear" },
    y: { label: "Height $z$/$R$ (−)", scale: "linear" },
    layers,
  };
}
