/** Critical curves over the map: thresholds of the y key along the x key. */

import { useEffect, useRef, useState } from "preact/hooks";
import type { Curve } from "../../chart/runs";
import type { Analysis, KeyAxis } from "../../wire/api";
import { type Frame, reals } from "../../wire/frames";
import { Latest } from "../../wire/latest";
import { type RequestError, asRequestError, isAbort, postFrames, slot } from "../../wire/request";

export interface Critical {
  readonly full: Curve;
  readonly conservative: Curve;
}

const POINTS = 81;
/** The curves take far longer than a map: they wait until a slider rests, in milliseconds. */
const REST = 150;
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

export function useCritical(set: readonly string[], analysis: Analysis | null) {
  const [critical, setCritical] = useState<Critical | null>(null);
  const [error, setError] = useState<RequestError | null>(null);
  const latest = useRef(new Latest());
  const text = analysis ? JSON.stringify({ set, analysis }) : "";
  // thresholds of another plane or case are wrong, not old
  const [of, setOf] = useState("");
  useEffect(() => {
    if (text === "") return latest.current.stop();
    const ask = async (signal: AbortSignal) => {
      try {
        const body = { ...(JSON.parse(text) as object), slot: slot("critical") };
        for await (const frame of postFrames("/api/analysis", body, signal)) {
          if (frame.kind !== "outcome") continue;
          setCritical({ full: roots(frame, "full"), conservative: roots(frame, "conservative") });
          setOf(text);
          setError(null);
        }
      } catch (failure) {
        if (!isAbort(failure)) setError(asRequestError(failure));
      }
    };
    latest.current.stop();
    const timer = setTimeout(() => latest.current.submit(ask), REST);
    return () => clearTimeout(timer);
  }, [text]);
  useEffect(() => () => latest.current.stop(), []);
  return { critical: of === text && text !== "" ? critical : null, error: text === "" ? null : error };
}
