import { describe, expect, it } from "vitest";
import { chartCsv } from "../src/chart/csv";
import { through } from "../src/chart/runs";
import { beyond, floquetSpec } from "../src/pages/point/cycle";
import { eigenSpec, growthAlong, joined, modesOf } from "../src/pages/point/eigen";
import { valueOnAxisOf } from "../src/pages/point/keys";
import { collectMotion, merged, spectrumSpec, stretchesOf, strongest } from "../src/pages/point/motion";
import { ground, normalised, orbitAt, orbitCsv, slowed } from "../src/pages/point/orbit";
import { RATE, type Track, faded, modeTrack, octaveFactor, render, wav } from "../src/pages/point/sound";
import { branchAxis, caseAnalysis, readPoint, withRun } from "../src/pages/point/state";
import { parseView } from "../src/state/view";
import type { CaseValue, Key, Pair, Session } from "../src/wire/api";
import { decodeFrame } from "../src/wire/frames";
import { encode } from "./encode";
import { PAGE_FIELDS, settings } from "./declared";

const key = (path: string, group: string | null, from: number, to: number, unit = group === null ? "Pa" : "1"): Key => ({
  path, section: "", symbol: path, group, unit, doc: "", range: { above: 0 }, slider: { from, to, scale: "log" }, label: "", label_si: "",
});
const strength = key("contact.shear_strength", "τ0/E0*", 1e-4, 1);
const modulus = key("substrate.rubbery_modulus", null, 1e4, 1e8);
const keys = new Map([strength, modulus].map((key) => [key.path, key]));
const session = { map: null, settings } as unknown as Session;
const view = (query: string) => parseView("/point", query, PAGE_FIELDS).view;
const group = (number: number): CaseValue => ({ path: strength.path, form: "group", number, si: null, group: number });
const withUnit = (key: Key, si: number, group: number | null): CaseValue => ({ path: key.path, form: "si", number: si, si, group });
const read = (query: string) => readPoint(view(query), session, keys, () => group(0.05));

