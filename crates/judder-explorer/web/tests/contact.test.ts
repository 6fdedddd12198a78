import { describe, expect, it } from "vitest";
import { coefficientsOf, fitOf, residuals } from "../src/pages/contact/fit";
import { coloured, columnOf, hertzLimits, lawOf, mapSpec, nodeAt, rowOf, speedCutSpec, spread } from "../src/pages/contact/law";
import { modulusSpec } from "../src/pages/contact/material";
import { numberAt, scalarAt } from "../src/wire/outcome";
import { boundary, hertz, isRound, middleRow, solutionOf } from "../src/pages/contact/solution";
import { fitAnalysis, readContact, solutionAnalysis, withCursor, withLoading, withWindow } from "../src/pages/contact/state";
import { shortNumber } from "../src/pages/contact/words";
import { type View, parseView, writeView } from "../src/state/view";
import { decodeFrame } from "../src/wire/frames";
import { encode } from "./encode";
import { PAGE_FIELDS, settings } from "./declared";

const read = (query: string) => readContact(parseView("/contact", query, PAGE_FIELDS).view, { settings });
const empty: View = { page: "contact", set: {}, fields: {} };

/** A frame with arrays, each with its dimensions. */
function frameOf(header: object, arrays: readonly (readonly [name: string, numbers: readonly number[], dimensions: readonly string[], shape: readonly number[]])[]) {
  let offset = 0;
  const entries = arrays.map(([name, numbers, dimensions, shape]) => {
    const entry = { name, type: "f64", shape, dimensions, offset };
    offset += 8 * numbers.length;
    return entry;
  });
  const bytes = new Uint8Array(Float64Array.from(arrays.flatMap(([, numbers]) => numbers)).buffer);
  return decodeFrame(encode({ ...header, arrays: entries }, bytes));
}

describe("the contact page's state", () => {
  it("shows the material first, and tells what of an address is wrong", () => {
    expect(read("")).toMatchObject({ part: "material", quantity: "friction", speeds: [1e-6, 1e4], cursor: null, loading: null });
    expect(read("part=law&speeds=1,2&depths=5,1&cursor=1,-1")).toMatchObject({ part: "law", speeds: [1, 2], depths: [1e-6, 1e-1], cursor: null });
    expect(parseView("/contact", "part=fish", PAGE_FIELDS).told).toHaveLength(1);
  });

  it("comes back from its address", () => {
    const view = withLoading(withCursor(withWindow(empty, { x: [1e-4, 0.123456], y: [1e-3, 1] }), { velocity: 0.5, indentation: 2e-3 }), { key: "load", value: "2 N" });
    const [path = "", query = ""] = writeView(view).split("?");
    const state = readContact(parseView(path, query, PAGE_FIELDS).view, { settings });
    expect(state).toMatchObject({ speeds: [1e-4, 0.1235], depths: [1e-3, 1], cursor: { velocity: 0.5, indentation: 2e-3 }, loading: { key: "load", value: "2 N" } });
    const deep = withLoading(view, { key: "indentation", value: "0.01" });
    expect([deep.fields["load"], deep.fields["indentation"]]).toEqual([undefined, "0.01"]);
  });

  it("asks for the operating point where the address names nothing else", () => {
    const home = { velocity: 0.1, indentation: 0.02 };
    expect(solutionAnalysis(read(""), home)).toMatchObject({ kind: "contact", velocity: 0.1, indentation: 0.02, accuracy: 0.01 });
    const asked = solutionAnalysis(read("velocity=30 mm/s&load=2 N&accuracy=1e-3"), home);
    expect(asked).toMatchObject({ velocity: "30 mm/s", load: "2 N", accuracy: 1e-3 });
    expect(asked["indentation"]).toBeUndefined();
    expect(fitAnalysis(read("velocity_scale=1"))).toMatchObject({ kind: "fit", velocity_scale: 1 });
  });

  it("fits over the paper's speeds and depths, or over those of the address", () => {
    expect(fitAnalysis(read(""))).toMatchObject({ velocity: { from: 1e-4, to: 1e4, points: 41 }, indentation: { from: 1e-4, to: 1e-1, points: 13 } });
    expect(read("").hasRanges).toBe(false);
    const narrow = read("speeds=1e-3,10&depths=1e-3,0.05");
    expect(fitAnalysis(narrow)).toMatchObject({ velocity: { from: 1e-3, to: 10, points: 41 }, indentation: { from: 1e-3, to: 0.05, points: 13 } });
    expect(narrow.hasRanges).toBe(true);
    for (const text of ["speeds=10,1", "depths=0,1", "speeds=-1,1", "depths=1"]) expect(parseView("/contact", text, PAGE_FIELDS).told, text).toHaveLength(1);
  });
});

