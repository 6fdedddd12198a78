/** Computations that take their time: started, drawn as they come, followed or given up. */

import { useEffect, useRef, useState } from "preact/hooks";
import { type Standing, useStanding } from "../../ui/standing";
import type { Analysis } from "../../wire/api";
import { type Progress, follow } from "../../wire/follow";
import type { Frame } from "../../wire/frames";
import { Latest } from "../../wire/latest";
import { type RequestError, slot } from "../../wire/request";

export interface Run<T> {
  /** The newest result; while it is computed as far as it has come. */
  readonly result: T | null;
  /** Whether the result belongs to other values than those of the view. */
  readonly isStale: boolean;
  readonly busy: boolean;
  /** Whether what is computed, or was last asked for, is of the present values. */
  readonly isForNow: boolean;
  /** Whether the result is whole. */
  readonly complete: boolean;
  readonly progress: Progress | null;
  readonly error: RequestError | null;
  readonly start: () => void;
  readonly cancel: () => void;
}

/** How the charts of a run stand: with other values beside them, or computed anew for these. */
export function useRunStanding({ result, isStale, busy, isForNow, progress, error }: Run<unknown>): Standing | null {
  return useStanding({ has: result !== null, isCurrent: !isStale, busy: busy && isForNow, progress, error: isForNow ? error : null }, result);
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

type Shown<T> = Omit<Run<T>, "isStale" | "isForNow" | "start" | "cancel"> & { readonly of: string; readonly asked: string };

export function useRun<T>(request: RunRequest<T>): Run<T> {
  const [shown, setShown] = useState<Shown<T>>({ result: null, of: "", asked: "", busy: false, complete: false, progress: null, error: null });
  const latest = useRef(new Latest());
  const text = JSON.stringify({ set: request.set, analyses: request.analyses });
  const newest = useRef(request);
  newest.current = request;
  const start = () => {
    const request = newest.current;
    const asked = request.analyses.map((analysis) => ({ path: request.address, body: { set: request.set, analysis, slot: slot(request.purpose) } }));
    const collect = request.collect();
    const take = (frame: Frame) => {
      const result = collect(frame);
      return result === null ? null : { result, of: text };
    };
    latest.current.submit((signal, drawn) => {
      const tell = (part: Partial<Shown<T>>) => {
        setShown((last) => ({ ...last, ...part }));
        if (part.result) drawn();
      };
      tell({ busy: true, asked: text, complete: false, progress: null, error: null } as Partial<Shown<T>>);
      return follow<Shown<T>>(asked, signal, { take, tell, end: { complete: true } as Partial<Shown<T>> });
    });
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
  return { ...shown, isForNow: shown.asked === text, isStale: shown.result !== null && shown.of !== text, start, cancel };
}