describe("the state of the point page", () => {
  it("has a home, and drops what cannot be", () => {
    expect(read("")).toMatchObject({ along: null, run: [], motion: { duration: 500 }, factor: null, volume: 0.5 });
    expect(read("along=fish&points=-3&factor=-1&volume=7")).toMatchObject({ along: null, factor: null, volume: 0.5 });
    const wrong = ["run=fish", "sound=fish", "sound=mode-9", "factor=-1", "factor=0", "factor=Infinity", "volume=9", "volume=-0.1", "points=1.5", "steps=1"];
    for (const field of wrong) expect(parseView("/point", field, PAGE_FIELDS).told, field).toHaveLength(1);
    const right = "sound=mode-2&factor=0.25&volume=1&points=512&steps=2";
    expect(parseView("/point", right, PAGE_FIELDS).told).toEqual([]);
    expect(read(right)).toMatchObject({ sound: "mode-2", factor: 0.25, volume: 1, motion: { points: 512 }, diagrams: [{ sweep: { points: 2 } }, { sweep: { points: 2 }, branches: true }] });
    expect(read("duration=5 s&along=contact.shear_strength")).toMatchObject({ motion: { duration: "5 s" }, along: strength });
  });

  it("starts a branch about the present value, within the slider", () => {
    expect(read("").branch).toEqual({ key: strength.path, from: 0.025, to: 0.1, scale: "log" });
    expect(branchAxis(strength, session, group(0.9))).toMatchObject({ from: 0.45, to: 1 });
    expect(branchAxis(strength, session, group(0))).toMatchObject({ from: 1e-4, to: 1 });
    expect(branchAxis(strength, session, undefined)).toMatchObject({ from: 1e-4, to: 1 });
    expect(branchAxis(modulus, session, withUnit(modulus, 1e6, null))).toMatchObject({ from: "500000 Pa", to: "2000000 Pa" });
  });

  it("writes a unit behind numbers of that unit alone, whatever form the value was given in", () => {
    const axis = { key: strength.path, from: "1e3 Pa", to: "1e6 Pa", scale: "log" } as const;
    const mapped = { map: { x: axis, y: axis } } as unknown as Session;
    const pascal = key(strength.path, strength.group, 1e-4, 1, "Pa");
    const e0 = 2e4 / 0.0135;
    expect(branchAxis(pascal, mapped, withUnit(pascal, 2e4, 0.0135))).toEqual({ ...axis, from: "10000 Pa", to: "40000 Pa" });
    expect(branchAxis(pascal, mapped, { ...withUnit(pascal, 2e4, 0.0135), form: "group", number: 0.0135 })).toEqual({ ...axis, from: "10000 Pa", to: "40000 Pa" });
    // the slider, which has groups, ends at E0*
    expect(branchAxis(pascal, mapped, withUnit(pascal, 0.9 * e0, 0.9)).to).toBe(`${Number(e0.toPrecision(3))} Pa`);
    // the value in Pa of a group is not known: no number of the one form stands on an axis of the other
    expect(branchAxis(pascal, mapped, group(0.0135))).toEqual(axis);
    const values = (value: CaseValue) => ({ values: [value], scales: {} });
    expect(valueOnAxisOf(pascal, axis, values(group(0.0135)))).toBeNull();
    expect(valueOnAxisOf(pascal, axis, values(withUnit(pascal, 2e4, 0.0135)))).toBe(2e4);
    expect(valueOnAxisOf(pascal, { ...axis, from: 1e-4, to: 1 }, values(withUnit(pascal, 2e4, 0.0135)))).toBe(0.0135);
  });

  it("asks for branches after the simulated points, and exports what was started last", () => {
    expect(read("").diagrams.map((analysis) => analysis["branches"])).toEqual([undefined, true]);
    expect(read("simulated=on").diagrams).toHaveLength(1);
    expect(caseAnalysis(read(""), session)).toBeNull();
    expect(caseAnalysis(read(`along=${strength.path}`), session)?.kind).toBe("spectrum");
    const both = withRun(withRun(view("run=motion"), "cycle", true), "cycle", true);
    expect(both.fields["run"]).toBe("motion,cycle");
    expect(caseAnalysis(read("run=motion,cycle"), session)?.kind).toBe("limit-cycle");
    expect(withRun(view("run=motion"), "motion", false).fields["run"]).toBeUndefined();
  });
});

describe("eigenvalues", () => {
  const four: Pair[] = [[-0.4, -8], [0.04, 0], [30, 0], [-0.4, 8]];

  it("are modes: conjugate pairs once, with the positive frequency", () => {
    expect(modesOf(four).map((mode) => [mode.name, mode.value, mode.oscillates, mode.index])).toEqual([
      ["mode 1", [30, 0], false, 2],
      ["mode 2", [0.04, 0], false, 1],
      ["mode 3", [-0.4, 8], true, 3],
    ]);
    const layer = eigenSpec({ modes: modesOf(four), trail: [], path: null, pathName: "", alongName: "" }).layers.at(-1);
    expect(layer).toMatchObject({ label: "mode 3", y: [8, -8] });
  });

  it("are joined to lines that do not jump, in whatever order they come", () => {
    const along = Float64Array.from({ length: 50 }, (_, i) => i);
    const shuffled = [...along].flatMap((t) => {
      const row: Pair[] = [[0.01 * t, 1 + 0.01 * t], [0.01 * t, -1 - 0.01 * t], [-1, 3 - 0.05 * t], [-1, 0.05 * t - 3]];
      return [...row.slice(t % 4), ...row.slice(0, t % 4)].flat();
    });
    const path = joined(along, Float64Array.from(shuffled), 4);
    for (const { re, im } of path.lines) {
      for (let i = 1; i < 50; i += 1) expect(Math.hypot((re[i] ?? 0) - (re[i - 1] ?? 0), (im[i] ?? 0) - (im[i - 1] ?? 0))).toBeLessThan(0.06);
    }
    expect(growthAlong(path)[49]).toBeCloseTo(0.49, 12);
  });

  it("are saved with the name of each line and the value of the key", () => {
    const path = joined(Float64Array.of(10, 20), Float64Array.of(-0.4, 8, -0.4, -8, -0.3, 7, -0.3, -7), 2);
    const parts = { modes: modesOf(four), trail: [four], path, pathName: "path along load", alongName: "operation.normal_load (N)" };
    const [headings, ...rows] = chartCsv(eigenSpec(parts)).trimEnd().split("\n");
    expect(headings).toBe("layer,operation.normal_load (N),Growth rate Re λ/ωnx,Frequency Im λ/ωnx");
    expect(rows.slice(0, 4)).toEqual([
      'path along load: eigenvalue 1,10,-0.4,-8',
      'path along load: eigenvalue 1,20,-0.3,-7',
      'path along load: eigenvalue 2,10,-0.4,8',
      'path along load: eigenvalue 2,20,-0.3,7',
    ]);
    expect(rows.filter((row) => row.startsWith("before,"))).toHaveLength(4);
    expect(rows.filter((row) => row.startsWith(",") || row.includes("e+200"))).toEqual([]);
  });
});

