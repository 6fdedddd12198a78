import { describe, expect, it } from "vitest";
import { meant } from "../src/ui/meant";
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
