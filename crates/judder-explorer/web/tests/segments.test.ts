/** No drawn segment joins rows that do not follow one another: of other branches, beyond gaps, of other loops. Held against every chart that draws lines. */

import { readFileSync, readdirSync } from "node:fs";
import { join, relative } from "node:path";
import { describe, expect, it } from "vitest";
import { draw } from "../src/chart/draw";
import { homeWindow } from "../src/chart/frame";
import type { Shape } from "../src/chart/scene";
import type { ChartSpec, LineLayer } from "../src/chart/spec";
import { curvesSpec as fitSpec } from "../src/pages/contact/fit";
import { depthCutSpec, speedCutSpec } from "../src/pages/contact/law";
import { modulusSpec, tangentSpec } from "../src/pages/contact/material";
import { boundary, fieldSpec, pressureCutSpec, surfaceCutSpec } from "../src/pages/contact/solution";
import type { ContactState } from "../src/pages/contact/state";
import { mapSpec } from "../src/pages/map/spec";
import type { MapState } from "../src/pages/map/state";
import { type Branch, branchSpec, collectBranch } from "../src/pages/point/branch";
import { floquetSpec } from "../src/pages/point/cycle";
import { eigenSpec, growthSpec, joined } from "../src/pages/point/eigen";
import { type Motion, historySpecs, portraitSpec, spectrumSpec } from "../src/pages/point/motion";
import { bodyOf, bodySpec, swingOf } from "../src/pages/structures/body";
import { genericCharts } from "../src/pages/structures/genericCharts";
import { frequencySpec, growthSpec as locusGrowthSpec, planeSpec, readLocus } from "../src/pages/structures/locus";
import { signalSpec } from "../src/pages/structures/march";
import { readLevels, spectrogramSpec } from "../src/pages/structures/spectrogram";
import type { Key } from "../src/wire/api";
import type { Frame, FrameArray } from "../src/wire/frames";
import { analysis, array, variable } from "./study";

/** A row where a chart puts it; rows of one run may be joined to the row before and after. */
interface Row {
  readonly x: number;
  readonly y: number;
  readonly run: string;
}

const nan = Number.NaN;
const place = (x: number, y: number) => `${x.toPrecision(9)},${y.toPrecision(9)}`;
const pair = (a: string, b: string) => [a, b].sort().join(" – ");
const isRow = (x: number, y: number) => !Number.isNaN(x) && !Number.isNaN(y);

/** What may be joined: neighbours in the list, of one run, both of which are. */
function allowed(rows: readonly Row[]): Set<string> {
  const next = rows.slice(1).map((row, i) => [rows[i] as Row, row] as const);
  return new Set(next.filter(([a, b]) => a.run === b.run && isRow(a.x, a.y) && isRow(b.x, b.y)).map(([a, b]) => pair(place(a.x, a.y), place(b.x, b.y))));
}

/** The segments of the lines of a chart; lines that are no rows are told by their labels. */
function drawn(spec: ChartSpec, shapes: readonly string[] = []): Set<string> {
  const lines = spec.layers.filter((layer): layer is LineLayer => layer.kind === "line" && !shapes.includes(layer.label));
  return new Set(lines.flatMap(segments));
}

function segments({ x, y }: LineLayer): string[] {
  const found: string[] = [];
  for (let i = 1; i < x.length; i += 1) {
    const [a, b, c, d] = [x[i - 1] as number, y[i - 1] as number, x[i] as number, y[i] as number];
    if (isRow(a, b) && isRow(c, d)) found.push(pair(place(a, b), place(c, d)));
  }
  return found;
}

/** Numbers between 0 and 1 that are the same at every run. */
function random(seed: number): () => number {
  let state = (seed + 1) * 2654435761;
  return () => {
    state = (Math.imul(state ^ (state >>> 15), 2246822519) + 0x9e3779b9) >>> 0;
    return ((state ^ (state >>> 13)) >>> 0) / 2 ** 32;
  };
}

