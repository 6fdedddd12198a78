/** Critical curves over the map: thresholds of the y key along the x key. */

import { useMemo } from "preact/hooks";
import type { Curve } from "../../chart/runs";
import { type Computation, useComputation } from "../../ui/useComputation";
import type { Analysis, KeyAxis } from "../../wire/api";
import { type Frame, reals } from "../../wire/frames";

export interface Critical {
  readonly full: Curve;
  readonly conservative: Curve;
}

const POINTS = 81;
const KINDS: Readonly<Record<string, string>> = {
  "contact.shear_strength": "critical-shear-strength",
  "operation.normal_load": "critical-load",
};

/** The analysis whose thresholds lie on the y axis; null where its key has none. */
export function criticalAnalysis(x: KeyAxis, y: KeyAxis): Analysis | null {
  const kind = KINDS[y.key];
  if (!kind) return null;
  const sweep = { key: x.key, from: x.from, to: x.to, points: POINTS, scale: x.scale };
  // following the cycles beside every threshold takes tenths of a second each
  return { name: "critical", kind, sweep, within: { from: y.from, to: y.to }, global_margin: false };
}

/** The roots of an outcome, each as a point. */
export function roots(frame: Frame, name: string): Curve {
  const array = frame.arrays.get(name);
  const along = reals(frame, array?.dimensions[0] ?? "");
  const values = reals(frame, name);
  const each = along.length === 0 ? 0 : values.length / along.length;
  const [x, y]: [number[], number[]] = [[], []];
  values.forEach((value, index) => {
    if (!Number.isFinite(value)) return;
    x.push(along[Math.floor(index / each)] as number);
    y.push(value);
  });
  return { x: Float64Array.from(x), y: Float64Array.from(y) };
}

/** The outcome of an analysis beside the map, which may take far longer than the map itself: it waits until a slider rests. */
export function useBeside(purpose: string, set: readonly string[], analysis: Analysis | null): Computation {
  return useComputation("/api/analysis", analysis && { set, analysis }, purpose, { rest: 150, hasty: true });
}

export function useCritical(set: readonly string[], analysis: Analysis | null) {
  const { frame, current, error } = useBeside("critical", set, analysis);
  const critical = useMemo((): Critical | null => frame && { full: roots(frame, "full"), conservative: roots(frame, "conservative") }, [frame]);
  // thresholds of another plane or case are wrong, not old
  return { critical: current ? critical : null, error };
}
