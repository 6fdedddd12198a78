/** Requests to the server: JSON, texts, and streams of frames, with errors that say what, where and what would be right. */

import { type Frame, FrameError, frames } from "./frames";

/** The place in the case text that an error speaks of. */
export interface Place {
  readonly source: string;
  readonly line: number;
  readonly column: number;
  readonly text: string;
}

export class RequestError extends Error {
  override readonly name = "RequestError";
  constructor(
    message: string,
    readonly status: number,
    readonly place: Place | null,
    readonly help: string | null,
    /** What else is wrong with the same case. */
    readonly others: readonly RequestError[] = [],
  ) {
    super(message);
  }
}

/** Each error alone. */
export function allOf(error: RequestError | null): readonly RequestError[] {
  if (!error) return [];
  const { message, status, place, help, others } = error;
  return others.length === 0 ? [error] : [new RequestError(message, status, place, help), ...others];
}

/** Whether a request was given up by us: nothing to tell. */
export function isAbort(error: unknown): boolean {
  return error instanceof DOMException && error.name === "AbortError";
}

/** Whether what was asked for is not itself wrong: asking once more may help. */
export function isPassing({ status }: RequestError): boolean {
  return status === 0 || status === 429 || status >= 500;
}

/** Any error as one that can be shown. */
export function asRequestError(error: unknown): RequestError {
  if (error instanceof RequestError) return error;
  if (error instanceof FrameError) return new RequestError(error.message, 0, null, "Reload the page.");
  if (error instanceof TypeError) {
    return new RequestError("the explorer does not answer", 0, null, "Is `judder explore` still running?");
  }
  return new RequestError(error instanceof Error ? error.message : String(error), 0, null, null);
}

function errorFrom(body: unknown, status: number): RequestError {
  return errorOf((body as { error?: Partial<RequestError> } | null)?.error, status);
}

function errorOf(error: Partial<RequestError> | undefined, status: number): RequestError {
  const message = error?.message ?? `the explorer answered with status ${status}`;
  const lost = status === 401 || status === 403 ? "Open the address that `judder explore` printed." : null;
  return new RequestError(message, status, error?.place ?? null, error?.help ?? lost, error?.others?.map((other) => errorOf(other, status)) ?? []);
}

/** The status of a server whose waiting room is full. */
const FULL = 503;
/** How often such a server is asked again, after how many seconds where it does not say, and after how many at most. */
const AGAIN = 4;
const SECONDS = 1;
const MOST_SECONDS = 10;

/** Asks, and asks again where the waiting room is full: after as long as the server says, then after twice as long each time. */
async function ask(path: string, options: RequestInit): Promise<Response> {
  for (let before = 0; ; before += 1) {
    const response = await fetch(path, options);
    if (response.status !== FULL || before === AGAIN) return response;
    void response.body?.cancel().catch(() => undefined);
    const told = Number(response.headers.get("Retry-After") ?? SECONDS);
    await pause(Math.min((told >= 0 ? told : SECONDS) * 2 ** before, MOST_SECONDS), options.signal);
  }
}

/** Waits, unless the request is given up. */
function pause(seconds: number, signal: AbortSignal | null | undefined): Promise<void> {
  return new Promise((resolve, reject) => {
    const stop = () => {
      clearTimeout(timer);
      reject(signal?.reason);
    };
    const timer = setTimeout(() => {
      signal?.removeEventListener("abort", stop);
      resolve();
    }, seconds * 1000);
    if (signal?.aborted) stop();
    else signal?.addEventListener("abort", stop, { once: true });
  });
}

async function respond(path: string, body: unknown, signal?: AbortSignal): Promise<Response> {
  const options: RequestInit = {
    credentials: "same-origin",
    ...(signal ? { signal } : {}),
    ...(body === undefined
      ? {}
      : { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(body) }),
  };
  const response = await ask(path, options);
  if (response.ok) return response;
  const error = errorFrom(await response.json().catch(() => null), response.status);
  if (error.status !== FULL) throw error;
  throw new RequestError(`${error.message} (asked ${AGAIN + 1} times)`, error.status, error.place, error.help);
}

export async function getJson<T>(path: string, signal?: AbortSignal): Promise<T> {
  return (await respond(path, undefined, signal)).json() as Promise<T>;
}

export async function postJson<T>(path: string, body: object, signal?: AbortSignal): Promise<T> {
  const answer = (await (await respond(path, body, signal)).json()) as T;
  signal?.throwIfAborted();
  return answer;
}

export async function postText(path: string, body: object, signal?: AbortSignal): Promise<string> {
  return (await respond(path, body, signal)).text();
}

/** The frames of an answer until its end; an error frame is thrown, and so is a stream that breaks off. */
export async function* postFrames(path: string, body: object, signal?: AbortSignal): AsyncGenerator<Frame, void, void> {
  const response = await respond(path, body, signal);
  if (!response.body) throw new FrameError("an answer without a body");
  // single frames (`/api/law`) come without an end frame
  let complete = false;
  for await (const frame of frames(response.body)) {
    // frames that came in one piece with one that was enough are told to nobody
    signal?.throwIfAborted();
    if (frame.kind === "error") throw errorFrom(frame.header, 200);
    complete = frame.kind !== "progress" && frame.kind !== "block";
    if (frame.kind === "end") return;
    yield frame;
  }
  if (!complete) throw new FrameError("the answer broke off");
}

const tab = Array.from(crypto.getRandomValues(new Uint8Array(8)), (byte) => byte.toString(16).padStart(2, "0")).join("");

/** The name under which a newer request of this tab and purpose cancels the older one on the server. */
export function slot(purpose: string): string {
  return `${tab}/${purpose}`;
}
