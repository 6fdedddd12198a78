import { describe, expect, it } from "vitest";
import { symbolText } from "../src/ui/numbers";
import { power, readable, rounded } from "../src/ui/readable";

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
