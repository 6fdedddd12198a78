import { afterEach, describe, expect, it, vi } from "vitest";
import type { LineLayer, PointsLayer, ValuesLayer } from "../src/chart/spec";
import { drawable, requestsOf, undrawn } from "../src/pages/structures/generic";
import { type GenericChart, genericCharts } from "../src/pages/structures/genericCharts";
import type { StudyAnalysis, StudyVariable } from "../src/pages/structures/study";
import { analysis, array, serve, variable } from "./study";

afterEach(() => vi.unstubAllGlobals());

const curve = (chart: GenericChart | undefined, k = 0) => chart?.spec.layers[k] as LineLayer | PointsLayer;
const all = { x: [-1e9, 1e9], y: [-1e9, 1e9] } as const;
const last = (own: StudyAnalysis) => own.variables.at(-1) as StudyVariable;

describe("what has no view of its own", () => {
  it("is drawn over its coordinates, complex numbers in two charts", () => {
    const own = analysis("g", "growth", [variable("time", ["time"], [3], { units: "s" }), variable("scalar", [], []), variable("amplitude", ["time"], [3])]);
    expect(drawable(own, []).map((one) => one.name)).toEqual(["amplitude"]);
    const arrays = new Map([array("time", ["time"], [3], [0, 1, 2]), array("amplitude", ["time"], [3], [1, 2, 3, 4, 5, 6], { type: "complex" })]);
    const charts = genericCharts(own, last(own), arrays, {});
    expect(charts.map((chart) => [curve(chart).kind, [...(curve(chart).y as Float64Array)]])).toEqual([["line", [1, 3, 5]], ["line", [2, 4, 6]]]);
  });

  it("is drawn as points where it is only counted, or a code, however much there is", () => {
    const flags = { flag_values: [0, 1], flag_meanings: "steady_sliding cycle" };
    const own = analysis("b", "basin", [
      variable("time", ["time"], [900], { units: "s" }), variable("rms", ["sample"], [900]), variable("state", ["time"], [900], { attributes: flags }),
    ]);
    const time = array("time", ["time"], [900], Array.from({ length: 900 }, (_, i) => i / 10));
    const arrays = new Map([time, array("rms", ["sample"], [900], new Float64Array(900)), array("state", ["time"], [900], new Float64Array(900))]);
    const [rms, state] = own.variables.slice(1).map((one) => genericCharts(own, one, arrays, {})[0]);
    expect([curve(rms).kind, curve(state).kind]).toEqual(["points", "points"]);
    expect([rms?.spec.x.label, rms?.note]).toEqual(["Number of the sample", undefined]);
    expect([curve(rms).x[0], curve(rms).x[899]]).toEqual([1, 900]);
    expect(state?.note).toBe("0 is steady sliding, 1 is cycle.");
  });

  it("has a title of its own where two variables are called the same", () => {
    const own = analysis("d", "bifurcation", ["branch_value", "fold_value"].map((name) => variable(name, [name + "s"], [2], { long_name: "swept value" })));
    const titles = own.variables.map((one) => genericCharts(own, one, new Map([array(one.name, [], [2], [1, 2])]), {})[0]?.spec.title);
    expect(titles).toEqual(["d: swept value (branch value)", "d: swept value (fold value)"]);
  });

  it("comes whole up to some hundred thousand values, and is thinned beyond", () => {
    const own = analysis("b", "basin", [variable("rms", ["sample"], [20_000]), variable("longer", ["step"], [500_000]), variable("other", ["step"], [500])]);
    expect(requestsOf(own, drawable(own, [])).map(({ names, part }) => ({ names, part }))).toEqual([
      { names: ["rms", "other"], part: {} },
      { names: ["longer"], part: { most: 4000 } },
    ]);
  });

  it("keeps its numbers where it is thinned, says so, and is exported as it is", async () => {
    const values = Array.from({ length: 11 }, (_, i) => (i * 7) % 11);
    const own = analysis("b", "basin", [variable("rms", ["sample"], [11])]);
    const arrays = new Map([array("rms", ["sample"], [4], [1, 10, 0, 9])]);
    const [chart] = genericCharts(own, last(own), arrays, { most: 4 });
    expect([...(curve(chart).x as Float64Array)]).toEqual([1, 5, 6, 11]);
    expect(chart?.note).toContain("Of each 5 or 6 samples the smallest and the largest are drawn");
    serve({ rms: values });
    const csv = await chart?.dataOf?.({ x: [3, 7], y: [0, 1] });
    expect(csv?.trim().split("\n").slice(1)).toEqual([3, 4, 5, 6, 7].map((number) => `${number},${values[number - 1]}`));
  });
});

