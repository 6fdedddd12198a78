import { describe, expect, it } from "vitest";
import { otherForm, symbolText } from "../src/ui/numbers";
import type { Key } from "../src/wire/api";
import { asWritten, power, readable, rounded } from "../src/ui/readable";

describe("numbers as people read them", () => {
  it("takes a unit of the number's own size", () => {
    expect(readable(1.0024990065729677e-7, "m")).toEqual({ text: "100.25", unit: "nm" });
    expect(readable(2.146427162221018e-9, "m²")).toEqual({ text: "2146.43", unit: "µm²" });
    expect(readable(20000, "Pa")).toEqual({ text: "20", unit: "kPa" });
    expect(readable(0.001, "m/s")).toEqual({ text: "1", unit: "mm/s" });
    expect(readable(-15.424886149645642, "Hz")).toEqual({ text: "-15.4249", unit: "Hz" });
    expect(readable(1e-20, "N")).toEqual({ text: "1e-8", unit: "pN" });
  });

  it("leaves what has no unit, or none with prefixes, as it is", () => {
    expect(readable(0.5680641124785997)).toEqual({ text: "0.568064", unit: "1" });
    expect(readable(22.722564499143985, "1/s")).toEqual({ text: "22.7226", unit: "1/s" });
    expect(readable(0, "m")).toEqual({ text: "0", unit: "m" });
    expect(readable(Number.NaN, "m")).toEqual({ text: "NaN", unit: "m" });
  });

  it("shows as many digits as stand", () => {
    expect([rounded(1e-6), rounded(-4.273272828e-5), rounded(0.001), rounded(0)]).toEqual(["1e-6", "-4.27327e-5", "0.001", "0"]);
    expect(rounded(2.34238255213093e-7)).toBe("2.34238e-7");
  });

  it("writes a quantity as a person does, where that is the same, and nothing else", () => {
    expect(["1e-6 m/s", "1e0 m/s", "1e3 Pa", "1e6 Pa", "20000 Pa", "0.03 m/s"].map(asWritten)).toEqual(["1 µm/s", "1 m/s", "1 kPa", "1 MPa", "20 kPa", "30 mm/s"]);
    // with more digits than are shown, with a unit of its own, without one, and no quantity at all
    for (const text of ["1.23456789 Pa", "30 mm/s", "40 rad/s", "1e-6", "0.01", "fast", ""]) expect(asWritten(text)).toBe(text);
  });

  it("shows the other form of a value with its symbol set, in few digits", () => {
    const load = { path: "operation.normal_load", symbol: "F_n", group: "F_n/(E0* R²)", unit: "N" } as Key;
    const value = { path: load.path, si: 1e-3, group: 6.7407e-6 };
    expect(otherForm(load, { ...value, form: "si", number: 1e-3 })).toBe("$F_{n}/(E_{0}* R²)$ = 6.741e-6");
    expect(otherForm(load, { ...value, form: "group", number: 6.7407e-6 })).toBe("1 mN");
    expect(otherForm({ ...load, group: null, unit: "1" }, { path: "", form: "group", number: 0.01, si: null, group: 0.01 })).toBe("");
  });

  it("knows what a prefix is", () => {
    expect([power("MPa", "Pa"), power("mm", "m"), power("mm²", "m²"), power("Pa", "Pa")]).toEqual([1e6, 1e-3, 1e-6, 1]);
  });
});

describe("a symbol without markup", () => {
  it("has lowered letters where there are such, and is left out elsewhere", () => {
    expect(["E0", "F_n", "ω_nx", "τ_r", "E∞", "η"].map(symbolText)).toEqual(["E₀", "Fₙ", "ωₙₓ", "τᵣ", "E∞", "η"]);
    expect(["v_d", "ξ_y"].map(symbolText)).toEqual(["", ""]);
  });
});
