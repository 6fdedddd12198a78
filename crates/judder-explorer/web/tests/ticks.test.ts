import { describe, expect, it } from "vitest";
import { plainText, spans, widthOf } from "../src/chart/markup";
import { moved, part, rangeOf, usable, zoomed } from "../src/chart/scale";
import { ticks } from "../src/chart/ticks";

const labels = (scale: "log" | "linear", from: number, to: number, room: number) =>
  ticks(scale, [from, to], room).major.map((tick) => tick.label);

// the cases of judder-report, ticks.rs: the same marks in reports and on pages
describe("ticks", () => {
  it("on linear axes are round and have true minus signs", () => {
    expect(labels("linear", -1, 1, 5)).toEqual(["−1.0", "−0.5", "0.0", "0.5", "1.0"]);
    expect(labels("linear", 0, 400, 6)).toEqual(["0", "100", "200", "300", "400"]);
    expect(labels("linear", 0, 3e-6, 4)).toEqual(["0", "1", "2", "3"]);
    expect(ticks("linear", [0, 3e-6], 4).exponent).toBe(-6);
  });

  it("on log axes are decades, thinned to the room", () => {
    expect(labels("log", 1e-2, 1e1, 6)).toEqual(["10^{−2}", "10^{−1}", "10^{0}", "10^{1}"]);
    expect(labels("log", 1e-8, 1e2, 6).filter((label) => label !== "")).toHaveLength(6);
    expect(labels("log", 2, 6, 4)).toEqual(["2", "5"]);
    expect(ticks("log", [1e-2, 1e1], 6).minor).toContain(0.03);
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
