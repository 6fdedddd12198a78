import { describe, expect, it } from "vitest";
import { blamedKey, blames, meant } from "../src/ui/meant";
import { RequestError } from "../src/wire/request";

const TEXT = 'model = "oscillator"\nvelocity = "3 K"\n';
const error = (message: string, source: string, line: number, column: number, text: string) =>
  new RequestError(message, 422, { source, line, column, text }, null);

describe("the place of an error", () => {
  it("is a line only where the user's own text has it", () => {
    const own = error("`velocity` must be a speed", "case.toml", 2, 12, '"3 K"');
    expect(meant(own, TEXT)).toMatchObject({ source: "case.toml", line: 2 });
    expect(meant(own, null)).toMatchObject({ line: 2 });
  });

  it("is the field or key where it lies in a composed text", () => {
    expect(meant(error("`y.from` must be a stress", "case.toml", 40, 46, '"1 N"'), TEXT)).toEqual({ field: "From, y axis", text: '"1 N"' });
    expect(meant(error("`duration` must be a time", "case.toml", 2, 12, '"5 kg"'), TEXT)).toEqual({ field: "duration", text: '"5 kg"' });
    expect(meant(error("something is wrong", "case.toml", 40, 1, "x"), TEXT)).toBeNull();
  });

  it("is not said of an option, which stands in its own field", () => {
    expect(meant(error("`indenter.radius` must be a length", "--set", 1, 17, "3 N"), TEXT)).toBeNull();
  });
});

describe("the control that was refused", () => {
  const keys = ["substrate.rubbery_modulus", "substrate.glassy_modulus", "indenter.radius"];

  it("is the one whose key is named, or at whose text the error points", () => {
    expect(blamedKey(error("`indenter.radius` must be a length", "--set", 1, 17, "3 N"), keys, { "indenter.radius": "3 N" })).toBe("indenter.radius");
    const below = error("the glassy modulus 1e3 Pa is not above the rubbery modulus 1e6 Pa", "--set", 1, 26, "1 kPa");
    expect(blamedKey(below, keys, { "indenter.radius": "1 kPa", "substrate.glassy_modulus": "1 kPa" })).toBe("substrate.glassy_modulus");
    expect(blamedKey(below, keys, {})).toBeUndefined();
  });

  it("is a field of the page by its name in the analysis, and none where the server is only gone", () => {
    const from = error("`x.from` must be a speed", "case.toml", 40, 46, '"3 N"');
    expect([blames(from, "x.from"), blames(from, "y.from"), blames(null, "x.from")]).toEqual([true, false, false]);
    expect(blames(new RequestError("`x.from` is late", 503, null, null), "x.from")).toBe(false);
  });
});
