import { afterEach, describe, expect, it, vi } from "vitest";
import { Latest } from "../src/wire/latest";
import { RequestError, asRequestError, postFrames, postJson, slot } from "../src/wire/request";
import { encode } from "./encode";

afterEach(() => vi.unstubAllGlobals());

function answerWith(response: Response): ReturnType<typeof vi.fn> {
  const fetch = vi.fn(async () => response);
  vi.stubGlobal("fetch", fetch);
  return fetch;
}

const place = { source: "case.toml", line: 3, column: 1, text: "velocity = -1" };

describe("requests", () => {
  it("throw what the server says, with place and help", async () => {
    answerWith(Response.json({ error: { message: "speeds are positive", place, help: "1 mm/s" } }, { status: 422 }));
    const error = await postJson("/api/point", { set: [] }).catch((error: unknown) => error);
    expect(error).toBeInstanceOf(RequestError);
    expect(error).toMatchObject({ message: "speeds are positive", status: 422, place, help: "1 mm/s" });
  });

  it("say what to do when the server is gone or has no error to tell", async () => {
    answerWith(new Response("<html>", { status: 403 }));
    await expect(postJson("/api/point", {})).rejects.toMatchObject({ status: 403, help: /judder explore/ });
    expect(asRequestError(new TypeError("Failed to fetch")).message).toBe("the explorer does not answer");
  });

  it("give frames until the end, throw error frames, and tell a stream that breaks off", async () => {
    const map = encode({ kind: "map" });
    const kinds = async (...frames: Uint8Array<ArrayBuffer>[]) => {
      answerWith(new Response(new Blob(frames)));
      const found: string[] = [];
      for await (const frame of postFrames("/api/map", {})) found.push(frame.kind);
      return found;
    };
    expect(await kinds(map, encode({ kind: "end" }))).toEqual(["map"]);
    await expect(kinds(map, encode({ kind: "error", error: { message: "stopped" } }))).rejects.toThrow("stopped");
    await expect(kinds(map, encode({ kind: "progress" }))).rejects.toThrow("broke off");
    await expect(kinds(map, map.slice(0, 9))).rejects.toThrow("ended within a frame");
  });

  it("tell no frame after an abort, though it has come already", async () => {
    answerWith(new Response(new Blob([encode({ kind: "map", stage: "coarse" }), encode({ kind: "map", stage: "exact" }), encode({ kind: "end" })])));
    const abort = new AbortController();
    const found: unknown[] = [];
    const read = async () => {
      for await (const frame of postFrames("/api/map", {}, abort.signal)) {
        found.push(frame.header["stage"]);
        abort.abort();
      }
    };
    await expect(read()).rejects.toThrow(expect.objectContaining({ name: "AbortError" }));
    expect(found).toEqual(["coarse"]);
  });

  it("are asked again where the waiting room is full, as often as is told, and no more once they are given up", async () => {
    vi.useFakeTimers();
    const full = () => Response.json({ error: { message: "12 requests wait already" } }, { status: 503, headers: { "Retry-After": "2" } });
    const times: number[] = [];
    const answers = (count: number) => {
      times.length = 0;
      const start = Date.now();
      vi.stubGlobal("fetch", async () => {
        times.push((Date.now() - start) / 1000);
        return times.length > count ? Response.json({ point: 1 }) : full();
      });
    };
    answers(2);
    const point = postJson("/api/point", {});
    await vi.runAllTimersAsync();
    expect(await point).toEqual({ point: 1 });
    expect(times).toEqual([0, 2, 6]);
    answers(100);
    const never = postJson("/api/point", {}).catch((error: unknown) => error);
    await vi.runAllTimersAsync();
    expect(await never).toMatchObject({ status: 503, message: "12 requests wait already (asked 5 times)" });
    expect(times).toEqual([0, 2, 6, 14, 24]);
    answers(100);
    const abort = new AbortController();
    const left = postJson("/api/point", {}, abort.signal).catch((error: unknown) => error);
    await vi.advanceTimersByTimeAsync(3000);
    abort.abort();
    expect(await left).toMatchObject({ name: "AbortError" });
    await vi.runAllTimersAsync();
    expect(times).toEqual([0, 2]);
    vi.useRealTimers();
  });

  it("share a tab's id between purposes", () => {
    expect(slot("map").split("/")[0]).toBe(slot("point").split("/")[0]);
    expect(slot("map")).toMatch(/^[0-9a-f]{16}\/map$/);
  });
});

describe("the newest work", () => {
  const rest = () => new Promise((resolve) => setTimeout(resolve, 0));

  it("waits alone, while the one in flight shows something first", async () => {
    const latest = new Latest();
    const ran: string[] = [];
    const release: (() => void)[] = [];
    const work = (name: string) => (signal: AbortSignal, shown: () => void) =>
      new Promise<void>((resolve) => {
        ran.push(name);
        release.push(shown);
        signal.addEventListener("abort", () => {
          ran.push(`${name} aborted`);
          resolve();
        });
      });
    latest.submit(work("a"));
    latest.submit(work("b"));
    latest.submit(work("c"));
    await rest();
    expect(ran).toEqual(["a"]);
    release[0]?.();
    await rest();
    expect(ran).toEqual(["a", "a aborted", "c"]);
    release[1]?.();
    latest.submit(work("d"));
    await rest();
    expect(ran.slice(3)).toEqual(["c aborted", "d"]);
    latest.stop();
    await rest();
    expect(ran.at(-1)).toBe("d aborted");
  });

  it("does not wait longer than its patience", async () => {
    const latest = new Latest(5);
    const aborted = new Promise<void>((resolve) =>
      latest.submit((signal) => new Promise((done) => signal.addEventListener("abort", () => (resolve(), done())))),
    );
    const next = new Promise<void>((resolve) => latest.submit(async () => resolve()));
    await aborted;
    await next;
  });

  it("is not kept from running by an older one that ends late", async () => {
    const latest = new Latest();
    let end: () => void = () => undefined;
    const ran: string[] = [];
    latest.submit((_, shown) => {
      shown();
      return new Promise((resolve) => (end = resolve));
    });
    latest.submit((signal) => new Promise((resolve) => (ran.push("b"), signal.addEventListener("abort", () => (ran.push("b aborted"), resolve())))));
    expect(ran).toEqual(["b"]);
    end();
    await rest();
    expect(ran, "the end of the older is not that of the newer").toEqual(["b"]);
    latest.stop();
    expect(ran).toEqual(["b", "b aborted"]);
  });

  it("goes on after an error", async () => {
    const latest = new Latest();
    latest.submit(async () => {
      throw new Error("broken");
    });
    await new Promise<void>((resolve) => latest.submit(async () => resolve()));
  });
});
