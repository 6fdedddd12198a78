import { readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, it } from "vitest";
import { plainText, spans, widthOf } from "../src/chart/markup";
import { type Scale, moved, part, rangeOf, shrink, stretch, usable, zoomed } from "../src/chart/scale";
import { secondTicks } from "../src/chart/second";
import { namedTicks, ticks } from "../src/chart/ticks";

interface Marked {
  readonly scale: Scale;
  readonly range: readonly [number, number];
  readonly room: number;
  readonly major: readonly (readonly [number, string])[];
  readonly minor: readonly number[];
  readonly exponent: number | null;
}

/** Written by the tests of `judder-report` from the ticks of drawings. */
const MARKED = JSON.parse(readFileSync(join(import.meta.dirname, "ticks.json"), "utf8")) as readonly Marked[];

describe("ticks", () => {
  it("are those of drawings, on axes of every kind", () => {
    expect(MARKED.length).toBeGreaterThan(60);
    for (const { scale, range, room, major, minor, exponent } of MARKED) {
      const own = ticks(scale, range, room);
      const where = `${JSON.stringify(scale)} ${range} ${room}`;
      expect(own.major.map((tick) => tick.label), where).toEqual(major.map(([, label]) => label));
      expect(own.exponent, where).toBe(exponent);
      // powers of ten are rounded otherwise here and there
      const same = (values: readonly number[], others: readonly number[]) =>
        values.length === others.length && values.every((value, k) => Math.abs(value - (others[k] as number)) <= 1e-12 * Math.max(Math.abs(value), (range[1] - range[0]) * 1e-3));
      expect(same(own.major.map((tick) => tick.value), major.map(([value]) => value)), where).toBe(true);
      expect(same(own.minor, minor), where).toBe(true);
    }
  });

  it("find names in the place of numbers", () => {
    const names = [[0, "velocity"], [1, "load"], [2, "mass"]] as const;
    expect(namedTicks(names, "linear", [-0.5, 1.5]).major.map((tick) => tick.label)).toEqual(["velocity", "load"]);
  });

  it("of a second axis stand where its values are, forwards and backwards", () => {
    for (const value of [[10, 10, 40], [40, 10, 10]]) {
      const { major } = secondTicks({ label: "", x: [0, 1, 2], value }, "linear", [0, 2], 5);
      expect(major.length).toBeGreaterThan(2);
      for (const tick of major) {
        const share = (Number(tick.label) - 10) / 30;
        expect(tick.value).toBeCloseTo(value[0] === 10 ? 1 + share : 1 - share, 12);
      }
    }
    expect(secondTicks({ label: "", x: [0, 2], value: [5, 5] }, "linear", [0, 2], 5).major).toEqual([]);
  });

  it("are ascending, inside and few, whatever the range", () => {
    for (const scale of ["log", "linear"] as const) {
      for (let exponent = -12; exponent < 12; exponent += 0.7) {
        for (const width of [1e-6, 0.1, 3, 1e5]) {
          const from = 3.7 * 10 ** exponent;
          const range = [from, from * (1 + width)] as const;
          const { major, minor } = ticks(scale, range, 6);
          const values = major.map((tick) => tick.value);
          expect(values, `${scale} ${range}`).toEqual([...values].sort((a, b) => a - b));
          expect(minor).toEqual([...minor].sort((a, b) => a - b));
          expect(values.every((value) => value >= range[0] * (1 - 1e-8) && value <= range[1] * (1 + 1e-8))).toBe(true);
          expect(major.filter((tick) => tick.label !== "").length).toBeLessThanOrEqual(10);
        }
      }
    }
  });
});

describe("labels", () => {
  it("raise, lower and slant", () => {
    expect(spans("10^{−3}")).toEqual([
      { text: "10", level: 0, italic: false },
      { text: "−3", level: 1, italic: false },
    ]);
    expect(spans("$τ̃_{0,crit}$/2").map(({ text, level, italic }) => [text, level, italic])).toEqual([
      ["τ̃", 0, true],
      ["0,crit", -1, false],
      ["/2", 0, false],
    ]);
    expect(spans("a_b {c} 5$").map((span) => span.text)).toEqual(["a_b {c} 5$"]);
    expect(plainText("Time $t$ (10^{−3} s)")).toBe("Time t (10^−3 s)");
    expect(widthOf("")).toBe(0);
  });
});

describe("ranges", () => {
  it("are those of the finite values, and can be drawn in any case", () => {
    expect(rangeOf("linear", [[1, Number.NaN, 3]])).toEqual([1, 3]);
    expect(rangeOf("log", [[-1, 0, 1e-3, 10, Number.POSITIVE_INFINITY]])).toEqual([1e-3, 10]);
    expect(rangeOf("log", [[]])).toEqual([0.1, 10]);
    for (const [scale, value] of [["linear", 0], ["linear", -5], ["log", 7]] as const) {
      const range = rangeOf(scale, [[value]]);
      expect(usable(scale, range), `${scale} ${value}`).toBe(true);
      expect(range[0] < value && value < range[1]).toBe(true);
    }
  });

  it("of both signs go there and back, and are zoomed", () => {
    const scale: Scale = { "symmetric-log": { linear: 1e-3 } };
    for (const value of [-1e5, -1e-3, -2e-4, 0, 5e-4, 1e-3, 7]) expect(Math.abs(shrink(scale, stretch(scale, value)) - value)).toBeLessThanOrEqual(1e-12 * Math.abs(value));
    expect(usable(scale, rangeOf(scale, [[0, 0]]))).toBe(true);
    let range = [-10, 10] as readonly [number, number];
    for (let step = 0; step < 300; step += 1) range = zoomed(scale, range, 0.5, 0.7);
    expect(range[0]).toBeLessThan(range[1]);
    expect(range[0]).toBeGreaterThan(0);
  });

  it("zoom about a place that stays, and never to nothing", () => {
    const [from, to] = zoomed("log", [1e-4, 1e4], 0.5, 0.25);
    expect(from).toBeCloseTo(1e-3, 12);
    expect(to / 1e1).toBeCloseTo(1, 12);
    expect(moved("linear", [0, 10], 0.1)).toEqual([1, 11]);
    expect(part("linear", [0, 10], 0.8, 0.2)).toEqual([2, 8]);
    let range = [1, 2] as readonly [number, number];
    for (let step = 0; step < 300; step += 1) range = zoomed("linear", range, 0.5, 0.3);
    expect(range[0]).toBeLessThan(range[1]);
    for (let step = 0; step < 3000; step += 1) range = zoomed("log", range, 2, 0.3);
    expect(usable("log", range)).toBe(true);
  });
});