const SEEDS = Array.from({ length: 60 }, (_, seed) => seed);
const times = <T>(count: number, of: (i: number) => T): T[] => Array.from({ length: count }, (_, i) => of(i));
/** Values with gaps: one in six is none. */
const gappy = (count: number, next: () => number, base = 0) => times(count, () => (next() < 0.17 ? nan : base + next()));
const rowsOf = (run: string, x: ArrayLike<number>, y: ArrayLike<number>): Row[] => Array.from(x, (value, i) => ({ x: value, y: y[i] as number, run }));
const columns = (entries: Readonly<Record<string, ArrayLike<number>>>, more: readonly [string, FrameArray][] = []) =>
  new Map([...Object.entries(entries).map(([name, data]) => array(name, [`${name}s`], [data.length], data)), ...more]);
const frame = (arrays: Frame["arrays"], header: Frame["header"] = {}): Frame => ({ kind: "outcome", header, arrays });

/** Branches of cycles with stabilities and gaps, and steady sliding that is not everywhere. */
function branches(seed: number) {
  const next = random(seed);
  const told = times(1 + Math.floor(4 * next()), (branch) => times(1 + Math.floor(8 * next()), () => ({ branch, value: next(), rms: next() < 0.1 ? nan : next(), stable: next() < 0.5 }))).flat();
  const steady = times(12, (i) => i + next());
  const growth = times(12, () => (next() < 0.2 ? nan : next() - 0.5));
  const of = (pick: (row: (typeof told)[number]) => number) => told.map(pick);
  const u8 = (name: string, data: number[]) => array(name, ["branch_point"], [data.length], data, { type: "u8", data: Uint8Array.from(data) });
  const arrays = columns(
    { branch_value: of((row) => row.value), branch_rms: of((row) => row.rms), branch_number: of((row) => row.branch), steady_value: steady, growth_rate: growth, fold_value: [], fold_rms: [], hopf_value: [], value: [1, 2] },
    [
      array("rms", ["direction", "value"], [1, 2], [0.1, 0.2]),
      array("direction", ["direction"], [1], [], { type: "text", data: new Float64Array(0), texts: ["forward"] }),
      u8("branch_stable", of((row) => Number(row.stable))),
    ],
  );
  return { told, steady, growth, branch: collectBranch()(frame(arrays)) as Branch };
}

const axis = { label: "x", scale: "linear" } as const;
const contact: ContactState = {
  part: "law", quantity: "force", speeds: [1e-6, 1e4], depths: [1e-6, 1], cursor: null, fitSpeeds: [1, 2], fitDepths: [1, 2], hasRanges: false, compare: null, velocity: null, loading: null, asked: (kind, name) => ({ kind, name }),
};

/** A law with holes. */
function law(seed: number) {
  const next = random(seed);
  const [velocity, indentation] = [times(9, (i) => 10 ** (i - 4)), times(4, (i) => 10 ** (i - 4))];
  const values = Float64Array.from(gappy(36, next, 1));
  return { velocity: Float64Array.from(velocity), indentation: Float64Array.from(indentation), values: { force: values, area: values, friction: values } };
}

/** Every chart that draws lines, by its file and name: what it draws for a seed, and what it may join. */
interface Case {
  readonly spec: ChartSpec;
  readonly rows: readonly Row[];
  /** Labels of lines that are shapes. */
  readonly shapes?: readonly string[];
}

