import { describe, expect, it } from "vitest";
import { parseRanges } from "../src/state/fields";
import type { View } from "../src/state/view";
import { basis, bodyCsv, bodyOf, bodySpec, drawnFactor, placesAt, projected, swingOf } from "../src/pages/structures/body";
import { growthClasses, growthSpec, homePlace, modesAt, planeSpec, readLocus, valueNear } from "../src/pages/structures/locus";
import { partOf, rangeWithin, shownSignals, traceOf } from "../src/pages/structures/march";
import { passed, positionAt, timeAt } from "../src/pages/structures/motion";
import { flat } from "../src/pages/structures/Scalars";
import { leftOut, slowness } from "../src/pages/structures/ShapeView";
import { highestOf, levelsCsv, outlines, readLevels, spectrogramSpec, toldOfLevels } from "../src/pages/structures/spectrogram";
import { pickedAnalysis, placed, readLook, withAnalysis, withLook, withRange, withWindow } from "../src/pages/structures/state";
import { type Study, axisLabel, keyWords } from "../src/pages/structures/study";
import { verdictOf, verdictsOf } from "../src/pages/structures/verdicts";
import { quoted } from "../src/pages/structures/words";
import { analysis, array, variable } from "./study";

const view: View = { page: "structures", set: {}, fields: {} };

describe("the address of a study's view", () => {
  it("keeps ranges of named axes, and tells charts apart", () => {
    const zoomed = withWindow(view, { x: [0.0165, 0.0166], y: [-1, 2] }, { x: "along", y: "rate" });
    expect(zoomed.fields["zoom"]).toBe("along:0.0165:0.0166,rate:-1:2");
    expect(parseRanges(zoomed.fields["zoom"])).toEqual({ along: [0.0165, 0.0166], rate: [-1, 2] });
    expect(withWindow(zoomed, null, { x: "along", y: "frequency" }).fields["zoom"]).toBe("rate:-1:2");
    expect(withRange(zoomed, "rate", undefined).fields["zoom"]).toBe("along:0.0165:0.0166");
    for (const text of ["a:1", "a:2:1", "a:1:x", ":1:2", "a:1:2,a:3:4", "a:1:2:3"]) expect(parseRanges(text)).toBeUndefined();
    expect(parseRanges("")).toEqual({});
  });

  it("tells places of a narrow range apart, and no more", () => {
    expect(placed(0.0164180216, [0.01, 0.0985])).toBe(0.016418);
    expect(placed(1.00000012345, [1, 1.000001])).toBe(1.0000001235);
  });

  it("keeps the place only where it means the same", () => {
    const over = (name: string, along: string) => analysis(name, "locus", [variable(along, [along], [2])]);
    const [position, other, friction] = [over("a", "position"), over("b", "position"), over("c", "value")];
    const study: Study = { name: "s", title: "", model: "sliding", version: "", analyses: [position, other, friction], sounds: [], warnings: [] };
    const at = { ...view, fields: { analysis: "a", at: "0.07", mode: "3", zoom: "growth:0:1" } };
    expect(withAnalysis(at, position, other).fields).toEqual({ analysis: "b", at: "0.07" });
    expect(withAnalysis(at, position, friction).fields).toEqual({ analysis: "c" });
    expect(pickedAnalysis(at, study)?.name).toBe("a");
    expect(pickedAnalysis({ ...at, fields: { analysis: "none" } }, study)?.name).toBe("a");
  });

  it("turns bodies round and round, but not over", () => {
    expect(readLook(withLook(view, { azimuth: 190, elevation: 120 }), true)).toEqual({ azimuth: -170, elevation: 90 });
  });
});

const locusOf = (verdict?: number[]) => {
  const own = analysis("l", "locus", [variable("position", ["position"], [3], { units: "m" }), variable("eigenvalue", ["position", "branch"], [3, 2])]);
  const nan = Number.NaN;
  const arrays = new Map([
    array("position", ["position"], [3], [0.1, 0.2, 0.3]),
    array("eigenvalue", ["position", "branch"], [3, 2], [-1, 2 * Math.PI, 5, 20 * Math.PI, -2, 4 * Math.PI, nan, nan, -3, 6 * Math.PI, 9, 40 * Math.PI], { type: "complex" }),
    ...(verdict ? [array("verdict", ["position", "branch"], [3, 2], verdict, { attributes: { flag_values: [0, 1, 2, 3], flag_meanings: "stable marginal unstable not_in_the_region" } })] : []),
  ]);
  const locus = readLocus(own, arrays);
  if (!locus) throw new Error("no locus");
  return locus;
};

