/** A contact law over speed and depth, its map and its cuts. */

import { nearest } from "../../chart/readout";
import { type Range, drawable, rangeOf } from "../../chart/scale";
import type { ChartSpec, Layer } from "../../chart/spec";
import { type Frame, reals } from "../../wire/frames";
import type { ContactState, Place, Quantity } from "./state";
import { DEPTH_LABEL, QUANTITY_LABELS, QUANTITY_NAMES, SPEED_LABEL, shortNumber } from "./words";

export interface Law {
  /** Speeds v τ/R and depths δ/R, ascending. */
  readonly velocity: Float64Array;
  readonly indentation: Float64Array;
  /** Row-major, depths as rows. */
  readonly values: Readonly<Record<Quantity, Float64Array>>;
}

export function lawOf(frame: Frame): Law {
  return {
    velocity: reals(frame, "velocity"),
    indentation: reals(frame, "indentation"),
    values: { force: reals(frame, "force"), area: reals(frame, "area"), friction: reals(frame, "friction") },
  };
}

/** The node of the law's grid that is nearest to a place, on logarithmic axes. */
export function nodeAt(law: Law, place: Place): { row: number; column: number } {
  return { row: nearest(law.indentation, place.indentation, "log"), column: nearest(law.velocity, place.velocity, "log") };
}

export function rowOf(law: Law, quantity: Quantity, row: number): Float64Array {
  const columns = law.velocity.length;
  return law.values[quantity].slice(row * columns, (row + 1) * columns);
}

export function columnOf(law: Law, quantity: Quantity, column: number): Float64Array {
  const columns = law.velocity.length;
  return Float64Array.from(law.indentation, (_, row) => law.values[quantity][row * columns + column] as number);
}

/** At most `count` of `length` places, evenly from the first to the last. */
export function spread(length: number, count: number): readonly number[] {
  const taken = Math.min(length, count);
  return Array.from({ length: taken }, (_, k) => (taken > 1 ? Math.round((k * (length - 1)) / (taken - 1)) : 0));
}

function isWithin({ speeds, depths }: ContactState, { velocity, indentation }: Place): boolean {
  return velocity >= speeds[0] && velocity <= speeds[1] && indentation >= depths[0] && indentation <= depths[1];
}

/** Decades below the largest friction that the colours tell apart: the tails of a bell fall without end. */
const DECADES = 6;

/** The values at the ends of the colours; null where there is nothing but zero. */
export function coloured(law: Law, quantity: Quantity): Range | null {
  const values = law.values[quantity];
  if (!values.some((value) => drawable("log", value))) return null;
  const [low, high] = rangeOf("log", [values]);
  return [quantity === "friction" ? Math.max(low, high * 10 ** -DECADES) : low, high];
}

export function mapSpec(law: Law | null, state: ContactState, operating: Place | null): ChartSpec {
  const layers: Layer[] = [];
  const range = law && coloured(law, state.quantity);
  if (law && range) {
    const plane = { x: law.velocity, y: law.indentation, values: law.values[state.quantity] };
    layers.push({ kind: "values", label: QUANTITY_LABELS[state.quantity], ...plane, colours: "sequential", scale: "log", range });
  }
  if (operating && isWithin(state, operating)) {
    const place = { x: [operating.velocity], y: [operating.indentation] };
    layers.push({ kind: "points", label: "operating point", ...place, role: { series: 1 }, size: 11 });
  }
  return {
    title: `${QUANTITY_NAMES[state.quantity]} over speed and depth`,
    x: { label: SPEED_LABEL, name: "v τ/R", scale: "log", range: state.speeds },
    y: { label: DEPTH_LABEL, name: "δ/R", scale: "log", range: state.depths },
    layers,
  };
}

/** What a cut shows beside the law itself. */
interface Beside {
  readonly law: Law;
  readonly name: string;
}

/** The operating point, and what the case's law says there. */
export interface Operating {
  readonly place: Place;
  readonly values: Readonly<Record<Quantity, number>>;
}

interface CutParts {
  readonly law: Law | null;
  readonly state: ContactState;
  readonly cursor: Place;
  readonly beside: Beside | null;
  readonly operating: Operating | null;
  /** E∞/E0; null where it is not known. */
  readonly contrast: number | null;
}

const CURVES = 5;

