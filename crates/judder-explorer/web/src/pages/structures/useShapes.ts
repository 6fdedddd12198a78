/** Shapes of a locus at one place, asked for as it moves. */

import { useEffect, useRef, useState } from "preact/hooks";
import type { Pair } from "../../wire/api";
import { type Frame, reals } from "../../wire/frames";
import { Latest } from "../../wire/latest";
import { type RequestError, asRequestError, isAbort, postFrames, slot } from "../../wire/request";
import { type Body, bodyOf } from "./body";

export interface Shapes {
  readonly at: number;
  readonly body: Body;
  readonly eigenvalues: readonly Pair[];
  /** Complex numbers as pairs, mode by mode. */
  readonly shapes: Float64Array;
}

/** A place that moves on within this time, in milliseconds, asks for nothing. */
const REST = 120;

function shapesOf(frame: Frame, at: number): Shapes {
  const eigenvalues = (frame.header["eigenvalues"] as readonly Pair[] | undefined) ?? [];
  return { at, body: bodyOf(reals(frame, "points"), reals(frame, "lines")), eigenvalues, shapes: reals(frame, "shapes") };
}

/** The shape of one mode. */
export function shapeOf(shapes: Shapes, mode: number): Float64Array {
  const length = 2 * shapes.body.points.length;
  return shapes.shapes.subarray(mode * length, (mode + 1) * length);
}

/** Shapes of so many modes; null asks for nothing. */
export function useShapes(analysis: string, at: number | null, count: number) {
  const [shapes, setShapes] = useState<{ of: string; value: Shapes } | null>(null);
  const [error, setError] = useState<RequestError | null>(null);
  const [busy, setBusy] = useState(false);
  const latest = useRef(new Latest());
  useEffect(() => {
    if (at === null) return;
    const ask = () =>
      latest.current.submit(async (signal, shown) => {
        setBusy(true);
        try {
          for await (const frame of postFrames("/api/study/shapes", { analysis, at, count, slot: slot("study/shapes") }, signal)) {
            if (frame.kind !== "shapes") continue;
            setShapes({ of: analysis, value: shapesOf(frame, at) });
            setError(null);
            shown();
          }
        } catch (failure) {
          // what follows an abort says itself whether something runs
          if (isAbort(failure)) return;
          setError(asRequestError(failure));
        }
        setBusy(false);
      });
    const timer = setTimeout(ask, REST);
    return () => clearTimeout(timer);
  }, [analysis, at, count]);
  useEffect(() => () => latest.current.stop(), []);
  const cancel = () => {
    latest.current.stop();
    setBusy(false);
  };
  return { shapes: shapes?.of === analysis ? shapes.value : null, error, busy, cancel };
}
