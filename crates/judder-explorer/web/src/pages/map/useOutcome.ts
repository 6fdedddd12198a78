/** What an analysis beside the map leaves, asked for as the view changes. */

import { useEffect, useRef, useState } from "preact/hooks";
import type { Analysis } from "../../wire/api";
import type { Frame } from "../../wire/frames";
import { Latest } from "../../wire/latest";
import { type RequestError, asRequestError, isAbort, postFrames, slot } from "../../wire/request";

/** Analyses may take far longer than a map: they wait until a slider rests, in milliseconds. */
const REST = 150;

export interface LiveOutcome {
  /** The newest; of the values before while another is on its way, or while none is asked for. */
  readonly outcome: Frame | null;
  /** Whether it is of what is asked for. */
  readonly isCurrent: boolean;
  readonly error: RequestError | null;
}

/** The outcome of an analysis with these options; without an analysis nothing is asked for. */
export function useOutcome(purpose: string, set: readonly string[], analysis: Analysis | null): LiveOutcome {
  const [live, setLive] = useState<Omit<LiveOutcome, "isCurrent"> & { readonly of: string }>({ outcome: null, error: null, of: "" });
  const latest = useRef(new Latest());
  const text = analysis ? JSON.stringify({ set, analysis }) : "";
  useEffect(() => {
    if (text === "") return latest.current.stop();
    const ask = async (signal: AbortSignal) => {
      try {
        const body = { ...(JSON.parse(text) as object), slot: slot(purpose) };
        for await (const frame of postFrames("/api/analysis", body, signal)) {
          if (frame.kind === "outcome") setLive({ outcome: frame, error: null, of: text });
        }
      } catch (failure) {
        if (!isAbort(failure)) setLive((last) => ({ ...last, error: asRequestError(failure) }));
      }
    };
    latest.current.stop();
    const timer = setTimeout(() => latest.current.submit(ask), REST);
    return () => clearTimeout(timer);
  }, [text]);
  useEffect(() => () => latest.current.stop(), []);
  return { outcome: live.outcome, isCurrent: text !== "" && live.of === text, error: text === "" ? null : live.error };
}
