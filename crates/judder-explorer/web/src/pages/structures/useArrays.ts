/** Arrays of an analysis of the study, asked for as what is shown changes. */

import { useEffect, useRef, useState } from "preact/hooks";
import type { FrameArray } from "../../wire/frames";
import { Latest } from "../../wire/latest";
import { type RequestError, asRequestError, isAbort, postFrames, slot } from "../../wire/request";

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

const NOTHING = { arrays: null, part: {}, error: null, busy: false } as const;

/** `purpose` tells requests of one page apart: a newer one of the same purpose ends the older one. */
export function useArrays(analysis: string, variables: readonly string[], part: Part = {}, purpose = "arrays"): LiveArrays {
  const [live, setLive] = useState<Omit<LiveArrays, "cancel"> & { of: string }>({ ...NOTHING, of: "" });
  const latest = useRef(new Latest());
  const text = variables.length === 0 ? "" : JSON.stringify({ analysis, variables, ...part });
  useEffect(() => {
    if (text === "") {
      latest.current.stop();
      return setLive({ ...NOTHING, of: analysis });
    }
    latest.current.submit(async (signal) => {
      // arrays of another analysis are wrong, those of another part are only old
      setLive((before) => ({ ...(before.of === analysis ? before : NOTHING), of: analysis, busy: true }));
      try {
        const body = { ...(JSON.parse(text) as object), slot: slot(`study/${purpose}`) };
        for await (const frame of postFrames("/api/study/arrays", body, signal)) {
          if (frame.kind === "arrays") setLive({ arrays: frame.arrays, part, error: null, busy: false, of: analysis });
        }
      } catch (failure) {
        // what follows an abort says itself whether something runs
        if (!isAbort(failure)) setLive((before) => ({ ...before, error: asRequestError(failure), busy: false }));
      }
    });
  }, [text]);
  useEffect(() => () => latest.current.stop(), []);
  const { of, ...rest } = live;
  const cancel = () => {
    latest.current.stop();
    setLive((before) => ({ ...before, busy: false }));
  };
  return { ...(of === analysis ? rest : { ...NOTHING, busy: text !== "" }), cancel };
}

/** The numbers of an array; empty where there is none of this name. */
export function numbers(arrays: Arrays | null, name: string): Float64Array {
  const data = arrays?.get(name)?.data;
  if (data instanceof Float64Array) return data;
  return data ? Float64Array.from(data) : new Float64Array(0);
}