describe("a table of three sides", () => {
  const keys = [variable("contact.friction", ["contact.friction"], [2], { units: "1" }), variable("beam.angle", ["beam.angle"], [3], { units: "rad" })];
  const coordinates = [array("contact.friction", ["contact.friction"], [2], [0, 0.5]), array("beam.angle", ["beam.angle"], [3], [-1, 0.5, 1])];
  const data = Array.from({ length: 12 }, (_, i) => i);

  it("has a chart of each quantity of a sweep, with its name and unit", () => {
    const words = { type: "text", data: new Float64Array(0) };
    const own = analysis("s", "sweep", [...keys, variable("quantity", ["quantity"], [2]), variable("quantity_units", ["quantity"], [2]), variable("values", ["contact.friction", "beam.angle", "quantity"], [2, 3, 2])]);
    expect(drawable(own, []).map((one) => one.name)).toEqual(["values"]);
    expect(requestsOf(own, drawable(own, []))[0]?.names).toEqual(["values", "contact.friction", "beam.angle", "quantity", "quantity_units"]);
    const arrays = new Map([
      ...coordinates, array("values", last(own).dimensions as string[], [2, 3, 2], data),
      array("quantity", ["quantity"], [2], [], { ...words, texts: ["count", "growth"] }), array("quantity_units", ["quantity"], [2], [], { ...words, texts: ["1", "1/s"] }),
    ]);
    const charts = genericCharts(own, last(own), arrays, {});
    expect(charts.map(({ spec }) => [spec.title, spec.y.label])).toEqual([["s: count", "count"], ["s: growth", "growth (1/s)"]]);
    expect(charts[1]?.spec.layers.map((layer) => layer.label)).toEqual(["beam.angle = −1 rad", "beam.angle = 0.5 rad", "beam.angle = 1 rad"]);
    expect([...(curve(charts[1], 2).y as Float64Array)]).toEqual([5, 11]);
    expect([...(curve(charts[1], 2).x as Float64Array)]).toEqual([0, 0.5]);
  });

  it("is a map over the first key of a sweep where there are many of both, and says what codes mean", () => {
    const long = (name: string, count: number) => [variable(name, [name], [count]), array(name, [name], [count], Array.from({ length: count }, (_, i) => i / 10))] as const;
    const [[x, xValues], [y, yValues]] = [long("first", 12), long("second", 10)];
    const of = (name: string, text: string) => array(name, ["quantity"], [1], [], { type: "text", data: new Float64Array(0), texts: [text] });
    const own = analysis("s", "sweep", [x, y, variable("quantity_units", ["quantity"], [1]), variable("values", ["first", "second", "quantity"], [12, 10, 1])]);
    const cells = array("values", [], [12, 10, 1], Array.from({ length: 120 }, (_, i) => i));
    const words = [of("quantity", "a.long.path.of.unstable.verdict"), of("quantity_units", "1"), of("quantity_flag_values", "0 1"), of("quantity_flag_meanings", "stable not_stable")];
    const [chart] = genericCharts(own, last(own), new Map([xValues, yValues, cells, ...words]), {});
    const map = chart?.spec.layers[0] as ValuesLayer;
    expect([map.x.length, map.y.length, map.values[1], map.values[12]]).toEqual([12, 10, 10, 1]);
    expect([chart?.note, chart?.spec.y.label, map.label]).toEqual(["0 is stable, 1 is not stable.", "Second", "path.of.unstable.verdict"]);
    expect(chart?.names).toEqual({ x: "first-map", y: "values-0" });
  });

  it("has slices along the first side, with its value in the title", () => {
    const own = analysis("s", "other", [...keys, variable("cube", ["contact.friction", "beam.angle", "copy"], [2, 3, 2])]);
    const charts = genericCharts(own, last(own), new Map([...coordinates, array("cube", [], [2, 3, 2], data)]), {});
    expect(charts.map(({ spec }) => spec.title)).toEqual(["s: cube, contact.friction = 0", "s: cube, contact.friction = 0.5"]);
    expect([...(curve(charts[1], 1).y as Float64Array)]).toEqual([7, 9, 11]);
  });

  it("is told in words where there are too many slices, sides or values", () => {
    const own = analysis("s", "other", [variable("a", ["a", "b", "c"], [99, 3, 2]), variable("b", ["a", "b", "c", "d"], [2, 2, 2, 2]), variable("c", ["a", "b"], [2000, 2000])]);
    expect(drawable(own, [])).toEqual([]);
    expect(undrawn(own, [])).toEqual([["a", "99 slices along a are too many"], ["b", "it has 4 dimensions"], ["c", "4000000 values are too many"]]);
  });
});

describe("a table of two sides", () => {
  it("has a curve of each entry with a name", () => {
    const own = analysis("d", "bifurcation", [variable("direction", ["direction"], [2]), variable("velocity", ["velocity"], [3], { units: "m/s" }), variable("rms", ["direction", "velocity"], [2, 3])]);
    const up = array("direction", ["direction"], [2], [], { type: "text", data: new Float64Array(0), texts: ["up", "down"] });
    const arrays = new Map([up, array("velocity", ["velocity"], [3], [5, 6, 7]), array("rms", ["direction", "velocity"], [2, 3], [1, 2, 3, 4, 5, 6])]);
    const [chart] = genericCharts(own, last(own), arrays, {});
    expect(chart?.spec.layers.map((layer) => [layer.label, [...((layer as LineLayer).y as Float64Array)]])).toEqual([["up", [1, 2, 3]], ["down", [4, 5, 6]]]);
    expect([...(curve(chart).x as Float64Array)]).toEqual([5, 6, 7]);
  });

  it("is a map where it is a surface, whose data have no more cells than the table", () => {
    const own = analysis("m", "modes", [variable("mac", ["mode", "other_mode"], [3, 3])]);
    const [chart] = genericCharts(own, last(own), new Map([array("mac", ["mode", "other_mode"], [3, 3], [1, 2, 3, 4, 5, 6, 7, 8, 9])]), {});
    const map = chart?.spec.layers[0] as ValuesLayer;
    expect([...(map.x as Float64Array)]).toEqual([0.5, 1, 2, 3, 3.5]);
    expect([...(map.values as Float64Array)].slice(5, 10)).toEqual([1, 1, 2, 3, 3]);
    expect(chart?.spec.equal).toBe(true);
    const lines = (chart?.dataOf?.(all) as string).trim().split("\n").slice(1);
    expect(lines.map((line) => line.split(",").slice(-3).map(Number))).toEqual([1, 2, 3, 4, 5, 6, 7, 8, 9].map((value, k) => [(k % 3) + 1, Math.floor(k / 3) + 1, value]));
  });
});
