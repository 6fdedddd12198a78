/** The branch of cycles along a key: what is simulated, what is followed, folds and thresholds. */

import { type Marker, lineStyle } from "../../chart/palette";
import { type Curve, through } from "../../chart/runs";
import { type Range, rangeOf } from "../../chart/scale";
import type { Axis, ChartSpec, Layer, LineLayer } from "../../chart/spec";
import type { ScaleName } from "../../wire/api";
import { type Frame, codes, meanings, reals } from "../../wire/frames";
import { type BranchRows, drawnOnce } from "./overlaps";
import type { Collector } from "./useRun";

/** Simulated motions that were followed the same way and became the same. */
interface Simulated {
  /** Its place among `DIRECTIONS`. */
  readonly direction: number;
  /** What they have become, in a word of the program. */
  readonly kind: string;
  readonly points: Curve;
}

export interface Branch {
  /** The key that was swept. */
  readonly key: string;
  readonly outcome: Frame;
  /** The values of the key. */
  readonly along: Float64Array;
  readonly simulated: readonly Simulated[];
  readonly rows: BranchRows;
  /** Whether from this row to the next a branch goes on, stable at both or not at both. */
  readonly joins: (row: number, isStable: boolean) => boolean;
  readonly steadyStable: Curve;
  readonly steadyUnstable: Curve;
  readonly folds: Curve;
  readonly hopf: Float64Array;
}

/** The ways along the key, and how they are called here. */
const DIRECTIONS = [
  ["forward", "upwards"],
  ["backward", "downwards"],
] as const;

export function collectBranch(): Collector<Branch> {
  return (frame) => (frame.kind === "outcome" ? branchOf(frame) : null);
}

function branchOf(frame: Frame): Branch {
  const numbers = reals(frame, "branch_number");
  const stable = codes(frame, "branch_stable");
  const steady = reals(frame, "steady_value");
  const growth = reals(frame, "growth_rate");
  const sliding = { x: steady, y: new Float64Array(steady.length) };
  // where there is no steady sliding its growth rate is NaN
  const slides = (row: number) => Number.isFinite(growth[row]) && Number.isFinite(growth[row + 1]);
  const rests = (row: number) => (growth[row] as number) < 0 && (growth[row + 1] as number) < 0;
  return {
    key: String((frame.header["scalars"] as { key?: unknown } | undefined)?.key ?? ""),
    outcome: frame,
    along: reals(frame, frame.arrays.get("rms")?.dimensions[1] ?? ""),
    simulated: simulatedOf(frame),
    rows: { x: reals(frame, "branch_value"), y: reals(frame, "branch_rms"), number: numbers },
    joins: (row, isStable) => numbers[row] === numbers[row + 1] && (stable[row] === 1 && stable[row + 1] === 1) === isStable,
    steadyStable: through(sliding, (row) => slides(row) && rests(row)),
    steadyUnstable: through(sliding, (row) => slides(row) && !rests(row)),
    folds: { x: reals(frame, "fold_value"), y: reals(frame, "fold_rms") },
    hopf: reals(frame, "hopf_value"),
  };
}

/** The simulated motions by direction and kind; a motion that was lost has no rms. */
function simulatedOf(frame: Frame): readonly Simulated[] {
  const [rms, becomes] = [frame.arrays.get("rms"), frame.arrays.get("becomes")];
  const values = reals(frame, "rms");
  const along = reals(frame, rms?.dimensions[1] ?? "");
  const words = becomes ? meanings(becomes) : [];
  return DIRECTIONS.flatMap(([name], direction) => {
    const at = frame.arrays.get("direction")?.texts.indexOf(name) ?? -1;
    if (at < 0) return [];
    const own = Array.from(along, (x, i) => ({ x, y: values[at * along.length + i] as number, kind: words[at * along.length + i] ?? "" }));
    const known = own.filter(({ y }) => Number.isFinite(y));
    return [...new Set(known.map(({ kind }) => kind))].map((kind): Simulated => {
      const alike = known.filter((one) => one.kind === kind);
      return { direction, kind, points: { x: Float64Array.from(alike, ({ x }) => x), y: Float64Array.from(alike, ({ y }) => y) } };
    });
  });
}

/** The swept range: the present value may lie far away. */
export function rangeOfBranch({ along, steadyStable, steadyUnstable }: Branch, scale: ScaleName): Range {
  return rangeOf(scale, [along, steadyStable.x, steadyUnstable.x], 0.03);
}

/** Roles of the kinds as in the report's diagram: the series of the first direction, whose next one is that of the second. */
const KINDS: Readonly<Record<string, number>> = { "steady sliding": 0, cycle: 0, irregular: 4, unconfirmed: 6 };
/** What the page has no name for is not known either. */
const UNKNOWN = 6;

/** Markers of one direction stand in those of the other: both can be seen where the motions are the same. */
function simulatedLayer({ direction, kind, points }: Simulated): Layer {
  const first = KINDS[kind] ?? UNKNOWN;
  const series = { series: first + direction };
  const word = first === UNKNOWN ? `not known (${kind || "not told"})` : kind;
  const inner = direction === 0;
  return {
    kind: "points",
    label: `${word}, simulated ${DIRECTIONS[direction]?.[1] ?? ""}`,
    ...points,
    // steady sliding has the colour of the line on which it lies
    role: kind === "steady sliding" ? "reference" : series,
    marker: lineStyle(series, "light").marker,
    size: inner ? 7 : 12,
    hollow: !inner,
  };
}

export function branchSpec(branch: Branch, axis: Axis, now: number | null): ChartSpec {
  const line = (label: string, curve: Curve, role: LineLayer["role"], dash: "solid" | "dashed"): Layer[] =>
    curve.x.length === 0 ? [] : [{ kind: "line", label, ...curve, role, dash }];
  // of the branch's own colour: no kind of motion, no direction has it
  const points = (label: string, curve: Curve, marker: Marker, size: number): Layer[] =>
    curve.x.length === 0 ? [] : [{ kind: "points", label, ...curve, role: "full-boundary", marker, size }];
  const cycles = (isStable: boolean) => through(branch.rows, drawnOnce(branch.rows, axis.scale, (row) => branch.joins(row, isStable)));
  return {
    title: "Branch of limit cycles",
    x: axis,
    y: { label: "rms of $x$/$x_{0}$ (−)", scale: "linear" },
    layers: [
      ...line("steady sliding, stable", branch.steadyStable, "reference", "solid"),
      ...line("steady sliding, unstable", branch.steadyUnstable, "reference", "dashed"),
      ...line("cycles, stable", cycles(true), "full-boundary", "solid"),
      ...line("cycles, unstable", cycles(false), "full-boundary", "dashed"),
      ...points("fold", branch.folds, "cross", 12),
      ...points("threshold", { x: branch.hopf, y: new Float64Array(branch.hopf.length) }, "diamond", 10),
      ...branch.simulated.map(simulatedLayer),
      ...(now === null ? [] : [{ kind: "rule", label: "present value", across: "x", at: now, role: "decoupled-boundary" } as const]),
    ],
  };
}
