/** Arrays of an analysis of the study, asked for as what is shown changes. */

import { useMemo } from "preact/hooks";
import { useComputation } from "../../ui/useComputation";
import type { FrameArray } from "../../wire/frames";
import type { RequestError } from "../../wire/request";

/** Which values: everything, or those from one number to before another along the first dimension, at most so many. */
export interface Part {
  readonly from?: number;
  readonly to?: number;
  readonly most?: number;
}

export type Arrays = ReadonlyMap<string, FrameArray>;

export interface LiveArrays {
  readonly arrays: Arrays | null;
  readonly part: Part;
  readonly error: RequestError | null;
  readonly busy: boolean;
  readonly cancel: () => void;
}

/** `purpose` tells requests of one page apart: a newer one of the same purpose ends the older one. */
export function useArrays(analysis: string, variables: readonly string[], wanted: Part = {}, purpose = "arrays"): LiveArrays {
  const request = variables.length === 0 ? null : { analysis, variables, ...wanted };
  const { frame, asked, busy, stopped, error, stop } = useComputation("/api/study/arrays", request, `study/${purpose}`);
  // arrays of another analysis are wrong, those of another part are only old
  const isOwn = request !== null && asked?.["analysis"] === analysis;
  const part = useMemo((): Part => {
    const { analysis: _, variables: __, ...part } = asked ?? {};
    return isOwn ? part : {};
  }, [asked, isOwn]);
  const waits = request !== null && !isOwn && !stopped && !error;
  return { arrays: isOwn ? (frame?.arrays ?? null) : null, part, error: busy ? null : error, busy: busy || waits, cancel: stop };
}

/** The numbers of an array; empty where there is none of this name. */
export function numbers(arrays: Arrays | null, name: string): Float64Array {
  const data = arrays?.get(name)?.data;
  if (data instanceof Float64Array) return data;
  return data ? Float64Array.from(data) : new Float64Array(0);
}
