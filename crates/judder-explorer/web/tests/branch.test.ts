/** The diagram of a branch: what motions have become, and each place of a branch once. */

import { describe, expect, it } from "vitest";
import type { LineLayer, PointsLayer } from "../src/chart/spec";
import { type Branch, branchSpec, collectBranch } from "../src/pages/point/branch";
import { legendEntries } from "../src/chart/legend";
import { array } from "./study";

const axis = { label: "key", scale: "log" } as const;
const specOf = (arrays: ReturnType<typeof array>[]) => branchSpec(collectBranch()({ kind: "outcome", header: {}, arrays: new Map(arrays) }) as Branch, axis, null);

/** What a diagram brings: motions by direction, with what they have become. */
function motions(rms: readonly number[], becomes: readonly number[], words = "steady_sliding cycle irregular lost unconfirmed") {
  const count = rms.length / 2;
  const shape = [2, count];
  const flags = { flag_values: words.split(" ").map((_, code) => code), flag_meanings: words };
  return specOf([
    array("direction", ["direction"], [2], [], { type: "text", texts: ["forward", "backward"] }),
    array("key", ["key"], [count], Array.from({ length: count }, (_, i) => i + 1)),
    array("rms", ["direction", "key"], shape, rms),
    array("becomes", ["direction", "key"], shape, becomes, { type: "u8", data: Uint8Array.from(becomes), attributes: flags }),
  ]);
}

describe("the simulated motions of a branch", () => {
  const nan = Number.NaN;
  const spec = motions([0, 1, 2, 3, nan, 0, 1, 2, 3, nan], [0, 1, 2, 4, 3, 0, 1, 2, 4, 3]);
  const layers = spec.layers.filter((layer): layer is PointsLayer => layer.kind === "points");

  it("are drawn by what they have become, with an entry of the legend each; a motion that was lost has no place", () => {
    const kinds = ["steady sliding", "cycle", "irregular", "not known (unconfirmed)"];
    const labels = ["upwards", "downwards"].flatMap((way) => kinds.map((kind) => `${kind}, simulated ${way}`));
    expect(layers.map(({ label, x, y }) => [label, [...Array.from(x)], [...Array.from(y)]])).toEqual(labels.map((label, i) => [label, [1 + (i % 4)], [i % 4]]));
    expect(legendEntries(spec, "light").map(({ text }) => text)).toEqual(labels);
  });

  it("have the roles of the report's diagram, and marks that are told apart without colour", () => {
    // `judder-study`, pictures/motion.rs: the direction, irregular, unconfirmed
    expect(layers.filter(({ role }) => role !== "reference").map(({ role }) => role)).toEqual([0, 4, 6, 1, 5, 7].map((series) => ({ series })));
    for (const [way, shape] of [["upwards", "circle"], ["downwards", "square"]]) {
      const entries = legendEntries(spec, "light").filter(({ text }) => text.endsWith(way as string));
      // steady sliding, on the line of no amplitude, has the shape of its direction as cycles have
      expect(entries.map(({ line }) => line?.marker).slice(0, 2)).toEqual([shape, shape]);
      expect(new Set(entries.map(({ line }) => line?.marker)).size).toBe(3);
      expect(new Set(entries.map(({ line }) => line?.colour)).size).toBe(4);
    }
  });

  it("can be seen where both directions lead to the same: one stands in the other", () => {
    const [up, down] = [layers.slice(0, 4), layers.slice(4)];
    up.forEach((inner, i) => {
      expect([inner.hollow, down[i]?.hollow]).toEqual([false, true]);
      expect(down[i]?.size).toBeGreaterThan(1.5 * (inner.size ?? 8));
    });
  });

  it("of a kind that the page does not know are not taken for known", () => {
    const labels = motions([1, 2, 1, 2], [0, 1, 0, 1], "cycle drifting").layers.map(({ label }) => label);
    expect(labels).toEqual(["cycle", "not known (drifting)"].flatMap((kind) => [`${kind}, simulated upwards`]).concat(["cycle, simulated downwards", "not known (drifting), simulated downwards"]));
  });
});

interface Row {
  readonly branch: number;
  readonly value: number;
  readonly rms: number;
  readonly stable?: boolean;
}

/** The x of what is drawn of cycles of one stability, run by run. */
function drawn(rows: readonly Row[], label: string): number[][] {
  const of = (pick: (row: Row) => number) => rows.map(pick);
  const stable = Uint8Array.from(rows, (row) => Number(row.stable ?? false));
  const column = (name: string, pick: (row: Row) => number) => array(name, ["branch_point"], [rows.length], of(pick));
  const spec = specOf([
    column("branch_value", (row) => row.value),
    column("branch_rms", (row) => row.rms),
    column("branch_number", (row) => row.branch),
    array("branch_stable", ["branch_point"], [rows.length], stable, { type: "u8", data: stable }),
  ]);
  const line = spec.layers.find((layer): layer is LineLayer => layer.label === label);
  const runs: number[][] = [[]];
  for (const x of Array.from(line?.x ?? [])) {
    if (Number.isNaN(x)) runs.push([]);
    else runs.at(-1)?.push(x);
  }
  return runs.filter((run) => run.length > 0);
}

describe("a branch that is followed twice", () => {
  // two decades, one more in amplitude: the same curve through other points
  const level = (value: number) => 0.2 + 0.1 * Math.log10(value) ** 2;
  const run = (branch: number, exponents: readonly number[], more: Partial<Row> = {}, rise = 0): Row[] =>
    exponents.map((exponent) => ({ branch, value: 10 ** exponent, rms: level(10 ** exponent) + rise * Math.max(exponent - 1, 0), ...more }));
  const steps = (from: number, count: number) => Array.from({ length: count }, (_, i) => from + 0.05 * i);
  const once = run(0, steps(0, 41));

  it("is drawn once: dashes out of step would be a solid line", () => {
    expect(drawn([...once, ...run(1, steps(0.02, 39))], "cycles, unstable")).toEqual([once.map(({ value }) => value)]);
  });

  it("is drawn from where it leaves the other, and beyond its ends", () => {
    const [first, second, ...rest] = drawn([...once, ...run(1, steps(-0.5, 51), {}, 0.5)], "cycles, unstable");
    expect(first).toEqual(once.map(({ value }) => value));
    expect(second?.[0]).toBeCloseTo(10 ** -0.5, 9);
    expect(second?.at(-1)).toBeCloseTo(1, 1);
    expect(Math.log10(rest[0]?.[0] ?? 0)).toBeGreaterThan(0.94);
    expect(Math.log10(rest[0]?.[0] ?? 0)).toBeLessThan(1.11);
    expect(rest[0]?.at(-1)).toBeCloseTo(100, 6);
    expect(rest).toHaveLength(1);
  });

  it("is drawn beside one of the other stability", () => {
    const both = [...once, ...run(1, steps(0, 41), { stable: true })];
    for (const stability of ["stable", "unstable"]) expect(drawn(both, `cycles, ${stability}`)).toEqual([once.map(({ value }) => value)]);
  });
});