const CHARTS: Readonly<Record<string, (seed: number) => readonly Case[]>> = {
  "pages/point/branch.ts branchSpec": (seed) => {
    const { told, steady, growth, branch } = branches(seed);
    const sliding = steady.map((x, i): Row => ({ x, y: Number.isNaN(growth[i]) ? nan : 0, run: "steady" }));
    return [{ spec: branchSpec(branch, axis, null), rows: [...told.map((row): Row => ({ x: row.value, y: row.rms, run: `branch ${row.branch}` })), ...sliding] }];
  },
  "pages/point/eigen.ts eigenSpec": (seed) => eigenvalues(seed).map(({ path, rows }) => ({ spec: eigenSpec({ modes: [], trail: [], path, pathName: "path", alongName: "key" }), rows })),
  "pages/point/eigen.ts growthSpec": (seed) => eigenvalues(seed).map(({ path, growth }) => ({ spec: growthSpec(path, axis, null), rows: rowsOf("growth", path.along, growth) })),
  "pages/point/cycle.ts floquetSpec": () => [{ spec: floquetSpec([[1, 0], [0.5, 0.1]]), rows: [], shapes: ["unit circle"] }],
  "pages/point/motion.ts historySpecs": (seed) => {
    const motion = motionOf(seed);
    const [x, y, velocity] = historySpecs(motion, 0.3, null) as [ChartSpec, ChartSpec, ChartSpec];
    const of = (values: Float64Array) => rowsOf("time", motion.time, values);
    return [{ spec: x, rows: of(motion.x) }, { spec: y, rows: of(motion.y) }, { spec: velocity, rows: of(motion.velocity) }];
  },
  "pages/point/motion.ts portraitSpec": (seed) => {
    const motion = motionOf(seed);
    const known = motion.time.findIndex((time) => time >= motion.known);
    return [{ spec: portraitSpec(motion, null, 0.3, 0), rows: rowsOf("path", motion.x.subarray(known), motion.velocity.subarray(known)) }];
  },
  "pages/point/motion.ts spectrumSpec": (seed) => {
    const [x, y] = [Float64Array.from(times(20, (i) => i)), Float64Array.from(gappy(20, random(seed)))];
    return [{ spec: spectrumSpec({ x, y }, []), rows: rowsOf("spectrum", x, y) }];
  },
  "pages/map/spec.ts mapSpec": (seed) => {
    const next = random(seed);
    const pieces = times(1 + Math.floor(3 * next()), (piece) => [...times(2 + Math.floor(5 * next()), (): Row => ({ x: next(), y: next(), run: `piece ${piece}` })), { x: nan, y: nan, run: "gap" }]).flat();
    const curve = { x: Float64Array.from(pieces, (row) => row.x), y: Float64Array.from(pieces, (row) => row.y) };
    const picture = { plane: "", options: "", stage: "exact", x: Float64Array.of(0, 1), y: Float64Array.of(0, 1), classes: new Uint8Array(4), words: ["stable"], withinLaw: null, unresolved: 0, boundaries: { full: curve } } as const;
    const key = (path: string): Key => ({ path, section: "", symbol: "a", group: "a", unit: "1", doc: "", range: { above: 0 }, slider: { from: 0, to: 1, scale: "linear" }, label: "", label_si: "" });
    const side = (path: string) => ({ key: path, from: 0, to: 1, scale: "linear" }) as const;
    const state: MapState = { x: side("a.x"), y: side("a.y"), show: ["full"], marks: [], cursor: null, pin: null };
    // roots of one value are not told apart: points alone
    const roots = { x: Float64Array.of(0.1, 0.1, 0.2), y: Float64Array.of(0.1, 0.9, 0.8) };
    return [{ spec: mapSpec({ state, x: key("a.x"), y: key("a.y"), window: null, picture, critical: { full: roots, conservative: roots } }), rows: pieces }];
  },
  "pages/contact/law.ts speedCutSpec": (seed) => {
    const own = law(seed);
    const rows = Array.from(own.indentation).flatMap((_, row) => rowsOf(`depth ${row}`, own.velocity, own.values.force.subarray(9 * row, 9 * row + 9)));
    return [{ spec: speedCutSpec({ law: own, state: contact, cursor: { velocity: 1, indentation: 0.01 }, beside: null, operating: null, contrast: null }), rows }];
  },
  "pages/contact/law.ts depthCutSpec": (seed) => {
    const own = law(seed);
    const columns = [0, 2, 4, 6, 8].flatMap((column) => rowsOf(`speed ${column}`, own.indentation, times(4, (row) => own.values.force[9 * row + column] as number)));
    return [{ spec: depthCutSpec({ law: own, state: contact, cursor: { velocity: 1, indentation: 0.01 }, beside: null, operating: null, contrast: null }), rows: columns }];
  },
  "pages/contact/fit.ts curvesSpec": (seed) => {
    const own = law(seed);
    const rows = Array.from(own.indentation).flatMap((_, row) => rowsOf(`depth ${row}`, own.velocity, own.values.force.subarray(9 * row, 9 * row + 9)));
    return [{ spec: fitSpec({ computed: own, fitted: own }, "force"), rows }];
  },
  "pages/contact/material.ts modulusSpec": (seed) => {
    const { arrays, of } = moduli(seed);
    return [{ spec: modulusSpec(frame(arrays), []), rows: [...of("storage_modulus"), ...of("loss_modulus")] }];
  },
  "pages/contact/material.ts tangentSpec": (seed) => {
    const { arrays, of } = moduli(seed);
    return [{ spec: tangentSpec(frame(arrays), []), rows: of("loss_tangent") }];
  },
  "pages/contact/solution.ts fieldSpec": (seed) => {
    const { solution, loops } = solved(seed);
    return [{ spec: fieldSpec(solution, "pressure"), rows: loops, shapes: ["Hertz"] }];
  },
  "pages/contact/solution.ts pressureCutSpec": (seed) => {
    const { solution, middle } = solved(seed);
    return [{ spec: pressureCutSpec(solution), rows: rowsOf("cut", solution.pressure.x, middle(solution.pressure.values)), shapes: ["Hertz"] }];
  },
  "pages/contact/solution.ts surfaceCutSpec": (seed) => {
    const { solution, middle } = solved(seed);
    const highest = 4 * middle(solution.height.values).reduce((most, height, i) => (middle(solution.pressure.values)[i] as number) > 0 ? Math.max(most, height) : most, 0);
    const indenter = middle(solution.height.values).map((height) => (height < highest ? height - solution.depth : nan));
    return [{ spec: surfaceCutSpec(solution), rows: [...rowsOf("indenter", solution.height.x, indenter), ...rowsOf("surface", solution.height.x, middle(solution.displacement.values).map((value) => -value))] }];
  },
  "pages/structures/locus.ts frequencySpec": (seed) => {
    const { locus, of } = loci(seed);
    return [{ spec: frequencySpec(locus, "l"), rows: of((row) => locus.along[row] as number, locus.frequency), shapes: ["its frequency"] }];
  },
  "pages/structures/locus.ts growthSpec": (seed) => {
    const { locus, of } = loci(seed);
    return [{ spec: locusGrowthSpec(locus, "l"), rows: of((row) => locus.along[row] as number, locus.growth) }];
  },
  "pages/structures/locus.ts planeSpec": (seed) => {
    const { locus, of } = loci(seed);
    return [{ spec: planeSpec(locus, "l", 2), rows: of((_, index) => locus.growth[index] as number, locus.frequency) }];
  },
  "pages/structures/march.ts signalSpec": (seed) => {
    const [x, y] = [times(30, (i) => i), gappy(30, random(seed))];
    const own = analysis("m", "march", [variable("time", ["time"], [30]), variable("y", ["time"], [30])]);
    return [{ spec: signalSpec({ analysis: own, name: "y", trace: { x, y }, whole: [0, 29], bands: [], window: undefined }), rows: rowsOf("y", x, y) }];
  },
  "pages/structures/spectrogram.ts spectrogramSpec": () => {
    const own = analysis("s", "spectrogram", []);
    const zones = columns({ zone_from: [11, 14], zone_to: [12, 16], zone_frequency: [3, 5] });
    const arrays = new Map([...columns({ time: [0, 1, 2, 3], position: [10, 12, 14, 16], frequency: [0, 5, 10], level: new Float64Array(12) }), ...zones]);
    const spec = spectrogramSpec(own, readLevels(own, arrays) as NonNullable<ReturnType<typeof readLevels>>, "position");
    const half = 0.02 * 7.5;
    const frames = [[11, 12, 3], [14, 16, 5]].map(([a, b, f], zone) => [[a, -half], [a, half], [b, half], [b, -half], [a, -half]].map(([x, y]): Row => ({ x: x as number, y: (f as number) + (y as number), run: `zone ${zone}` })));
    return [{ spec, rows: frames.flat() }];
  },
  "pages/structures/body.ts bodySpec": (seed) => {
    const next = random(seed);
    const places = Float64Array.from(times(8, () => [next(), next(), 0]).flat());
    const lines = [0, 1, 1, 2, 5, 6, 7, 3];
    const body = bodyOf(places, lines);
    const [x, y] = [0, 1].map((axis) => times(8, (i) => (places[3 * i + axis] as number) - (body.centre[axis] as number))) as [number[], number[]];
    const rows = times(4, (k) => [lines[2 * k] as number, lines[2 * k + 1] as number].map((i): Row => ({ x: x[i] as number, y: y[i] as number, run: `line ${k}` }))).flat();
    return [{ spec: bodySpec("b", body, swingOf(body, new Float64Array(24), false), { azimuth: 0, elevation: 0 }, 0, 0), rows }];
  },
  "pages/structures/genericCharts.ts genericCharts": (seed) => generic(seed),
};

