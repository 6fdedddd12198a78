/** The path of the eigenvalues along a key, asked for as the other keys change. */

import { useMemo } from "preact/hooks";
import { useComputation } from "../../ui/useComputation";
import type { Analysis } from "../../wire/api";
import { reals } from "../../wire/frames";
import type { RequestError } from "../../wire/request";
import { type Path, joined } from "./eigen";

export interface LivePath {
  readonly path: Path | null;
  /** Whether the path is of the present values. */
  readonly isCurrent: boolean;
  readonly error: RequestError | null;
}

/** `key` is the swept one: its own value does not matter. */
export function usePath(set: readonly string[], key: string, analysis: Analysis | null): LivePath {
  const others = set.filter((option) => !option.startsWith(`${key}=`));
  const { frame, asked, current, error } = useComputation("/api/analysis", analysis && { set: others, analysis }, "path");
  const path = useMemo(() => {
    const array = frame?.arrays.get("eigenvalues");
    return frame && array ? joined(reals(frame, array.dimensions[0] ?? ""), reals(frame, "eigenvalues"), array.shape[1] ?? 0) : null;
  }, [frame]);
  // a path along another key is wrong, not old
  const isOfKey = JSON.stringify(asked?.["analysis"]) === JSON.stringify(analysis);
  return { path: isOfKey ? path : null, isCurrent: current || analysis === null, error };
}
