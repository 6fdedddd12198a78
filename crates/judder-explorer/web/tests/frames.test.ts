import { describe, expect, it } from "vitest";
import { FrameDecoder, FrameError, frames, reals, codes } from "../src/wire/frames";
import { encode } from "./encode";

const NUMBERS = new Float64Array([1e-8, Number.NaN, -0, 0.1 + 0.2]);
const CODES = new Uint8Array([0, 3, 6, 0, 0, 0, 0, 0]);
const PAYLOAD = new Uint8Array([...new Uint8Array(NUMBERS.buffer), ...CODES]);
const MAP = encode(
  {
    kind: "map",
    title: "Kräfte über ṽ 🎻",
    arrays: [
      { name: "x", type: "f64", shape: [4], dimensions: ["x"], offset: 0, units: "1", long_name: null },
      { name: "classes", type: "u8", shape: [1, 3], offset: 32 },
      { name: "names", type: "text", shape: [2], values: ["a", "β"] },
      { name: "z", type: "complex", shape: [2], offset: 0 },
    ],
  },
  PAYLOAD,
);
const END = encode({ kind: "end", seconds: 0.5 });

function joined(...parts: Uint8Array[]): Uint8Array<ArrayBuffer> {
  const all = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}

describe("frames", () => {
  it("come out the same wherever the stream is split", () => {
    const bytes = joined(MAP, END, MAP);
    for (const size of [1, 3, 7, 8, 9, 64, 101, bytes.length]) {
      const decoder = new FrameDecoder();
      const found = [];
      for (let at = 0; at < bytes.length; at += size) found.push(...decoder.push(bytes.slice(at, at + size)));
      decoder.finish();
      expect(found.map((frame) => frame.kind), `chunks of ${size}`).toEqual(["map", "end", "map"]);
      for (const frame of [found[0], found[2]]) {
        expect(frame?.header["title"]).toBe("Kräfte über ṽ 🎻");
        expect([...reals(frame!, "x")].every((value, i) => Object.is(value, NUMBERS[i]))).toBe(true);
        expect([...codes(frame!, "classes")]).toEqual([0, 3, 6]);
        expect(frame?.arrays.get("names")?.texts).toEqual(["a", "β"]);
        expect(frame?.arrays.get("z")?.data.length).toBe(4);
      }
    }
  });

  it("are viewed in place where they lie aligned, and copied where not", () => {
    const aligned = new Uint8Array(new ArrayBuffer(MAP.length));
    aligned.set(MAP);
    const [there] = [...new FrameDecoder().push(aligned)];
    expect(reals(there!, "x").buffer).toBe(aligned.buffer);
    const odd = new Uint8Array(new ArrayBuffer(MAP.length + 3), 3);
    odd.set(MAP);
    const [copied] = [...new FrameDecoder().push(odd)];
    expect(reals(copied!, "x").buffer).not.toBe(odd.buffer);
    expect(reals(copied!, "x")[3]).toBe(0.1 + 0.2);
  });

  it("that are broken are refused", () => {
    const decoder = new FrameDecoder();
    void [...decoder.push(MAP.subarray(0, MAP.length - 1))];
    expect(() => decoder.finish()).toThrow(FrameError);
    const unpadded = Uint8Array.from(MAP);
    new DataView(unpadded.buffer).setUint32(0, 13, true);
    expect(() => [...new FrameDecoder().push(unpadded)]).toThrow(FrameError);
    const beyond = encode({ kind: "map", arrays: [{ name: "x", type: "f64", shape: [9], offset: 0 }] }, PAYLOAD);
    expect(() => [...new FrameDecoder().push(beyond)]).toThrow(/beyond its frame/);
    const unknown = encode({ kind: "map", arrays: [{ name: "x", type: "f16", shape: [1], offset: 0 }] }, PAYLOAD);
    expect(() => [...new FrameDecoder().push(unknown)]).toThrow(/f16/);
    const html = new TextEncoder().encode("<!doctype html><title>Not found</title>");
    expect(() => [...new FrameDecoder().push(html)]).toThrow(FrameError);
  });

  it("close the stream when nobody wants more", async () => {
    let cancelled = false;
    const stream = new ReadableStream<Uint8Array>({
      pull: (controller) => controller.enqueue(MAP.slice()),
      cancel: () => {
        cancelled = true;
      },
    });
    for await (const frame of frames(stream)) {
      expect(frame.kind).toBe("map");
      break;
    }
    expect(cancelled).toBe(true);
  });
});