/** Four eigenvalues that come in any order and are not everywhere, far from one another beside their steps. */
function eigenvalues(seed: number) {
  const next = random(seed);
  const along = Float64Array.from(times(15, (i) => i));
  const of = (i: number, k: number): readonly [number, number] => [10 * k + 0.1 * i, 7 * k - 0.2 * i];
  const holes = times(15, () => next() < 0.15);
  const data = times(15, (i) => times(4, (k) => ({ k, at: next() })).sort((a, b) => a.at - b.at).flatMap(({ k }) => (holes[i] ? [nan, nan] : of(i, k)))).flat();
  const rows = times(4, (k) => times(15, (i): Row => ({ x: holes[i] ? nan : of(i, k)[0], y: of(i, k)[1], run: `eigenvalue ${k}` }))).flat();
  return [{ path: joined(along, Float64Array.from(data), 4), rows, growth: times(15, (i) => (holes[i] ? nan : of(i, 3)[0])) }];
}

/** A motion of which only the second half is known step by step. */
function motionOf(seed: number): Motion {
  const next = random(seed);
  const [time, x, y, velocity] = [times(24, (i) => i), gappy(24, next), gappy(24, next), gappy(24, next)].map((values) => Float64Array.from(values)) as [Float64Array, Float64Array, Float64Array, Float64Array];
  return { time, x, y, velocity, states: [], fine: { time, x, velocity }, known: 12, spectrum: null, outcome: null };
}