describe("loci", () => {
  it("read growth rates and frequencies, and leave out what is not there", () => {
    const locus = locusOf();
    expect(modesAt(locus, 0.12).map((mode) => [mode.growth, Math.round(mode.frequency)])).toEqual([[-1, 1], [5, 10]]);
    expect(modesAt(locus, 0.21)).toHaveLength(1);
    expect(homePlace(locus)).toBe(0.3);
    expect(valueNear(locus, 5, 9, 10, 20)).toBe(0.1);
    expect(planeSpec(locus, "l", 0.2).layers.filter((layer) => layer.kind === "line")).toHaveLength(2);
  });

  it("mark where a branch is at one value alone, which no line shows", () => {
    const alone = growthSpec(locusOf(), "l").layers.filter((layer) => layer.label === "branches at one value alone");
    expect(alone).toMatchObject([{ kind: "points", x: [0.1, 0.3], y: [5, 9] }]);
  });

  it("say what the study says of an eigenvalue, not the sign of its growth rate", () => {
    expect(modesAt(locusOf([0, 1, 0, 3, 0, 2]), 0.1).map((mode) => mode.verdict)).toEqual(["stable", "marginal"]);
    expect([verdictOf(1e-9, "marginal"), verdictOf(1e-9, undefined), verdictOf(-1, undefined)]).toEqual(["marginal", "unstable", "stable"]);
    expect(verdictsOf(new Map())).toEqual([]);
  });

  it("split growth rates into few classes that hold the largest", () => {
    expect(growthClasses(135)).toEqual([10, 30, 100, 300]);
    expect(growthClasses(100).at(-1)).toBe(100);
    expect(growthClasses(0)).toEqual([]);
  });
});

describe("where the contact is", () => {
  // at rest, then on its way
  const motion = { time: Float64Array.of(0, 1, 2, 3), position: Float64Array.of(10, 10, 20, 40) };
  it("is found between the stored times, both ways", () => {
    expect(positionAt(motion, 2.5)).toBe(30);
    expect(timeAt(motion, 30)).toBe(2.5);
    expect(timeAt(motion, 41)).toBeNaN();
  });

  it("meets a stretch, or a part of it, or nothing of it", () => {
    expect(passed(motion, 15, 30)).toEqual([1.5, 2.5]);
    expect(passed(motion, 30, 99)).toEqual([2.5, 3]);
    expect(passed(motion, 41, 50)).toBeNull();
  });
});

describe("marches", () => {
  const own = analysis("m", "march", ["time", "position", "T.y", "normal_force"].map((name) => variable(name, ["time"], [1001])), { attributes: { signal: "T.y" } });
  it("show the signal of the case and the forces first, and what is asked for", () => {
    expect(shownSignals(own, undefined)).toEqual(["T.y", "normal_force"]);
    expect(shownSignals(own, "normal_force,unknown")).toEqual(["normal_force"]);
    expect(shownSignals(own, "")).toEqual([]);
  });

  it("ask for the samples of a window and one beyond its ends", () => {
    expect(partOf([0.2, 0.3], [0, 1], 1001)).toMatchObject({ from: 199, to: 302 });
    expect(partOf([-5, 0.1], [0, 1], 1001)).toMatchObject({ from: 0, to: 102 });
    expect(partOf([0, 0.95], [0, 1], 1001).from).toBeUndefined();
  });

  it("put the finer values in the place of the coarse ones", () => {
    const coarse = new Map([array("time", ["time"], [4], [0, 1, 2, 3]), array("T.y", ["time"], [4], [5, 6, 7, 8])]);
    const fine = new Map([array("time", ["time"], [3], [1, 1.5, 2]), array("T.y", ["time"], [3], [60, 65, 70])]);
    const trace = traceOf("T.y", coarse, fine);
    expect([...(trace.x as Float64Array)]).toEqual([0, 1, 1.5, 2, 3]);
    expect([...(trace.y as Float64Array)]).toEqual([5, 60, 65, 70, 8]);
    expect(traceOf("T.y", coarse, null).x).toHaveLength(4);
    // what is shown fills the height
    expect(rangeWithin(trace, [0.5, 1.7])?.map((end) => Math.round(10 * end))).toEqual([597, 653]);
    expect(rangeWithin(trace, [5, 6])).toBeUndefined();
  });
});

