/** The picture of a map as frames bring it. */

import type { Curve } from "../../chart/runs";
import { BOUNDARIES } from "../../state/fields";
import type { Analysis, KeyAxis } from "../../wire/api";
import { type Frame, codes, meanings, reals, words } from "../../wire/frames";

/** Points of each axis of the exact map. */
const POINTS = 400;
/** Points of each axis of a sketch: the map of a value that a slider passes. */
export const SKETCH = 41;

export type BoundaryName = (typeof BOUNDARIES)[number];

export interface MapPicture {
  /** The two keys and their scales: a picture of others is never shown. */
  readonly plane: string;
  /** The options of the case: what hangs together with the classes. */
  readonly options: string;
  readonly stage: "coarse" | "exact";
  readonly x: Float64Array;
  readonly y: Float64Array;
  readonly classes: Uint8Array;
  /** What their codes stand for. */
  readonly words: readonly string[];
  /** Whether the errors of the contact law decide; null before it is known, and for a formula. */
  readonly withinLaw: readonly boolean[] | null;
  readonly unresolved: number;
  readonly boundaries: Readonly<Partial<Record<BoundaryName, Curve>>>;
}

export interface MapRequest {
  readonly set: readonly string[];
  readonly x: KeyAxis;
  readonly y: KeyAxis;
  readonly boundaries: readonly BoundaryName[];
}

export function mapAnalysis({ x, y }: Pick<MapRequest, "x" | "y">, boundaries: boolean, points = POINTS): Analysis {
  const axis = (axis: KeyAxis) => ({ key: axis.key, from: axis.from, to: axis.to, points, scale: axis.scale });
  return { name: "map", kind: "stability-map", x: axis(x), y: axis(y), ...(boundaries ? { boundaries } : {}) };
}

export function planeOf({ x, y }: Pick<MapRequest, "x" | "y">): string {
  const form = (axis: KeyAxis) => `${axis.key} ${axis.scale} ${typeof axis.from}`;
  return `${form(x)} ${form(y)}`;
}

/** The picture after one more frame; every map of a sketch is coarse. */
export function withFrame(before: MapPicture | null, frame: Frame, request: MapRequest, sketch = false): MapPicture | null {
  const [plane, options] = [planeOf(request), JSON.stringify(request.set)];
  if (frame.kind === "map") {
    // curves of the same case stay true while its window moves; those of another case do not
    const same = before?.plane === plane && before.options === options;
    return {
      plane,
      options,
      stage: frame.header["stage"] === "exact" && !sketch ? "exact" : "coarse",
      x: reals(frame, "x"),
      y: reals(frame, "y"),
      classes: codes(frame, "classes"),
      words: words(frame.arrays.get("classes")),
      withinLaw: null,
      unresolved: Number(frame.header["unresolved"] ?? 0),
      boundaries: same ? before.boundaries : {},
    };
  }
  const standings = frame.arrays.get("within_law");
  if (standings && before) return { ...before, withinLaw: meanings(standings).map((word) => word === MARGINAL) };
  const name = BOUNDARIES.find((name) => name === frame.header["name"]);
  if (frame.kind !== "boundary" || !name || !before) return before;
  const curve = { x: reals(frame, "x"), y: reals(frame, "y") };
  return { ...before, boundaries: { ...before.boundaries, [name]: curve } };
}

/** The word for points at which the errors of the law decide. */
export const MARGINAL = "marginal within the law";

/** The classes with `marginal` in the place of verdicts that the errors of the law decide. */
export function drawnClasses({ classes, withinLaw }: Pick<MapPicture, "classes" | "withinLaw">, marginal: number): Uint8Array {
  return withinLaw ? classes.map((code, k) => (withinLaw[k] ? marginal : code)) : classes;
}

/** The share of every class, by code. */
export function shares(classes: Uint8Array, count: number): readonly number[] {
  const counts = new Array<number>(count).fill(0);
  for (const code of classes) counts[code] = (counts[code] ?? 0) + 1;
  return counts.map((number) => (classes.length === 0 ? 0 : number / classes.length));
}