const axes = [
  ["velocity", [1e-2, 1, 100], ["velocity"], [3]],
  ["indentation", [1e-3, 1e-1], ["indentation"], [2]],
] as const;
const plane = (name: string, numbers: readonly number[]) => [name, numbers, ["indentation", "velocity"], [2, 3]] as const;

describe("a law", () => {
  const law = lawOf(frameOf({ kind: "law" }, [...axes, plane("force", [1, 2, 3, 4, 5, 6]), plane("area", [1, 1, 1, 1, 1, 1]), plane("friction", [1e-30, 0.1, 0, 0, 0.2, 0])]));

  it("is read by rows and columns at the nearest node, on logarithmic axes", () => {
    expect(nodeAt(law, { velocity: 0.2, indentation: 5e-3 })).toEqual({ row: 0, column: 1 });
    expect([...rowOf(law, "force", 1)]).toEqual([4, 5, 6]);
    expect([...columnOf(law, "force", 2)]).toEqual([3, 6]);
    expect(spread(81, 5)).toEqual([0, 20, 40, 60, 80]);
    expect(spread(1, 5)).toEqual([0]);
  });

  it("has colours for six decades of friction, and none where all is zero", () => {
    expect(coloured(law, "friction")?.[0]).toBeCloseTo(2e-7, 12);
    expect(coloured(law, "force")).toEqual([1, 6]);
    const none = { ...law, values: { ...law.values, friction: new Float64Array(6) } };
    expect(coloured(none, "friction")).toBeNull();
    expect(mapSpec(none, read("quantity=friction"), null).layers).toEqual([]);
  });

  it("lies between Hertz's limits in its cut", () => {
    // F = 4/3 E*/E0* δ^(3/2), A = π δ
    expect(hertzLimits("force", 0.01, 10).map(([, value]) => value)).toEqual([(4 / 3) * 0.01 ** 1.5, 10 * (4 / 3) * 0.01 ** 1.5]);
    expect(hertzLimits("area", 0.01, 10)).toEqual([["Hertz", Math.PI * 0.01]]);
    const parts = { law, state: read("quantity=force"), cursor: { velocity: 1, indentation: 0.1 }, beside: null, contrast: 10, operating: null };
    const lines = speedCutSpec(parts).layers.filter((layer) => layer.kind === "line");
    expect(lines.at(-1)).toMatchObject({ label: "cursor, $δ$/$R$ = 0.1" });
    expect([...(lines.at(-1)?.y as Float64Array)]).toEqual([4, 5, 6]);
  });
});

describe("the operating point", () => {
  const operating = { velocity: 1e-3, indentation: 1e-2 };
  const labels = (query: string) => mapSpec(null, read(query), operating).layers.map((layer) => layer.label);

  it("is marked where the plane holds it", () => {
    expect(labels("")).toEqual(["operating point"]);
    expect(labels("speeds=1e-2,1")).toEqual([]);
    expect(labels("depths=1e-6,1e-3")).toEqual([]);
  });
});

describe("a fit", () => {
  const frame = frameOf({ kind: "outcome" }, [
    ...axes,
    ...["force", "area", "friction"].map((name) => plane(name, [1, 2, 4, 1, 5, 10])),
    ...["force", "area", "friction"].map((name) => plane(`fitted_${name}`, [1, 3, 4, 0, 5, 10])),
  ]);

  it("has residuals over the largest value at each depth", () => {
    expect([...residuals(fitOf(frame), "area")]).toEqual([0, 0.25, 0, -0.1, 0, 0]);
  });

  it("lists its coefficients with the paper's where they are compared", () => {
    const scalars = { force: { coefficients: [11.9, 1.2], standard_errors: [0.1, 0.2] }, beside_the_paper: [{ name: "a1", paper: 11.89 }] };
    const [first, second] = coefficientsOf({ scalars, checks: [], warnings: [] }, "force");
    expect(numberAt(scalars, first?.value ?? "")).toBe(11.9);
    expect(numberAt(scalars, first?.paper ?? "")).toBe(11.89);
    expect([numberAt(scalars, second?.standardError ?? ""), second?.paper]).toEqual([0.2, null]);
    expect([scalarAt({ converged: true }, "converged"), scalarAt(scalars, "friction.r2")]).toEqual(["true", null]);
  });
});