describe("spectrograms", () => {
  it("keep the highest level of each cell, frequencies as rows", () => {
    // three times of two lines, two times a column
    expect([...highestOf(Float64Array.of(0, 1, 4, 0, 5, 9), 3, 2, 2)]).toEqual([4, 5, 1, 9]);
  });

  it("are exported time by time, not as the columns of the map", () => {
    const times = Array.from({ length: 1601 }, (_, t) => t / 100);
    const level = times.flatMap((_, t) => [-t, -2 * t]);
    const own = analysis("s", "spectrogram", [variable("time", ["time"], [1601], { units: "s" }), variable("frequency", ["frequency"], [2], { units: "Hz" })]);
    const arrays = new Map([array("time", ["time"], [1601], times), array("frequency", ["frequency"], [2], [50, 100]), array("level", ["time", "frequency"], [1601, 2], level)]);
    const levels = readLevels(own, arrays);
    if (!levels) throw new Error("no levels");
    expect(toldOfLevels(levels)).toContain("Of each 3 times the highest");
    const csv = levelsCsv(spectrogramSpec(own, levels, "time"), levels, "time", { x: [0.065, 0.085], y: [60, 200] });
    expect(csv.trim().split("\n").slice(1).map((line) => line.split(",").slice(-3))).toEqual([["0.07", "100", "-14"], ["0.08", "100", "-16"]]);
  });

  it("frame zones where the contact passes them", () => {
    const arrays = new Map([
      array("time", ["time"], [3], [0, 1, 2]), array("position", ["time"], [3], [10, 20, 30]), array("frequency", ["frequency"], [2], [0, 100]),
      array("level", ["time", "frequency"], [3, 2], [-90, -20, -30, -40, -50, -10]),
      array("zone_from", ["zone"], [2], [15, 40]), array("zone_to", ["zone"], [2], [20, 50]), array("zone_frequency", ["zone"], [2], [50, 60]),
    ]);
    const levels = readLevels(analysis("s", "spectrogram", []), arrays);
    if (!levels) throw new Error("no levels");
    expect(levels.range).toEqual([-90, -10]);
    expect(outlines(levels, "time", 5).x).toEqual([0.5, 0.5, 1, 1, 0.5, Number.NaN]);
    expect(outlines(levels, "position", 5).x).toEqual([15, 15, 20, 20, 15, Number.NaN]);
    expect(outlines(levels, "time", 5).y.slice(0, 3)).toEqual([45, 55, 55]);
  });
});