function moduli(seed: number) {
  const next = random(seed);
  const frequency = times(12, (i) => 10 ** i);
  const arrays = columns({ frequency, storage_modulus: gappy(12, next, 1), loss_modulus: gappy(12, next, 2), loss_tangent: gappy(12, next, 3) });
  return { arrays, of: (name: string) => rowsOf(name, frequency, arrays.get(name)?.data ?? []) };
}

/** A contact in islands. */
function solved(seed: number) {
  const next = random(seed);
  const x = Float64Array.from(times(8, (i) => i - 3.5));
  const field = (values: number[]) => ({ x, y: x, values: Float64Array.from(values) });
  const pressure = field(times(64, () => (next() < 0.5 ? next() : 0)));
  const edge = boundary(pressure);
  const elastic = [{ name: "Hertz", radius: 1, pressure: 1, role: { series: 1 } as const }];
  const solution = { pressure, gap: pressure, displacement: field(times(64, () => next())), height: field(times(64, () => 3 * next())), depth: 0.2, boundary: edge, elastic };
  const middle = (values: Float64Array) => Array.from(values.subarray(24, 32));
  // loops end with a gap; along every one of them a step is one side of a cell
  let loop = 0;
  const loops = Array.from(edge.x, (value, i): Row => ({ x: value, y: edge.y[i] as number, run: `loop ${Number.isNaN(value) ? loop++ : loop}` }));
  for (const [i, row] of loops.entries()) {
    const last = loops[i - 1];
    if (last && last.run === row.run && isRow(last.x, row.x)) expect(Math.abs(row.x - last.x) + Math.abs(row.y - last.y)).toBeCloseTo(1, 12);
  }
  return { solution, middle, loops };
}

