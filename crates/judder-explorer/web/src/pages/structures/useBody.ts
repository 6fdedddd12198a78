/** The body of an analysis, or its bodies as one. */

import { useMemo } from "preact/hooks";
import type { RequestError } from "../../wire/request";
import { type Body, bodyOf } from "./body";
import { type StudyAnalysis, variable } from "./study";
import { type Arrays, numbers, useArrays } from "./useArrays";

/** What bodies and their shapes are known by. */
export const BODY: readonly string[] = ["place", "line", "body", "mesh_line"];
export const SHAPE = "shape";

/** Whether it is stored where points lie, and how they are displaced. */
export function hasShapes(analysis: StudyAnalysis): boolean {
  return (variable(analysis, "place")?.shape[0] ?? 0) > 0 && variable(analysis, "line") !== undefined && variable(analysis, SHAPE) !== undefined;
}

function bodyIn(arrays: Arrays): Body {
  const of = (name: string) => numbers(arrays, name);
  return bodyOf(of("place"), of("line"), { nodes: of("point"), names: arrays.get("body")?.texts ?? [], mesh: of("mesh_line") });
}

export function useBody(analysis: StudyAnalysis): { readonly body: Body | null; readonly error: RequestError | null } {
  const { arrays, error } = useArrays(analysis.name, [...BODY, "point"].filter((name) => variable(analysis, name)), {}, "places");
  const body = useMemo(() => (arrays ? bodyIn(arrays) : null), [arrays]);
  return { body, error };
}
