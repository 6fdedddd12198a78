/** What the server computes for a part of the page: live, or on demand where it takes long; with progress and a way to stop it. */

import { useCallback, useEffect, useRef, useState } from "preact/hooks";
import type { Frame } from "../../wire/frames";
import { Latest } from "../../wire/latest";
import { type RequestError, asRequestError, isAbort, postFrames, slot } from "../../wire/request";

export interface Progress {
  readonly done: number;
  readonly of: number;
}

export interface Computation {
  /** The last good answer. */
  readonly frame: Frame | null;
  /** Whether `frame` is the answer to what is asked for now. */
  readonly current: boolean;
  readonly busy: boolean;
  readonly progress: Progress | null;
  readonly stopped: boolean;
  readonly error: RequestError | null;
  readonly start: () => void;
  readonly stop: () => void;
}

interface State {
  readonly frame: Frame | null;
  /** The request that `frame` answers. */
  readonly of: string;
  readonly busy: boolean;
  readonly progress: Progress | null;
  readonly stopped: boolean;
  readonly error: RequestError | null;
}

const NOTHING: State = { frame: null, of: "", busy: false, progress: null, stopped: false, error: null };
/** Progress is drawn at most so often, in milliseconds. */
const DRAWN_EVERY = 60;

/** `request` is the body without its slot; null asks for nothing. Unless `live`, it waits for `start`. */
export function useComputation(path: string, request: object | null, purpose: string, live = true): Computation {
  const [state, setState] = useState<State>(NOTHING);
  const latest = useRef(new Latest());
  const text = request ? JSON.stringify(request) : "";
  const run = useCallback(
    (text: string) =>
      latest.current.submit(async (signal, shown) => {
        setState((state) => ({ ...state, busy: true, progress: null, stopped: false }));
        try {
          await follow(path, text, purpose, signal, (change) => {
            if (change.frame) shown();
            setState((state) => ({ ...state, ...change }));
          });
          setState((state) => ({ ...state, busy: false }));
        } catch (failure) {
          // what follows an abort says itself whether something runs
          if (!isAbort(failure)) setState((state) => ({ ...state, busy: false, error: asRequestError(failure) }));
        }
      }),
    [path, purpose],
  );
  useEffect(() => {
    if (text !== "" && live) return run(text);
    latest.current.stop();
    setState((state) => ({ ...state, busy: false, progress: null, stopped: false, error: null }));
  }, [text, live, run]);
  useEffect(() => () => latest.current.stop(), []);
  const stop = () => {
    latest.current.stop();
    setState((state) => ({ ...state, busy: false, progress: null, stopped: true }));
  };
  const { of, ...rest } = state;
  return { ...rest, current: text !== "" && of === text, start: () => run(text), stop };
}

/** Tells what the frames of one request bring. */
async function follow(path: string, text: string, purpose: string, signal: AbortSignal, tell: (change: Partial<State>) => void): Promise<void> {
  let drawn = 0;
  for await (const frame of postFrames(path, { ...(JSON.parse(text) as object), slot: slot(purpose) }, signal)) {
    if (frame.kind !== "progress") {
      tell({ frame, of: text, error: null });
    } else if (performance.now() - drawn > DRAWN_EVERY) {
      drawn = performance.now();
      tell({ progress: { done: Number(frame.header["done"]), of: Number(frame.header["of"]) } });
    }
  }
}
