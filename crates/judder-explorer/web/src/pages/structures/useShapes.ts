/** Shapes of a locus at one place, asked for as it moves. */

import { useMemo } from "preact/hooks";
import { useComputation } from "../../ui/useComputation";
import type { Pair } from "../../wire/api";
import { type Frame, reals } from "../../wire/frames";
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
  const computation = useComputation("/api/study/shapes", at === null ? null : { analysis, at, count }, "study/shapes", { rest: REST });
  const { frame, asked, error, busy, stop } = computation;
  const shapes = useMemo(() => (frame && asked?.["analysis"] === analysis ? shapesOf(frame, asked["at"] as number) : null), [frame, asked, analysis]);
  return { shapes, error, busy, cancel: stop };
}