/** Branches that are not everywhere. */
function loci(seed: number) {
  const next = random(seed);
  const pairs = times(60, () => (next() < 0.2 ? [nan, nan] : [next() - 0.5, 100 * next()])).flat();
  const own = analysis("l", "locus", [variable("position", ["position"], [20], { units: "m" }), variable("eigenvalue", ["position", "branch"], [20, 3])]);
  const arrays = new Map([array("position", ["position"], [20], times(20, (i) => i)), array("eigenvalue", ["position", "branch"], [20, 3], pairs, { type: "complex" }), ...columns({ zone_from: [1], zone_to: [2], zone_peak: [1.5], zone_frequency: [50], zone_growth_rate: [0.5] })]);
  const locus = readLocus(own, arrays);
  if (!locus) throw new Error("no locus");
  const of = (across: (row: number, index: number) => number, up: Float64Array) => times(3, (branch) => times(20, (row): Row => ({ x: across(row, 3 * row + branch), y: up[3 * row + branch] as number, run: `branch ${branch}` }))).flat();
  return { locus, of };
}

/** Tables of any study: over a coordinate with gaps, to and fro along one, lists of roots, kinds that are only counted. */
function generic(seed: number): readonly Case[] {
  const next = random(seed);
  const speed = times(12, (i) => i / 7);
  const shuffled = [...speed].sort(() => next() - 0.5);
  const chart = (name: string, dimensions: string[], shape: number[], data: number[], values: number[], attributes: Readonly<Record<string, unknown>> = {}) => {
    const one = variable(name, dimensions, shape, { attributes });
    const own = analysis("g", "any", [variable("speed", ["speed"], [12], { units: "m/s" }), one]);
    return genericCharts(own, one, new Map([array("speed", ["speed"], [12], values), array(name, dimensions, shape, data)]), {}).map(({ spec }) => spec);
  };
  const [level, fro] = [gappy(12, next), gappy(12, next)];
  const roots = times(12, () => (next() < 0.5 ? [next(), nan, nan] : [next(), 1 + next(), 2 + next()])).flat();
  const sorted = shuffled.map((x, i) => ({ x, y: fro[i] as number, run: "rms" })).sort((a, b) => a.x - b.x);
  const case_ = (rows: readonly Row[]) => (spec: ChartSpec): Case => ({ spec, rows });
  return [
    ...chart("rms", ["speed"], [12], level, speed).map(case_(rowsOf("rms", speed, level))),
    ...chart("rms", ["speed"], [12], fro, shuffled).map(case_(sorted)),
    ...chart("full", ["speed", "root"], [12, 3], roots, speed, { neighbours: "apart" }).map(case_([])),
    ...chart("branch_rms", ["branch_point"], [12], level, speed).map(case_([])),
    ...chart("becomes", ["speed"], [12], level, speed, { flag_values: [0, 1], flag_meanings: "rest cycle" }).map(case_([])),
  ];
}

const SOURCE = join(import.meta.dirname, "../src");
const sources = readdirSync(SOURCE, { recursive: true, encoding: "utf8" }).filter((name) => /\.tsx?$/.test(name)).map((name) => join(SOURCE, name));