describe("a mode shape", () => {
  it("fills its picture, and turns as its phase says", () => {
    const circle = normalised([[3, 0], [0, -3]]);
    expect(orbitAt(circle, 0)[0]).toBeCloseTo(1, 12);
    expect(orbitAt(circle, Math.PI / 2)[1]).toBeCloseTo(1, 12);
  });

  /** Rows of a mode's file as numbers, and its headings. */
  const saved = (shape: readonly Pair[], oscillates: boolean) => {
    const [headings, ...rows] = orbitCsv(normalised(shape), oscillates).trimEnd().split("\n").map((row) => row.split(","));
    return { headings, rows: rows.map((row) => row.map(Number) as [number, number, number]) };
  };
  // x leads y by more than a quarter turn, and is smaller
  const ellipse: readonly Pair[] = [[0.3, 0.5], [-1.1, 0.4]];

  it("is saved as the real part of its eigenvector at each phase", () => {
    const { headings, rows } = saved(ellipse, true);
    expect(headings).toEqual(["phase (rad)", "x over the largest distance", "y into the substrate over the largest distance"]);
    const real = (i: 0 | 1, phase: number) => (ellipse[i]?.[0] ?? 0) * Math.cos(phase) - (ellipse[i]?.[1] ?? 0) * Math.sin(phase);
    const turn = Array.from({ length: 3600 }, (_, i) => (i * Math.PI) / 1800);
    const largest = Math.max(...turn.map((phase) => Math.hypot(real(0, phase), real(1, phase))));
    for (const [phase, x, y] of rows) {
      expect(x).toBeCloseTo(real(0, phase) / largest, 4);
      expect(y).toBeCloseTo(real(1, phase) / largest, 4);
    }
    expect([rows[0]?.[0], rows.at(-1)?.[0]]).toEqual([0, 2 * Math.PI]);
  });

  it("is drawn through the points that are saved, with y downwards", () => {
    const drawn = ground(normalised(ellipse), true, 0, "light").filter(({ attributes }) => attributes["stroke-width"] === 2);
    const points = String(drawn[0]?.attributes["d"]).slice(1).split("L").map((pair) => pair.split(" ").map(Number) as [number, number]);
    const { rows } = saved(ellipse, true);
    expect(points).toHaveLength(rows.length);
    points.forEach(([across, down], i) => {
      expect((across - 120) / 50).toBeCloseTo(rows[i]?.[1] ?? Number.NaN, 3);
      expect((down - 94) / 50).toBeCloseTo(rows[i]?.[2] ?? Number.NaN, 3);
    });
  });

  it("that does not oscillate is saved by the way along its line, not by a phase", () => {
    for (const line of [[[3, 0], [-4, 0]], [[0, 3], [0, -4]]] as const) {
      const { headings, rows } = saved(line, false);
      expect(headings?.[0]).toBe("displacement along the line over the largest");
      const direction = Math.sign((rows.find(([along]) => along > 0.5) as readonly number[])[1] as number);
      for (const [along, x, y] of rows) {
        expect(x).toBeCloseTo(0.6 * direction * along, 10);
        expect(y).toBeCloseTo(-0.8 * direction * along, 10);
      }
      expect(Math.max(...rows.map(([along]) => along))).toBeCloseTo(1, 10);
    }
  });

  it("is slowed by a factor that is the same for growth and frequency", () => {
    const fast = slowed([-20, 300]);
    const later = fast.at(1);
    expect(later.phase).toBeCloseTo(300 / fast.factor, 12);
    expect(later.amplitude / fast.at(0).amplitude).toBeCloseTo(Math.exp(-20 / fast.factor), 12);
    const real = slowed([1000, 0]);
    for (const t of [0, 0.3, 1, 2.9, 17]) expect(real.at(t).amplitude).toBeLessThanOrEqual(1 + 1e-12);
    expect(slowed([0, 0]).at(5)).toEqual({ amplitude: 1, phase: 0 });
  });
});

