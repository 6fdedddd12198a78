// @vitest-environment happy-dom
import { render } from "preact";
import { act } from "preact/test-utils";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { type Run, useRun } from "../src/pages/point/useRun";
import { encode } from "./encode";

let run: Run<number>;
let asked: { body: string; signal: AbortSignal; send: (frame: object) => void; end: () => void }[] = [];

function Probe({ set, wanted, live }: { readonly set: readonly string[]; readonly wanted: boolean; readonly live: boolean }) {
  const collect = () => (frame: { kind: string; header: Readonly<Record<string, unknown>> }) => (frame.kind === "outcome" ? Number(frame.header["value"]) : null);
  run = useRun<number>({ purpose: "probe", address: "/api/analysis", set, analyses: [{ name: "a", kind: "motion" }], collect, wanted, live });
  return null;
}

const settle = () => act(() => new Promise<void>((resolve) => setTimeout(resolve, 80)));
const show = (set: readonly string[], wanted: boolean, live = false) => act(() => render(<Probe set={set} wanted={wanted} live={live} />, document.body));
const answer = async (value: number) => {
  const last = asked.at(-1);
  last?.send({ kind: "outcome", value });
  last?.end();
  await settle();
};

beforeEach(() => {
  asked = [];
  vi.stubGlobal("fetch", (_path: string, { body, signal }: { body: string; signal: AbortSignal }) => {
    const stream = new ReadableStream<Uint8Array>({
      start(controller) {
        signal.addEventListener("abort", () => controller.error(new DOMException("given up", "AbortError")));
        const send = (frame: object) => controller.enqueue(encode(frame));
        asked.push({ body, signal, send, end: () => (send({ kind: "end" }), controller.close()) });
      },
    });
    return Promise.resolve({ ok: true, body: stream });
  });
});
afterEach(() => {
  act(() => render(null, document.body));
  vi.unstubAllGlobals();
});

describe("a run", () => {
  it("waits to be wanted, and is marked once it belongs to other values", async () => {
    show(["a=1"], false);
    expect(asked).toHaveLength(0);
    show(["a=1"], true);
    expect(run.busy).toBe(true);
    await settle();
    await answer(7);
    expect(run).toMatchObject({ result: 7, isStale: false, busy: false, complete: true });
    show(["a=2"], true);
    await settle();
    expect(run).toMatchObject({ result: 7, isStale: true, busy: false });
    expect(asked).toHaveLength(1);
  });

  it("follows the values where it is live", async () => {
    show(["a=1"], true, true);
    await settle();
    await answer(7);
    show(["a=2"], true, true);
    await settle();
    await answer(8);
    expect(asked.map(({ body }) => JSON.parse(body).set)).toEqual([["a=1"], ["a=2"]]);
    expect(run).toMatchObject({ result: 8, isStale: false });
  });

  it("is given up at once, and by leaving the page", async () => {
    show(["a=1"], true);
    await settle();
    act(() => run.cancel());
    await settle();
    expect(asked[0]?.signal.aborted).toBe(true);
    expect(run).toMatchObject({ busy: false, complete: false, error: null });
    act(() => run.start());
    await settle();
    act(() => render(null, document.body));
    expect(asked[1]?.signal.aborted).toBe(true);
  });

  it("tells why it failed", async () => {
    show(["a=1"], true);
    await settle();
    asked[0]?.send({ kind: "error", error: { message: "no cycle", place: null, help: "start elsewhere" } });
    await settle();
    expect(run.error).toMatchObject({ message: "no cycle", help: "start elsewhere" });
    expect(run.busy).toBe(false);
  });
});
