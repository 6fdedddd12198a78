/** Requests that take their time: what their frames bring, told as it comes. */

import type { Frame } from "./frames";
import { type RequestError, asRequestError, isAbort, postFrames } from "./request";

export interface Progress {
  readonly done: number;
  readonly of: number;
}

/** Where a computation stands. */
interface Standing {
  readonly busy: boolean;
  readonly progress: Progress | null;
  readonly error: RequestError | null;
}

export interface Asked {
  readonly path: string;
  readonly body: object;
}

export interface Following<T> {
  /** What a frame adds to the state; null where it adds nothing. */
  readonly take: (frame: Frame) => Partial<T> | null;
  readonly tell: (change: Partial<T & Standing>) => void;
  /** What is so when all has come. */
  readonly end?: Partial<T>;
}

/** Pictures are drawn 20 times a second at most. */
const EVERY = 50;

/** Sends the requests one after the other; what they bring is told in heaps, the first at once and the last at the end. An abort tells nothing. */
export async function follow<T>(asked: readonly Asked[], signal: AbortSignal, { take, tell, end }: Following<T>): Promise<void> {
  let heap: Partial<T & Standing> = {};
  let told = Number.NEGATIVE_INFINITY;
  let timer: ReturnType<typeof setTimeout> | undefined;
  const flush = (more: Partial<Standing> & Partial<T> = {}) => {
    clearTimeout(timer);
    timer = undefined;
    told = performance.now();
    tell({ ...heap, ...more });
    heap = {};
  };
  try {
    for (const { path, body } of asked) {
      for await (const frame of postFrames(path, body, signal)) {
        heap = { ...heap, ...(frame.kind === "progress" ? { progress: progressOf(frame) } : {}), ...take(frame) };
        const rest = told + EVERY - performance.now();
        if (rest > 0) timer ??= setTimeout(flush, rest);
        else flush();
      }
    }
    flush({ ...end, busy: false } as Partial<Standing> & Partial<T>);
  } catch (failure) {
    // what follows an abort says itself whether something runs
    if (!isAbort(failure)) flush({ busy: false, error: asRequestError(failure) } as Partial<Standing> & Partial<T>);
  } finally {
    clearTimeout(timer);
  }
}

export function progressOf(frame: Frame): Progress {
  return { done: Number(frame.header["done"] ?? 0), of: Number(frame.header["of"] ?? 0) };
}