const STATES = ["stick", "slip", "slip_ahead", "lift-off"];

const arrays = (columns: Record<string, readonly number[]>, kind = "block") => {
  const entries = Object.entries(columns);
  const length = entries[0]?.[1].length ?? 0;
  const stride = Math.ceil(length / 8) * 8;
  const payload = new Uint8Array(entries.reduce((sum, [name]) => sum + (name === "contact_state" ? stride : 8 * length), 0));
  let offset = 0;
  const listed = entries.map(([name, values]) => {
    const isCode = name === "contact_state";
    payload.set(isCode ? Uint8Array.from(values) : new Uint8Array(Float64Array.from(values).buffer), offset);
    const entry = { name, type: isCode ? "u8" : "f64", shape: [length], dimensions: ["time"], offset, attributes: isCode ? { flag_meanings: STATES.join(" ") } : {} };
    offset += isCode ? stride : 8 * length;
    return entry;
  });
  return decodeFrame(encode({ kind, arrays: listed }, payload));
};

describe("a motion", () => {
  it("grows with its blocks, beyond the room that it has at first", () => {
    const take = collectMotion();
    let last = null;
    for (let block = 0; block < 30; block += 1) {
      const time = Array.from({ length: 300 }, (_, i) => block * 300 + i);
      last = take(arrays({ time, x: time, y: time, velocity_x: time, velocity_y: time, contact_state: time.map((t) => (t < 4500 ? 1 : 0)) }));
    }
    expect(last?.time.length).toBe(9000);
    expect(last?.x[8999]).toBe(8999);
    expect(last?.states.map(({ state }) => state)).toEqual(["stick", "slip", "slip ahead", "lift-off"]);
    expect([...(last?.states[0]?.from ?? [])]).toEqual([4500]);
    expect(take(arrays({ time: [0] }, "progress"))).toBeNull();
  });

  it("has stretches that meet, and steps between the points of its grid", () => {
    const states = stretchesOf(Float64Array.of(0, 1, 2, 3), Uint8Array.of(1, 0, 0, 3), STATES);
    expect([...(states[1]?.to ?? [])]).toEqual([1]);
    expect([...(states[0]?.from ?? []), ...(states[0]?.to ?? [])]).toEqual([1, 3]);
    const curve = (...time: number[]) => ({ time: Float64Array.from(time), x: Float64Array.from(time), velocity: Float64Array.from(time) });
    expect([...merged(curve(0, 2, 4), curve(1, 2, 5)).time]).toEqual([0, 1, 2, 2, 4, 5]);
  });

  it("has a spectrum whose mean is no frequency", () => {
    const spectrum = { x: Float64Array.of(0, 1, 2, 3), y: Float64Array.of(9, 1, 4, 0) };
    expect(strongest(spectrum)).toBe(2);
    expect(strongest({ x: spectrum.x, y: new Float64Array(4) })).toBeNull();
    expect(spectrumSpec(spectrum, modesOf([[0, 5]])).x.range).toEqual([0, 3]);
  });
});