/** Over speed, at the cursor's depth and some others. */
export function speedCutSpec(parts: CutParts): ChartSpec {
  const { law, state, cursor, beside } = parts;
  const along = (law: Law, row: number) => ({ x: law.velocity, y: rowOf(law, state.quantity, row) });
  const layers: Layer[] = [];
  if (law) {
    const { row } = nodeAt(law, cursor);
    spread(law.indentation.length, CURVES).forEach((other, index, all) => {
      const label = `$δ$/$R$ = ${shortNumber(law.indentation[other] as number)}`;
      layers.push({ kind: "line", label, ...along(law, other), role: { graded: index, of: all.length } });
    });
    layers.push(...limits(parts, law.indentation[row] as number));
    if (beside) {
      const other = nodeAt(beside.law, cursor).row;
      layers.push({ kind: "line", label: `cursor, ${beside.name}`, ...along(beside.law, other), role: { series: 1 } });
    }
    const label = `cursor, $δ$/$R$ = ${shortNumber(law.indentation[row] as number)}`;
    layers.push({ kind: "line", label, ...along(law, row), role: { series: 6 }, dash: "solid" });
  }
  layers.push({ kind: "rule", across: "x", label: "", at: cursor.velocity, role: "reference" }, ...operatingMark(parts, "velocity"));
  return { ...cut(state, "speed"), x: { label: SPEED_LABEL, name: "v τ/R", scale: "log", range: state.speeds }, layers };
}

/** Over depth, at the cursor's speed and some others. */
export function depthCutSpec(parts: CutParts): ChartSpec {
  const { law, state, cursor, beside } = parts;
  const along = (law: Law, column: number) => ({ x: law.indentation, y: columnOf(law, state.quantity, column) });
  const layers: Layer[] = [];
  if (law) {
    const { column } = nodeAt(law, cursor);
    spread(law.velocity.length, CURVES).forEach((other, index, all) => {
      const label = `$v τ$/$R$ = ${shortNumber(law.velocity[other] as number)}`;
      layers.push({ kind: "line", label, ...along(law, other), role: { graded: index, of: all.length } });
    });
    if (beside) {
      const other = nodeAt(beside.law, cursor).column;
      layers.push({ kind: "line", label: `cursor, ${beside.name}`, ...along(beside.law, other), role: { series: 1 } });
    }
    const label = `cursor, $v τ$/$R$ = ${shortNumber(law.velocity[column] as number)}`;
    layers.push({ kind: "line", label, ...along(law, column), role: { series: 6 }, dash: "solid" });
  }
  layers.push({ kind: "rule", across: "x", label: "", at: cursor.indentation, role: "reference" }, ...operatingMark(parts, "indentation"));
  return { ...cut(state, "depth"), x: { label: DEPTH_LABEL, name: "δ/R", scale: "log", range: state.depths }, layers };
}

function operatingMark({ state, operating }: CutParts, over: keyof Place): Layer[] {
  // a mark far from the plane would stretch the axis of the values
  if (!operating || !isWithin(state, operating.place)) return [];
  return [{ kind: "points", label: "operating point", x: [operating.place[over]], y: [operating.values[state.quantity]], role: { series: 1 }, size: 9 }];
}

function cut(state: ContactState, over: string): Pick<ChartSpec, "title" | "y"> {
  return {
    title: `${QUANTITY_NAMES[state.quantity]} over ${over}`,
    // a bell that falls to nothing would stretch a logarithmic axis over its tail
    y: { label: QUANTITY_LABELS[state.quantity], scale: state.quantity === "friction" ? "linear" : "log" },
  };
}

/** Hertz's limits of slow and fast sliding at a depth. */
export function hertzLimits(quantity: Quantity, depth: number, contrast: number | null): readonly (readonly [name: string, value: number])[] {
  if (quantity === "area") return [["Hertz", Math.PI * depth]];
  if (quantity === "friction") return [];
  const slow = (4 / 3) * depth ** 1.5;
  return [["Hertz, $E_{0}$", slow], ...(contrast === null ? [] : [["Hertz, $E_{∞}$", contrast * slow] as const])];
}

function limits({ state, contrast }: CutParts, depth: number): Layer[] {
  return hertzLimits(state.quantity, depth, contrast)
    .filter(([, at]) => drawable("log", at))
    .map(([label, at]) => ({ kind: "rule", across: "y", label, at, role: "reference" }));
}
