import { afterEach, describe, expect, it, vi } from "vitest";
import { MOST, signalCsv, toldOfSignals, traceOf } from "../src/pages/structures/march";
import { checkExported, rowNumbers, rowsWithin, thinningOf, toldOf } from "../src/pages/structures/thinning";
import { analysis, array, serve, variable } from "./study";

afterEach(() => vi.unstubAllGlobals());

/** What the server makes of a column: of each of its even bins the smallest, then the largest. */
const extremes = (values: readonly number[], most: number) => {
  const bins = most / 2;
  const start = (bin: number) => Math.floor((bin * values.length) / bins);
  return Array.from({ length: bins }, (_, bin) => values.slice(start(bin), start(bin + 1))).flatMap((part) => [Math.min(...part), Math.max(...part)]);
};

describe("rows that are thinned", () => {
  const thinning = thinningOf({ most: 4 }, 11);
  if (!thinning) throw new Error("not thinned");

  it("keep their own numbers", () => {
    const numbers = Array.from({ length: 11 }, (_, i) => i + 1);
    expect([...rowNumbers(thinning, thinning)]).toEqual(extremes(numbers, 4));
    expect([...rowNumbers({ from: 3, to: 6 }, null)]).toEqual([4, 5, 6]);
    expect(thinningOf({ most: 11 }, 11)).toBeNull();
    expect(thinningOf({}, 1e9)).toBeNull();
  });

  it("are found again within a window", () => {
    const ends = extremes(Array.from({ length: 11 }, (_, i) => 0.1 * i), 4);
    expect(rowsWithin(thinning, ends, [0.6, 0.7])).toEqual({ from: 5, to: 11 });
    expect(rowsWithin(thinning, ends, [0, 2])).toEqual({ from: 0, to: 11 });
    expect(rowsWithin(thinning, ends, [3, 4])).toEqual({ from: 0, to: 0 });
  });

  it("are told, and too many are refused in words", () => {
    expect(toldOf(thinning)).toContain("Of each 5 or 6 samples the smallest and the largest are drawn");
    expect(() => checkExported(1_250_000, 1)).toThrow("1250000 samples are in sight, and a CSV takes 1000000");
    expect(() => checkExported(1_000_000, 1)).not.toThrow();
  });
});

describe("a long march", () => {
  const count = 10 * MOST;
  const time = Array.from({ length: count }, (_, i) => i / 1000);
  const force = time.map((t) => Math.sin(7 * t));
  const own = analysis("m", "march", [variable("time", ["time"], [count]), variable("normal_force", ["time"], [count])]);
  const coarse = new Map([array("time", ["time"], [MOST], extremes(time, MOST)), array("normal_force", ["time"], [MOST], extremes(force, MOST))]);
  const parts = { analysis: own, name: "normal_force", trace: traceOf("normal_force", coarse, null), whole: [0, 40] as const, bands: [], window: undefined };

  it("is exported as its samples, not as what is drawn of them", async () => {
    const asked = serve({ time, normal_force: force });
    const lines = (await signalCsv(parts, coarse, { x: [3.0005, 3.2], y: [-1, 1] })).trim().split("\n").slice(1);
    expect(lines).toEqual(Array.from({ length: 200 }, (_, i) => `${time[3001 + i]},${force[3001 + i]}`));
    expect(asked).toEqual([{ from: 3000, to: 3220 }]);
  });

  it("says that its curves are extremes, and nothing where a window has every sample", () => {
    expect(toldOfSignals(own, null)).toContain("Of each 20 samples");
    expect(toldOfSignals(own, { from: 0, to: 8000, most: MOST })).toContain("Of each 4 samples");
    expect(toldOfSignals(own, { from: 10, to: 300, most: MOST })).toBeUndefined();
  });
});