describe("a cycle and its branch", () => {
  it("tells the multiplier along the cycle from those that matter", () => {
    const list: Pair[] = [[-40, 0], [1.0000001, 0], [0.2, 0.1]];
    const labels = floquetSpec(list).layers.map((layer) => layer.label);
    expect(labels).toEqual(["unit circle", "along the cycle", "within: decays", "outside: grows"]);
    expect(beyond(list)).toBe(1);
  });

  it("goes on from stable to unstable without a hole, and not from branch to branch", () => {
    const line = { x: Float64Array.of(0, 1, 2, 3, 4), y: Float64Array.of(5, 6, 7, 8, 9) };
    const stable = [true, true, false, false, true];
    const numbers = [0, 0, 0, 0, 1];
    const isSame = (row: number) => numbers[row] === numbers[row + 1];
    const areStable = (row: number) => stable[row] === true && stable[row + 1] === true;
    expect([...through(line, (row) => isSame(row) && areStable(row)).x]).toEqual([0, 1, Number.NaN]);
    expect([...through(line, (row) => isSame(row) && !areStable(row)).x]).toEqual([1, 2, 3, Number.NaN]);
  });
});

describe("sound", () => {
  const tone = (frequency: number, seconds: number, loops: boolean): Track => {
    const count = Math.round(40 * frequency * seconds);
    const time = Float64Array.from({ length: count + 1 }, (_, i) => (seconds * i) / count);
    const rate = 2 * Math.PI * frequency;
    return { time, x: time.map((t) => Math.sin(rate * t) / rate), velocity: time.map((t) => Math.cos(rate * t)), frequency, loops };
  };
  const crossings = (samples: Float32Array) => samples.reduce((sum, value, i) => sum + (i > 0 && (samples[i - 1] ?? 0) < 0 && value >= 0 ? 1 : 0), 0);

  it("is shifted by octaves to between 200 and 2000 Hz", () => {
    expect([octaveFactor(9), octaveFactor(440), octaveFactor(5000), octaveFactor(0), octaveFactor(0.3)]).toEqual([32, 1, 0.25, 1, 1024]);
  });

  it("has the played frequency, its peak and its gain", () => {
    const { samples, gain, cut } = render(tone(10, 20, false), 40);
    expect(samples.length).toBe(RATE / 2);
    expect(crossings(samples)).toBeGreaterThanOrEqual(199);
    expect(crossings(samples)).toBeLessThanOrEqual(201);
    expect(samples.reduce((most, value) => Math.max(most, Math.abs(value)), 0)).toBeCloseTo(0.89, 5);
    expect(gain).toBeCloseTo(0.89, 2);
    expect(cut).toBe(false);
    expect(render(tone(10, 20, false), 0.1).cut).toBe(true);
  });

  it("loops without a jump", () => {
    const { samples } = render(tone(10, 0.1, true), 32);
    const steps = samples.map((value, i) => Math.abs(value - (samples[i - 1] ?? samples.at(-1) ?? 0)));
    const largest = steps.subarray(1).reduce((most, step) => Math.max(most, step), 0);
    expect(steps[0]).toBeLessThan(1.1 * largest);
    expect(Math.abs(crossings(samples) - 960)).toBeLessThanOrEqual(1);
  });

  it("begins and ends in silence", () => {
    const soft = faded(render(tone(10, 20, false), 40).samples);
    expect(soft[0]).toBe(0);
    expect(Math.abs(soft.at(-1) ?? 1)).toBeLessThan(1e-6);
  });

  it("is a mode that grows to its end or dies away", () => {
    const loud = (growth: number) => modeTrack([growth, 60]).velocity.map(Math.abs);
    const [growing, dying] = [loud(2), loud(-2)];
    expect(Math.max(...growing.slice(-60))).toBeGreaterThan(100 * Math.max(...growing.slice(0, 60)));
    expect(Math.max(...dying.slice(0, 60))).toBeGreaterThan(100 * Math.max(...dying.slice(-60)));
    expect(loud(1e-12).every(Number.isFinite)).toBe(true);
  });

  it("is written as 16-bit WAV", async () => {
    const bytes = new DataView(await wav(Float32Array.of(0, 1, -1)).arrayBuffer());
    expect(bytes.byteLength).toBe(50);
    expect([bytes.getUint32(24, true), bytes.getInt16(46, true), bytes.getInt16(48, true)]).toEqual([RATE, 32767, -32767]);
  });
});
