import { describe, expect, it } from "vitest";
import { drawnClasses, shares, withFrame } from "../src/pages/map/picture";
import { axisOver, digitsFor, optionsAt, rangeOfAxis, readMap, rounded, valueOnAxis } from "../src/pages/map/state";
import { criticalAnalysis, roots } from "../src/pages/map/useCritical";
import { parseView } from "../src/state/view";
import { numberIn, plainText, significant, sliderPlace, sliderValue, symbolMarkup, valueText } from "../src/ui/numbers";
import type { Key, Session } from "../src/wire/api";
import { decodeFrame } from "../src/wire/frames";
import { encode } from "./encode";
import { PAGE_FIELDS } from "./declared";

const key = (path: string, group: string | null, unit: string): Key => ({
  path,
  section: "",
  symbol: path,
  group,
  unit,
  doc: "",
  range: { above: 0 },
  slider: { from: 1e-4, to: 1, scale: "log" },
  label: "",
  label_si: "",
});
const velocity = key("operation.velocity", "v τ/R", "m/s");
const strength = key("contact.shear_strength", "τ0/E0*", "Pa");
const modulus = key("substrate.rubbery_modulus", null, "Pa");
const keys = new Map([velocity, strength, modulus].map((key) => [key.path, key]));
const home = { x: { key: velocity.path, from: 1e-8, to: 1e2, scale: "log" }, y: { key: strength.path, from: "1 kPa", to: "1 MPa", scale: "log" } } as const;
const session = { map: home } as unknown as Session;
const read = (query: string) => readMap(parseView("/map", query, PAGE_FIELDS).view, session, keys);

describe("the map's state", () => {
  it("is the session's where the address says nothing or nothing that can be", () => {
    expect(read("")).toMatchObject({ ...home, show: ["full"], cursor: null });
    expect(read("x=fish~1~2~log").x).toEqual(home.x);
    expect(read(`y=${velocity.path}~1~2~log`).y).toEqual(home.y);
    const swapped = read(`x=${strength.path}~0.1~1~log`);
    expect([swapped.x.key, swapped.y.key]).toEqual([strength.path, velocity.path]);
  });

  it("keeps the form of an axis, and the unit where a key takes nothing else", () => {
    expect(rangeOfAxis(home.x, velocity)).toEqual([1e-8, 1e2]);
    expect(rangeOfAxis(home.y, strength)).toBeNull();
    const zoomed = axisOver(home.y, strength, [1234.56789, 2e5]);
    expect(zoomed).toMatchObject({ from: "1235 Pa", to: "200000 Pa" });
    expect(rangeOfAxis(zoomed, strength)).toEqual([1235, 2e5]);
    expect(axisOver(home.x, velocity, [1.23456e-3, 1])).toMatchObject({ from: 1.235e-3, to: 1 });
    expect(valueOnAxis(zoomed, strength, 5)).toBe("5 Pa");
    expect(plainText(modulus, 1e6)).toBe("1000000 Pa");
    expect(rangeOfAxis({ ...home.x, from: 5 , to: 1 }, velocity)).toBeNull();
  });

  it("rounds places to what is shown, and finer in narrow windows", () => {
    expect(rounded({ x: 0.123456, y: 98765.4 }, { x: [1e-4, 1], y: [1, 1e6] })).toEqual({ x: 0.1235, y: 98770 });
    expect(digitsFor([1, 1.0001])).toBe(8);
    const at = optionsAt({ page: "map", set: { a: "1" }, fields: {} }, read(""), keys, { x: 1e-3, y: 2000 });
    expect(at).toEqual({ a: "1", [velocity.path]: "0.001", [strength.path]: "2000 Pa" });
  });
});

const frame = (header: object, numbers: readonly number[]) => {
  const bytes = new Uint8Array(Float64Array.from(numbers).buffer);
  return decodeFrame(encode(header, bytes));
};
const array = (name: string, shape: number[], offset: number, dimensions: string[] = []) => ({ name, type: "f64", shape, offset, dimensions });

