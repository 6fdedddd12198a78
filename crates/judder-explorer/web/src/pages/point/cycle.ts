/** A limit cycle: its loop, and its Floquet multipliers in the unit circle. */

import type { ChartSpec, Layer } from "../../chart/spec";
import type { Pair } from "../../wire/api";
import type { Frame } from "../../wire/frames";
import { outcomeOf } from "../../wire/outcome";
import { type Loop, type Motion, motionOf } from "./motion";
import type { Collector } from "./useRun";

export function collectCycle(): Collector<Motion> {
  return (frame) => (frame.kind === "outcome" ? motionOf(frame) : null);
}

/** The cycle as a closed line. */
export function loopOf(cycle: Motion): Loop {
  const closed = (values: Float64Array) => Float64Array.from([...values, values[0] ?? Number.NaN]);
  return { x: closed(cycle.fine.x), velocity: closed(cycle.fine.velocity) };
}

export function multipliers(outcome: Frame): readonly Pair[] {
  const listed = outcomeOf(outcome).scalars["floquet_multipliers"];
  return Array.isArray(listed) ? (listed as Pair[]) : [];
}

/** Farther out a multiplier would shrink the circle to a dot. */
const REACH = 2.5;

/** How many multipliers lie beyond what is shown at first. */
export function beyond(list: readonly Pair[]): number {
  return list.filter(([re, im]) => Math.max(Math.abs(re), Math.abs(im)) > REACH).length;
}

export function floquetSpec(list: readonly Pair[]): ChartSpec {
  const circle = Array.from({ length: 181 }, (_, i) => (i * Math.PI) / 90);
  const outside = ([re, im]: Pair) => Math.hypot(re, im) > 1 && !isTrivial(list, [re, im]);
  const points = (label: string, chosen: readonly Pair[], series: number): Layer[] =>
    chosen.length === 0 ? [] : [{ kind: "points", label, x: chosen.map(([re]) => re), y: chosen.map(([, im]) => im), role: { series }, size: 10 }];
  const half = Math.min(Math.max(1.15, ...list.map(([re, im]) => 1.1 * Math.max(Math.abs(re), Math.abs(im)))), REACH);
  return {
    title: "Floquet multipliers",
    x: { label: "Re $μ$ (−)", scale: "linear", range: [-half, half] },
    y: { label: "Im $μ$ (−)", scale: "linear", range: [-half, half] },
    equal: true,
    layers: [
      { kind: "line", label: "unit circle", x: circle.map(Math.cos), y: circle.map(Math.sin), role: "full-boundary" },
      ...points("along the cycle", list.filter((one) => isTrivial(list, one)), 6),
      ...points("within: decays", list.filter((one) => !isTrivial(list, one) && !outside(one)), 0),
      ...points("outside: grows", list.filter(outside), 1),
    ],
  };
}

/** The one next to 1 is a disturbance along the cycle itself. */
function isTrivial(list: readonly Pair[], [re, im]: Pair): boolean {
  const away = (pair: Pair) => Math.hypot(pair[0] - 1, pair[1]);
  return away([re, im]) === Math.min(...list.map(away));
}
