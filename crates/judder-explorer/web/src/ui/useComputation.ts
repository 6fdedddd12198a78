/** What the server answers to what a part of a page asks: live, or on demand where it takes long; with progress and a way to stop it. */

import { useCallback, useEffect, useMemo, useRef, useState } from "preact/hooks";
import { type Progress, follow } from "../wire/follow";
import type { Frame } from "../wire/frames";
import { Latest } from "../wire/latest";
import { type RequestError, slot } from "../wire/request";

export interface Computation {
  /** The last good answer. */
  readonly frame: Frame | null;
  /** What `frame` answers. */
  readonly asked: Readonly<Record<string, unknown>> | null;
  /** Whether that is what is asked for now. */
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

interface How {
  /** Whether it is asked for as it changes, not waiting for `start`. */
  readonly live?: boolean;
  /** So long what is asked for must not change before it is, in milliseconds. */
  readonly rest?: number;
  /** Whether what runs is given up at once as something else is asked for: it is not worth to be shown. */
  readonly hasty?: boolean;
}

/** `request` is the body without its slot; null asks for nothing. A newer one of the same purpose ends the older one. */
export function useComputation(path: string, request: object | null, purpose: string, { live = true, rest = 0, hasty = false }: How = {}): Computation {
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
    if (text !== "" && live) {
      if (hasty) latest.current.stop();
      if (rest === 0) return run(text);
      const timer = setTimeout(() => run(text), rest);
      return () => clearTimeout(timer);
    }
    latest.current.stop();
    setState((state) => ({ ...state, busy: false, progress: null, stopped: false, error: null }));
  }, [text, live, run]);
  useEffect(() => () => latest.current.stop(), []);
  const stop = () => {
    latest.current.stop();
    setState((state) => ({ ...state, busy: false, progress: null, stopped: true }));
  };
  const { of, ...shown } = state;
  const asked = useMemo(() => (of === "" ? null : (JSON.parse(of) as Record<string, unknown>)), [of]);
  return { ...shown, asked, current: text !== "" && of === text, start: () => run(text), stop };
}