describe("the map's picture", () => {
  const request = { set: [], ...home, boundaries: [] };
  const mapFrame = frame({ kind: "map", stage: "coarse", arrays: [array("x", [2], 0)] }, [1, 2]);
  const boundary = frame({ kind: "boundary", name: "full", arrays: [array("x", [1], 0), array("y", [1], 8)] }, [1, 2]);

  it("keeps curves while only the window moves, and drops those of another case or plane", () => {
    const first = withFrame(withFrame(null, mapFrame, request), boundary, request);
    expect(first?.boundaries.full?.y[0]).toBe(2);
    const zoomed = { ...request, x: { ...home.x, from: 1e-3 } };
    expect(withFrame(first, mapFrame, zoomed)?.boundaries.full).toBeDefined();
    expect(withFrame(first, mapFrame, { ...request, set: ["a=1"] })?.boundaries.full).toBeUndefined();
    expect(withFrame(first, mapFrame, { ...request, x: { ...home.x, scale: "linear" } })?.boundaries.full).toBeUndefined();
  });

  it("of a sketch is never the exact one", () => {
    const exact = { ...mapFrame, header: { ...mapFrame.header, stage: "exact" } };
    expect(withFrame(null, exact, request)?.stage).toBe("exact");
    expect(withFrame(null, exact, request, true)?.stage).toBe("coarse");
  });

  it("has no verdict where the errors of the law decide, until another map comes", () => {
    const bytes = (kind: string, name: string, codes: readonly number[]) => {
      const attributes = { flag_values: [0, 1, 2], flag_meanings: "decided marginal_within_the_law unknown" };
      const arrays = [{ name, type: "u8", shape: [2, 2], offset: 0, dimensions: ["y", "x"], attributes }];
      return decodeFrame(encode({ kind, stage: "exact", arrays }, Uint8Array.from([...codes, 0, 0, 0, 0])));
    };
    const map = bytes("map", "classes", [0, 1, 0, 4]);
    const nominal = withFrame(null, map, request);
    expect(nominal && [...drawnClasses(nominal, 8)]).toEqual([0, 1, 0, 4]);
    const within = withFrame(nominal, bytes("within-law", "within_law", [0, 1, 1, 2]), request);
    expect(within && [...drawnClasses(within, 8)]).toEqual([0, 8, 8, 4]);
    expect(within && [...within.classes]).toEqual([0, 1, 0, 4]);
    expect(withFrame(within, map, request)?.withinLaw).toBeNull();
  });

  it("has shares that add up", () => {
    expect(shares(Uint8Array.from([0, 0, 1, 3]), 4)).toEqual([0.5, 0.25, 0, 0.25]);
    expect(shares(new Uint8Array(0), 2)).toEqual([0, 0]);
  });

  it("reads roots as points", () => {
    const arrays = [array("velocity", [2], 0), array("full", [2, 2], 16, ["velocity", "full_root"])];
    const outcome = frame({ kind: "outcome", arrays }, [1, 2, 10, Number.NaN, 20, 21]);
    expect([...roots(outcome, "full").x]).toEqual([1, 2, 2]);
    expect([...roots(outcome, "full").y]).toEqual([10, 20, 21]);
    expect(roots(outcome, "conservative").x.length).toBe(0);
    expect(criticalAnalysis(home.x, home.y)).toMatchObject({ kind: "critical-shear-strength", within: { from: "1 kPa" } });
    expect(criticalAnalysis(home.y, home.x)).toBeNull();
  });
});

describe("sliders", () => {
  it("give values of four digits and come back to their place", () => {
    for (const place of [0, 1, 500, 999, 1000]) {
      const value = sliderValue(velocity, [1e-4, 1], place);
      expect(significant(value)).toBe(value);
      expect(Math.abs(sliderPlace(velocity, value) - place)).toBeLessThanOrEqual(1);
    }
    expect(sliderPlace(velocity, 10)).toBe(1000);
    expect(sliderPlace(velocity, 0)).toBe(0);
  });

  it("show values in the form in which they were given", () => {
    const value = { path: "", form: "si", number: 0.03, si: 0.03, group: 3e-4 } as const;
    expect(valueText(velocity, value)).toBe("0.03 m/s");
    expect(valueText(velocity, { ...value, form: "group", number: 3e-4 })).toBe("0.0003");
    expect([numberIn(modulus, "1e6 Pa"), numberIn(modulus, "1e6"), numberIn(modulus, "1 MPa")]).toEqual([1e6, undefined, undefined]);
    expect([numberIn(velocity, "1e-3"), numberIn(velocity, "1 m/s"), numberIn(velocity, "x")]).toEqual([1e-3, undefined, undefined]);
    expect(symbolMarkup("F_n/(E0* R²)")).toBe("$F_{n}/(E_{0}* R²)$");
  });
});
