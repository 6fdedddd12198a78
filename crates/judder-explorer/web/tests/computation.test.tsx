// @vitest-environment happy-dom
import { render } from "preact";
import { act } from "preact/test-utils";
import { afterEach, describe, expect, it, vi } from "vitest";
import { type Computation, useComputation } from "../src/ui/useComputation";
import { encode } from "./encode";

interface Asked {
  readonly body: Record<string, unknown>;
  readonly signal: AbortSignal;
  readonly send: (...frames: Uint8Array[]) => void;
  readonly fail: (status: number) => void;
}

/** A server whose answers the test writes. */
function listen(): Asked[] {
  const asked: Asked[] = [];
  vi.stubGlobal("fetch", (_: string, { body, signal }: { body: string; signal: AbortSignal }) => {
    return new Promise<Response>((resolve, reject) => {
      let stream: ReadableStreamDefaultController<Uint8Array>;
      const answer = new ReadableStream<Uint8Array>({ start: (controller) => void (stream = controller) });
      signal.addEventListener("abort", () => {
        const abort = new DOMException("given up", "AbortError");
        reject(abort);
        stream.error(abort);
      });
      const send = (...frames: Uint8Array[]) => {
        resolve({ ok: true, body: answer } as unknown as Response);
        for (const frame of frames) stream.enqueue(frame);
      };
      const fail = (status: number) => resolve(Response.json({ error: { message: "refused" } }, { status }));
      asked.push({ body: JSON.parse(body) as Record<string, unknown>, signal, send, fail });
    });
  });
  return asked;
}

afterEach(() => vi.unstubAllGlobals());

const rest = () => act(() => new Promise<void>((resolve) => setTimeout(resolve, 5)));

interface Shown {
  readonly now: () => Computation;
  readonly ask: (request: object) => void;
}

/** A component with the hook, whose request can change. */
function show(first: object, live: boolean): Shown {
  const host = document.createElement("div");
  let computation: Computation | undefined;
  const Asking = ({ request }: { readonly request: object }) => {
    computation = useComputation("/api/analysis", request, "fit", { live });
    return null;
  };
  const ask = (request: object) => void act(() => render(<Asking request={request} />, host));
  ask(first);
  return { now: () => computation as Computation, ask };
}

const progress = encode({ kind: "progress", done: 3, of: 9 });
const outcome = encode({ kind: "outcome", scalars: {} });
const end = encode({ kind: "end" });

describe("a computation", () => {
  it("asks at once where it is live, and tells progress and outcome", async () => {
    const asked = listen();
    const { now } = show({ set: ["a=1"] }, true);
    await rest();
    expect(asked[0]?.body).toMatchObject({ set: ["a=1"], slot: expect.stringMatching(/\/fit$/) });
    expect(now()).toMatchObject({ busy: true, current: false, progress: null });
    asked[0]?.send(progress);
    await rest();
    expect(now()).toMatchObject({ busy: true, progress: { done: 3, of: 9 } });
    asked[0]?.send(outcome, end);
    await rest();
    expect(now()).toMatchObject({ busy: false, current: true, stopped: false, error: null });
    expect(now().frame?.kind).toBe("outcome");
  });

  it("waits to be started where it takes long, ends its request when stopped, and starts again", async () => {
    const asked = listen();
    const { now } = show({ set: [] }, false);
    await rest();
    expect(asked).toHaveLength(0);
    now().start();
    await rest();
    expect(now().busy).toBe(true);
    now().stop();
    await rest();
    expect([asked[0]?.signal.aborted, now().busy, now().stopped, now().error]).toEqual([true, false, true, null]);
    now().start();
    await rest();
    asked[1]?.send(outcome, end);
    await rest();
    expect(now()).toMatchObject({ current: true, stopped: false });
  });

  it("keeps the last answer beside an error, and says that it is not current", async () => {
    const asked = listen();
    const { now, ask } = show({ set: ["a=1"] }, true);
    await rest();
    asked[0]?.send(outcome, end);
    await rest();
    ask({ set: ["a=2"] });
    await rest();
    asked[1]?.fail(422);
    await rest();
    expect(now()).toMatchObject({ busy: false, current: false, error: { message: "refused", status: 422 } });
    expect(now().frame?.kind).toBe("outcome");
  });
});
