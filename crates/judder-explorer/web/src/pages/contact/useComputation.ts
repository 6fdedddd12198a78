/** What the server computes for a part of the page: live, or on demand where it takes long; with progress and a way to stop it. */

import { useCallback, useEffect, useRef, useState } from "preact/hooks";
import { type Progress, follow } from "../../wire/follow";
import type { Frame } from "../../wire/frames";
import { Latest } from "../../wire/latest";
import { type RequestError, slot } from "../../wire/request";

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

/** `request` is the body without its slot; null asks for nothing. Unless `live`, it waits for `start`. */
export function useComputation(path: string, request: object | null, purpose: string, live = true): Computation {
  const [state, setState] = useState<State>(NOTHING);
  const latest = useRef(new Latest());
  const text = request ? JSON.stringify(request) : "";
  const run = useCallback(
    (text: string) =>
      latest.current.submit((signal, shown) => {
        const tell = (change: Partial<State>) => {
          setState((state) => ({ ...state, ...change }));
          if (change.frame) shown();
        };
        tell({ busy: true, progress: null, stopped: false });
        const body = { ...(JSON.parse(text) as object), slot: slot(purpose) };
        return follow<State>([{ path, body }], signal, { take: (frame) => (frame.kind === "progress" ? null : { frame, of: text, error: null }), tell });
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
