/** Computations that take their time: started, drawn as they come, followed or given up. */

import { useEffect, useRef, useState } from "preact/hooks";
import type { Analysis } from "../../wire/api";
import type { Frame } from "../../wire/frames";
import { Latest } from "../../wire/latest";
import { type RequestError, asRequestError, isAbort, postFrames, slot } from "../../wire/request";

export interface Run<T> {
  /** The newest result; while it is computed as far as it has come. */
  readonly result: T | null;
  /** Whether the result belongs to other values than those of the view. */
  readonly isStale: boolean;
  readonly busy: boolean;
  /** Whether the result is whole. */
  readonly complete: boolean;
  readonly progress: { readonly done: number; readonly of: number } | null;
  readonly error: RequestError | null;
  readonly start: () => void;
  readonly cancel: () => void;
}

/** Takes the frames of a run in their order; the result is what there is to show, null where nothing new is. */
export type Collector<T> = (frame: Frame) => T | null;

export interface RunRequest<T> {
  /** Under which a newer request cancels the older. */
  readonly purpose: string;
  readonly address: "/api/motion" | "/api/analysis";
  readonly set: readonly string[];
  /** One after the other. */
  readonly analyses: readonly Analysis[];
  readonly collect: () => Collector<T>;
  /** Whether it runs without being started. */
  readonly wanted: boolean;
  /** Whether it runs again as the view changes. */
  readonly live: boolean;
}

/** Pictures are drawn 20 times a second at most. */
const EVERY = 50;

type Shown<T> = Omit<Run<T>, "isStale" | "start" | "cancel"> & { readonly of: string };

export function useRun<T>(request: RunRequest<T>): Run<T> {
  const [shown, setShown] = useState<Shown<T>>({ result: null, of: "", busy: false, complete: false, progress: null, error: null });
  const latest = useRef(new Latest());
  const text = JSON.stringify({ set: request.set, analyses: request.analyses });
  const newest = useRef(request);
  newest.current = request;
  const start = () => {
    const request = newest.current;
    const change = (part: Partial<Shown<T>>) => setShown((last) => ({ ...last, ...part }));
    latest.current.submit((signal, drawn) => follow(request, text, signal, drawn, change));
  };
  const started = useRef(false);
  useEffect(() => {
    if (request.wanted && (request.live || !started.current)) start();
    started.current = request.wanted;
  }, [text, request.wanted, request.live]);
  useEffect(() => () => latest.current.stop(), []);
  const cancel = () => {
    latest.current.stop();
    setShown((last) => ({ ...last, busy: false }));
  };
  return { ...shown, isStale: shown.result !== null && shown.of !== text, start, cancel };
}

/** Sends the requests of a run and shows what comes. */
async function follow<T>(
  request: RunRequest<T>,
  of: string,
  signal: AbortSignal,
  drawn: () => void,
  change: (part: Partial<Shown<T>>) => void,
): Promise<void> {
  const take = request.collect();
  let fresh: Partial<Shown<T>> = {};
  let timer: ReturnType<typeof setTimeout> | undefined;
  const show = () => {
    timer = undefined;
    change(fresh);
    if (fresh.result) drawn();
    fresh = {};
  };
  change({ busy: true, complete: false, progress: null, error: null });
  try {
    for (const analysis of request.analyses) {
      const body = { set: request.set, analysis, slot: slot(request.purpose) };
      for await (const frame of postFrames(request.address, body, signal)) {
        if (frame.kind === "progress") fresh = { ...fresh, progress: progressOf(frame) };
        const result = take(frame);
        if (result !== null) fresh = { ...fresh, result, of };
        timer ??= setTimeout(show, EVERY);
      }
    }
    change({ ...fresh, complete: true, busy: false });
  } catch (failure) {
    // what follows an abort says itself whether something runs
    if (!isAbort(failure)) change({ ...fresh, busy: false, error: asRequestError(failure) });
  } finally {
    clearTimeout(timer);
  }
}

function progressOf(frame: Frame): { done: number; of: number } {
  return { done: Number(frame.header["done"] ?? 0), of: Number(frame.header["of"] ?? 0) };
}