describe("bodies", () => {
  const flatBody = bodyOf(Float64Array.of(0, 0, 0, 3, 0, 0, 3, 4, 0), [0, 1, 1, 2]);
  it("keep a plane as it is, and set z upwards in space", () => {
    expect(flatBody.planar).toBe(true);
    expect(flatBody.diagonal).toBe(5);
    expect([...bodyOf(Float64Array.of(0, 0, 0, 1, 2, 3), []).points.subarray(3)]).toEqual([1, 3, -2]);
    expect(bodyOf(Float64Array.of(0, 0, 0), [0, 7]).lines).toHaveLength(0);
  });

  it("swing as Re φ e^{iωt}, each point on its ellipse", () => {
    // the last point goes round: real along x, imaginary along y
    const swing = swingOf(flatBody, Float64Array.of(0, 0, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0, 2, 0, 0, 1, 0, 0), true);
    expect([...swing.reach]).toEqual([0, 0.25, 1]);
    expect(swing.largest).toBe(2);
    const out = new Float64Array(9);
    placesAt(flatBody, swing, Math.PI / 2, 10, out);
    expect(out[6]).toBeCloseTo(3, 12);
    expect(out[7]).toBeCloseTo(4 - 10, 12);
    // 8 % of the diagonal for the largest displacement
    expect(2 * drawnFactor(flatBody, swing, 1)).toBeCloseTo(0.08 * 5, 12);
  });

  it("turn without changing lengths, and lie on the paper from the front", () => {
    const { right, up, towards } = basis({ azimuth: 30, elevation: -50 });
    const dot = (a: readonly number[], b: readonly number[]) => a.reduce((sum, value, k) => sum + value * (b[k] as number), 0);
    expect([dot(right, up), dot(up, towards), dot(right, towards)].every((value) => Math.abs(value) < 1e-15)).toBe(true);
    expect([dot(right, right), dot(up, up), dot(towards, towards)].every((value) => Math.abs(value - 1) < 1e-15)).toBe(true);
    const front = projected(flatBody.points, { azimuth: 0, elevation: 0 }, flatBody.centre);
    expect([...front.x]).toEqual([-1.5, 1.5, 1.5]);
    expect([...front.y]).toEqual([-2, -2, 2]);
    const top = projected(Float64Array.of(0, 0, -1), { azimuth: 0, elevation: 90 }, [0, 0, 0]);
    // what lies behind is up when looked at from above
    expect(top.y[0]).toBeCloseTo(1, 12);
  });

  it("are exported as lines by their displacement", () => {
    const swing = swingOf(flatBody, Float64Array.of(0, 0, 0, 0, 0, 0, 0, 1, 0), false);
    const spec = bodySpec("body", flatBody, swing, { azimuth: 0, elevation: 0 }, 0, 0.1);
    const drawn = spec.layers.filter((layer) => layer.kind === "line" && layer.label !== "at rest");
    expect(drawn.map((layer) => (layer.kind === "line" ? layer.x.length / 3 : 0))).toEqual([1, 0, 1, 0, 0]);
  });

  it("are exported as what they are: every point at rest and its complex displacement", () => {
    const places = Float64Array.of(0, 0.5, 1, 2, 3, 4);
    const body = bodyOf(places, [0, 1], { nodes: Float64Array.of(11, 42) });
    const shape = Float64Array.of(1, -1, 2, -2, 3, -3, 4, -4, 5, -5, 0.1, 0);
    const lines = bodyCsv(body, swingOf(body, shape, true), "1/√kg").trim().split("\n");
    expect(lines[0]).toBe("node,x (m),y (m),z (m),Re u_x (1/√kg),Im u_x (1/√kg),Re u_y (1/√kg),Im u_y (1/√kg),Re u_z (1/√kg),Im u_z (1/√kg)");
    expect(lines.slice(1)).toEqual(["11,0,0.5,1,1,-1,2,-2,3,-3", "42,2,3,4,4,-4,5,-5,0.1,0"]);
    const flat = bodyCsv(flatBody, swingOf(flatBody, Float64Array.of(0, 0, 0, 0, 7, 0, 0, 0, 0), false), "");
    expect(flat.split("\n").slice(0, 3)).toEqual(["point,x (m),y (m),z (m),Re u_x,Im u_x,Re u_y,Im u_y,Re u_z,Im u_z", "1,0,0,0,0,0,0,0,0,0", "2,3,0,0,0,0,7,0,0,0"]);
  });

  it("say by how much they are slowed down", () => {
    expect(slowness(3525)).toContain("Slowed down 7050 times");
    expect(slowness(0.1)).toContain("Sped up 5 times");
    expect(slowness(0)).not.toContain("times");
    expect(leftOut(41.8)).toBe("Its growth, 41.8 1/s, is left out of the animation.");
    expect(leftOut(-3)).toContain("decay, 3 1/s");
    expect(leftOut(null)).toContain("neither");
  });
});

describe("scalars", () => {
  it("are told flat", () => {
    expect(flat({ a: 1, b: { c: [1, 2] }, d: [{ e: null }] })).toEqual([["a", 1], ["b.c", "1, 2"], ["d.0.e", null]]);
  });
});

describe("a command", () => {
  it("holds any path", () => {
    expect([quoted("out/belt"), quoted("my cases/it's.toml")]).toEqual(["out/belt", "'my cases/it'\\''s.toml'"]);
  });
});

describe("labels", () => {
  it("say keys in words", () => {
    expect(keyWords("motion.velocity (m/s)")).toBe("Velocity (m/s)");
    expect(keyWords("structure.oblique.beam.angle (rad)")).toBe("Angle of structure.oblique.beam (rad)");
    expect(keyWords("Level (dB re 1 m/s^{2})")).toBe("Level (dB re 1 m/s^{2})");
    expect(axisLabel(variable("value", ["value"], [3], { attributes: { label: "contact.friction_coefficient (−)" } }))).toBe("Friction coefficient (−)");
  });
});
