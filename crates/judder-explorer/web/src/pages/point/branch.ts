/** The branch of cycles along a key: what is simulated, what is followed, folds and thresholds. */

import { type Curve, through } from "../../chart/runs";
import { type Range, rangeOf } from "../../chart/scale";
import type { Axis, ChartSpec, Layer, LineLayer } from "../../chart/spec";
import type { ScaleName } from "../../wire/api";
import { type Frame, codes, reals } from "../../wire/frames";
import type { Collector } from "./useRun";

export interface Branch {
  /** The key that was swept. */
  readonly key: string;
  readonly outcome: Frame;
  readonly forward: Curve;
  readonly backward: Curve;
  /** Lines by their stability: stable between neighbours that both are, unstable between others of the same branch. */
  readonly stable: Curve;
  readonly unstable: Curve;
  readonly steadyStable: Curve;
  readonly steadyUnstable: Curve;
  readonly folds: Curve;
  readonly hopf: Float64Array;
}

export function collectBranch(): Collector<Branch> {
  return (frame) => (frame.kind === "outcome" ? branchOf(frame) : null);
}

function branchOf(frame: Frame): Branch {
  const rms = frame.arrays.get("rms");
  const along = reals(frame, rms?.dimensions[1] ?? "");
  const values = reals(frame, "rms");
  const row = (name: string): Curve => {
    const at = frame.arrays.get("direction")?.texts.indexOf(name) ?? -1;
    return at < 0 ? { x: new Float64Array(0), y: new Float64Array(0) } : { x: along, y: values.subarray(at * along.length, (at + 1) * along.length) };
  };
  const branch = { x: reals(frame, "branch_value"), y: reals(frame, "branch_rms") };
  const [numbers, stable] = [reals(frame, "branch_number"), codes(frame, "branch_stable")];
  const steady = reals(frame, "steady_value");
  const growth = reals(frame, "growth_rate");
  const sliding = { x: steady, y: new Float64Array(steady.length) };
  const isSame = (row: number) => numbers[row] === numbers[row + 1];
  const isStable = (row: number) => stable[row] === 1 && stable[row + 1] === 1;
  // where there is no steady sliding its growth rate is NaN
  const slides = (row: number) => Number.isFinite(growth[row]) && Number.isFinite(growth[row + 1]);
  const rests = (row: number) => (growth[row] as number) < 0 && (growth[row + 1] as number) < 0;
  return {
    key: String((frame.header["scalars"] as { key?: unknown } | undefined)?.key ?? ""),
    outcome: frame,
    forward: row("forward"),
    backward: row("backward"),
    stable: through(branch, (row) => isSame(row) && isStable(row)),
    unstable: through(branch, (row) => isSame(row) && !isStable(row)),
    steadyStable: through(sliding, (row) => slides(row) && rests(row)),
    steadyUnstable: through(sliding, (row) => slides(row) && !rests(row)),
    folds: { x: reals(frame, "fold_value"), y: reals(frame, "fold_rms") },
    hopf: reals(frame, "hopf_value"),
  };
}

/** The swept range: the present value may lie far away. */
export function rangeOfBranch({ forward, backward, steadyStable, steadyUnstable }: Branch, scale: ScaleName): Range {
  return rangeOf(scale, [forward.x, backward.x, steadyStable.x, steadyUnstable.x], 0.03);
}

export function branchSpec(branch: Branch, axis: Axis, now: number | null): ChartSpec {
  const line = (label: string, curve: Curve, role: LineLayer["role"], dash: "solid" | "dashed"): Layer[] =>
    curve.x.length === 0 ? [] : [{ kind: "line", label, ...curve, role, dash }];
  const points = (label: string, curve: Curve, series: number, more: object): Layer[] =>
    curve.x.length === 0 ? [] : [{ kind: "points", label, ...curve, role: { series }, size: 7, ...more }];
  return {
    title: "Branch of limit cycles",
    x: axis,
    y: { label: "rms of $x$/$x_{0}$ (−)", scale: "linear" },
    layers: [
      ...line("steady sliding, stable", branch.steadyStable, "full-boundary", "solid"),
      ...line("steady sliding, unstable", branch.steadyUnstable, "full-boundary", "dashed"),
      ...line("cycles, stable", branch.stable, { series: 0 }, "solid"),
      ...line("cycles, unstable", branch.unstable, { series: 0 }, "dashed"),
      ...points("simulated, upwards", branch.forward, 3, {}),
      ...points("simulated, downwards", branch.backward, 1, { hollow: true, size: 10 }),
      ...points("fold", branch.folds, 2, { size: 12 }),
      ...points("threshold", { x: branch.hopf, y: new Float64Array(branch.hopf.length) }, 6, { size: 9 }),
      ...(now === null ? [] : [{ kind: "rule", label: "present value", across: "x", at: now, role: "decoupled-boundary" } as const]),
    ],
  };
}