describe("no drawn segment joins rows that do not follow one another", () => {
  it("is held against every chart that draws lines", () => {
    // charts draw what they are given, reports what is described, whose lines have their gaps
    const given = (name: string) => name.includes("/chart/") || name.includes("/report/");
    const drawing = sources.filter((name) => !given(name) && /kind: "line"/.test(readFileSync(name, "utf8")));
    const builders = drawing.flatMap((name) =>
      Array.from(readFileSync(name, "utf8").matchAll(/^export function (\w+)\([^\n]*\): (?:readonly )?(?:ChartSpec|GenericChart)\b/gm), ([, builder]) => `${relative(SOURCE, name)} ${builder}`),
    );
    // maps and residuals have no lines beside a point
    const lineless = ["pages/contact/law.ts mapSpec", "pages/contact/fit.ts residualSpec"];
    expect(Object.keys(CHARTS).sort()).toEqual(builders.filter((name) => !lineless.includes(name)).sort());
    const covered = new Set(Object.keys(CHARTS).map((name) => name.split(" ")[0]));
    expect(drawing.map((name) => relative(SOURCE, name)).filter((name) => !covered.has(name))).toEqual([]);
  });

  for (const [name, cases] of Object.entries(CHARTS)) {
    it(`in ${name}, and all that do are joined`, () => {
      for (const seed of SEEDS) {
        for (const { spec, rows, shapes } of cases(seed)) expect(drawn(spec, shapes), `${spec.title}, seed ${seed}`).toEqual(allowed(rows));
      }
    });
  }

  it("in a stable line, whose cycles all are", () => {
    for (const seed of SEEDS) {
      const { told, branch } = branches(seed);
      const stable = new Set(told.filter((row) => row.stable).map((row) => place(row.value, row.rms)));
      const line = branchSpec(branch, axis, null).layers.find((layer) => layer.label === "cycles, stable") as LineLayer | undefined;
      for (let i = 0; i < (line?.x.length ?? 0); i += 1) {
        const [x, y] = [line?.x[i] as number, line?.y[i] as number];
        if (isRow(x, y)) expect(stable, `seed ${seed}`).toContain(place(x, y));
      }
    }
  });
});

/** The stretches of a path, each as its points. */
function stretches(shapes: readonly Shape[]): readonly (readonly [number, number])[][] {
  const paths = shapes.flatMap(function inside({ attributes, children }: Shape): string[] {
    const own = attributes["fill"] === "none" && typeof attributes["d"] === "string" && /L/.test(attributes["d"]) ? [attributes["d"]] : [];
    return [...own, ...children.flatMap((child) => (typeof child === "string" ? [] : inside(child)))];
  });
  return paths.flatMap((path) => path.split("M").slice(1).map((part) => part.split("L").map((point) => point.split(",").map(Number.parseFloat) as [number, number])));
}

describe("a drawn line", () => {
  it("never crosses a gap, however many points are left out", () => {
    for (const seed of SEEDS.slice(0, 20)) {
      const next = random(seed);
      const count = [30, 900, 20_000][seed % 3] as number;
      const turns = seed % 2 === 0;
      // every run lies in a band of its own
      let run = 0;
      const y = times(count, () => {
        if (next() >= Math.min(0.2, 40 / count)) return run + 0.4 * next();
        run += 1;
        return nan;
      });
      const x = times(count, (i) => (turns && i > count / 2 ? count - i : i));
      const spec: ChartSpec = { title: "", x: axis, y: { ...axis, range: [0, run + 1] }, layers: [{ kind: "line", label: "", x, y, role: { series: 0 } }] };
      const { frame, over } = draw(spec, homeWindow(spec), { width: 640, height: 420 }, "light", "p");
      const bands = stretches(over.filter(({ attributes }) => attributes["clip-path"] !== undefined)).map((points) => points.map(([, py]) => Math.floor((1 - (py - frame.top) / frame.height) * (run + 1) + 1e-3)));
      expect(bands.length).toBeGreaterThan(3);
      for (const points of bands) expect(new Set(points).size, `seed ${seed}`).toBe(1);
    }
  });
});
