/** The path of the eigenvalues along a key, asked for as the other keys change. */

import { useEffect, useRef, useState } from "preact/hooks";
import type { Analysis } from "../../wire/api";
import { reals } from "../../wire/frames";
import { Latest } from "../../wire/latest";
import { type RequestError, asRequestError, isAbort, postFrames, slot } from "../../wire/request";
import { type Path, joined } from "./eigen";

export interface LivePath {
  readonly path: Path | null;
  /** Whether the path is of the present values. */
  readonly isCurrent: boolean;
  readonly error: RequestError | null;
}

/** `key` is the swept one: its own value does not matter. */
export function usePath(set: readonly string[], key: string, analysis: Analysis | null): LivePath {
  const [live, setLive] = useState<Omit<LivePath, "isCurrent"> & { readonly key: string; readonly of: string }>({ path: null, error: null, key: "", of: "" });
  const latest = useRef(new Latest());
  const others = set.filter((option) => !option.startsWith(`${key}=`));
  const text = analysis ? JSON.stringify({ set: others, analysis }) : "";
  useEffect(() => {
    if (text === "") return latest.current.stop();
    latest.current.submit(async (signal, shown) => {
      try {
        const body = { ...(JSON.parse(text) as object), slot: slot("path") };
        for await (const frame of postFrames("/api/analysis", body, signal)) {
          const array = frame.arrays.get("eigenvalues");
          if (frame.kind !== "outcome" || !array) continue;
          const along = reals(frame, array.dimensions[0] ?? "");
          setLive({ path: joined(along, reals(frame, "eigenvalues"), array.shape[1] ?? 0), error: null, key, of: text });
          shown();
        }
      } catch (failure) {
        if (!isAbort(failure)) setLive((last) => ({ ...last, error: asRequestError(failure) }));
      }
    });
  }, [text]);
  useEffect(() => () => latest.current.stop(), []);
  if (text === "") return { path: null, isCurrent: true, error: null };
  const { path, error, of } = live;
  return { path: live.key === key ? path : null, isCurrent: of === text, error };
}
