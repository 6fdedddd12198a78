/** One operating point, asked for as it changes. */

import { useEffect, useRef, useState } from "preact/hooks";
import { type Point, fetchPoint } from "../wire/api";
import { Latest } from "../wire/latest";
import { type RequestError, asRequestError, isAbort } from "../wire/request";

/** A pointer that moves on within this time, in milliseconds, asks for nothing. */
const REST = 40;

export interface LivePoint {
  readonly point: Point | null;
  /** The options that `point` belongs to; others are on their way where they differ. */
  readonly set: string;
  /** Why there is no newer point. */
  readonly error: RequestError | null;
}

/** The point with these options; none asks for nothing. */
export function usePoint(set: readonly string[] | null): LivePoint {
  const [live, setLive] = useState<LivePoint>({ point: null, set: "", error: null });
  const latest = useRef(new Latest());
  const text = set ? JSON.stringify(set) : "";
  useEffect(() => {
    if (text === "") {
      latest.current.stop();
      setLive({ point: null, set: "", error: null });
      return;
    }
    const ask = () =>
      latest.current.submit(async (signal) => {
        try {
          const point = await fetchPoint(JSON.parse(text) as string[], signal);
          setLive({ point, set: text, error: null });
        } catch (failure) {
          if (!isAbort(failure)) setLive((last) => ({ ...last, error: asRequestError(failure) }));
        }
      });
    const timer = setTimeout(ask, REST);
    return () => clearTimeout(timer);
  }, [text]);
  useEffect(() => () => latest.current.stop(), []);
  return live;
}