describe("one solution", () => {
  const grid = Float64Array.from([-0.1, 0, 0.1]);
  const heights = [0.01, 0.005, 0.01, 0.005, 0, 0.005, 0.01, 0.005, 0.01];
  const square = { x: grid, y: grid, values: Float64Array.from(heights) };

  it("has one closed loop around a single cell, of half a cell on all sides", () => {
    const { x, y } = boundary({ ...square, values: Float64Array.from([0, 0, 0, 0, 1, 0, 0, 0, 0]) });
    expect(x.length).toBe(6);
    expect([x[0], y[0]]).toEqual([x[4], y[4]]);
    expect(Number.isNaN(x[5] as number)).toBe(true);
    for (const value of [...x, ...y].filter(Number.isFinite)) expect(Math.abs(value)).toBeCloseTo(0.05, 12);
  });

  it("goes around cells that touch at corners and around holes", () => {
    const corners = boundary({ ...square, values: Float64Array.from([1, 0, 0, 0, 1, 0, 0, 0, 1]) });
    const ring = boundary({ ...square, values: Float64Array.from([1, 1, 1, 1, 0, 1, 1, 1, 1]) });
    const sides = (x: Float64Array) => x.length - 2 * x.filter(Number.isNaN).length;
    expect([sides(corners.x), sides(ring.x), ring.x.filter(Number.isNaN).length]).toEqual([12, 16, 2]);
  });

  it("is compared with Hertz only under a round indenter", () => {
    expect(isRound(square)).toBe(true);
    expect(isRound({ ...square, values: square.values.map(() => 0.02) })).toBe(false);
    // a² = δ and F = 4/3 δ^(3/2) are one contact, of p0 = 3F/(2π a²)
    const [deep, loaded] = hertz(0.01, (4 / 3) * 0.01 ** 1.5);
    expect(deep?.radius).toBeCloseTo(0.1, 12);
    expect(loaded?.radius).toBeCloseTo(0.1, 12);
    expect(loaded?.pressure).toBeCloseTo((1.5 * (4 / 3) * 0.01 ** 1.5) / (Math.PI * 0.01), 12);
  });

  it("takes each field over its own positions", () => {
    const dimensions = ["y", "x_surface"] as const;
    const frame = frameOf({ kind: "outcome", scalars: { indentation: 0.01, force: 1e-3 } }, [
      ["x", [0, 1], ["x"], [2]],
      ["y", [-0.4, 0.1], ["y"], [2]],
      ["x_surface", [-0.5, 0.5], ["x_surface"], [2]],
      ["pressure", [1, 2, 3, 4], ["y", "x"], [2, 2]],
      ["gap", [5, 6, 7, 8], dimensions, [2, 2]],
      ["displacement", [0, 0, 0, 0], dimensions, [2, 2]],
      ["height", [9, 9, 9, 9], dimensions, [2, 2]],
    ]);
    const solution = solutionOf(frame);
    expect([...solution.gap.x]).toEqual([-0.5, 0.5]);
    expect([...middleRow(solution.gap)]).toEqual([7, 8]);
    expect([...solution.pressure.x]).toEqual([0, 1]);
  });
});

describe("the material", () => {
  it("marks plateaus, and frequencies that can be drawn", () => {
    const scalars = { rubbery_modulus_pascal: 1e6, glassy_modulus_pascal: 1e7 };
    const frame = frameOf({ kind: "outcome", scalars }, [["frequency", [1, 10], ["frequency"], [2]]]);
    const marks = [0.1, 0, Number.NaN].map((at) => ({ name: "mark", at, role: { series: 3 } }));
    const spec = modulusSpec(frame, marks);
    expect(spec.layers.filter((layer) => layer.kind === "rule").map((layer) => layer.at)).toEqual([1e6, 1e7, 0.1]);
    expect(spec.x.range?.[0]).toBeCloseTo(0.1, 12);
  });

  it("writes numbers shortly", () => {
    expect([0.00012345, 1e-6, 0.1, 123456, -2e-7, Number.NaN].map(shortNumber)).toEqual([
      "1.23×10^{−4}",
      "10^{−6}",
      "0.1",
      "1.23×10^{5}",
      "−2×10^{−7}",
      "—",
    ]);
  });
});
