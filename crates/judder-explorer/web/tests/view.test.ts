import { describe, expect, it } from "vitest";
import { keepKnownAxes } from "../src/state/axes";
import { numberOrText, parseAxis, parsePair, parseWords, writeAxis } from "../src/state/fields";
import { type View, keepKnownKeys, options, parseView, withFields, withOption, writeView } from "../src/state/view";
import { PAGE_FIELDS } from "./declared";

const parse = (address: string) => {
  const url = new URL(address, "http://localhost");
  return parseView(url.pathname, url.search, PAGE_FIELDS);
};

describe("addresses", () => {
  it("come back as they were written", () => {
    const view: View = {
      page: "map",
      set: { "operation.velocity": "30 mm/s", "contact.law": "bem", "masses[left arm].mass": "1 & 2 = 50 % + #ü" },
      fields: { x: "operation.velocity~1e-8~1 µm/s~log", cursor: "1e-7,0.25", show: "" },
    };
    const address = writeView(view);
    expect(parse(address)).toEqual({ view, told: [] });
    expect(writeView(parse(address).view)).toBe(address);
    expect(writeView({ page: "point", set: { "operation.velocity": "1e-3" }, fields: {} })).toBe("/point?set=operation.velocity=1e-3");
  });

  it("lose their bad parts, which are told", () => {
    const { view, told } = parse("/map?set=operation.velocity&set==1&set=a..b=1&set=ok.key=2&x=1&cursor=1,NaN&fish=1&show=full,fish");
    expect(view).toEqual({ page: "map", set: { "ok.key": "2" }, fields: {} });
    expect(told).toHaveLength(7);
    expect(told.join()).toContain("fish");
  });

  it("of no page are those of the first one", () => {
    expect(parseView("/", "", PAGE_FIELDS, "contact")).toEqual({ view: { page: "contact", set: {}, fields: {} }, told: [] });
    expect(parse("/constructor?__proto__=1&toString=2")).toMatchObject({ view: { page: "map", set: {}, fields: {} } });
    expect(parse("/constructor").told).toEqual(["There is no page “constructor”."]);
  });

  it("keep the last of options that are given twice", () => {
    expect(options(parse("/point?set=a.b=1&set=a.b=2").view)).toEqual(["a.b=2"]);
  });

  it("drop keys that the case does not have", () => {
    const { view, told } = keepKnownKeys(parse("/map?set=a.b=1&set=c.d=2").view, new Set(["c.d"]));
    expect(options(view)).toEqual(["c.d=2"]);
    expect(told).toEqual(["The case has no key “a.b”."]);
  });

  it("drop axes of a map that cannot be, and say so", () => {
    const x = "operation.velocity~1~2~log";
    expect(parse("/map?x=operation.velocity~2~1~log&y=operation.normal_load~2 N~1 N~log").told).toHaveLength(2);
    expect(parse("/map?x=operation.velocity~2 m~1 km~log").told).toEqual([]);
    const keys = { keys: new Set(["operation.velocity", "operation.normal_load"]), x: "operation.velocity" };
    for (const address of [`/map?x=${x}&y=${x}`, `/map?y=${x}`]) {
      const { view, told } = keepKnownAxes(parse(address).view, keys);
      expect(view.fields["y"]).toBeUndefined();
      expect(told.join()).toContain("both axes");
    }
    expect(keepKnownAxes(parse("/map?x=a.b~1~2~log").view, keys).told).toEqual(["The case has no key “a.b” for its x axis."]);
    expect(keepKnownAxes(parse(`/map?x=${x}&y=operation.normal_load~1~2~log`).view, keys).told).toEqual([]);
  });

  it("drop keys along which the point page has nothing to show, and say so", () => {
    const keys = { keys: new Set(["operation.velocity"]), x: undefined };
    const { view, told } = keepKnownAxes(parse("/point?along=foo&branch=a.b~1~2~log&volume=1").view, keys);
    expect(view.fields).toEqual({ volume: "1" });
    expect(told).toEqual(["The case has no key “foo” for the path of the eigenvalues.", "The case has no key “a.b” for the branch."]);
    const good = parse("/point?along=operation.velocity&branch=operation.velocity~1~2~log").view;
    expect(keepKnownAxes(good, keys)).toEqual({ view: good, told: [] });
  });

  it("change without changing the view before", () => {
    const before = parse("/map?set=a.b=1&cursor=1,2").view;
    expect(withOption(before, "a.b", undefined).set).toEqual({});
    expect(withFields(before, { cursor: undefined, show: "full" }).fields).toEqual({ show: "full" });
    expect(before).toMatchObject({ set: { "a.b": "1" }, fields: { cursor: "1,2" } });
  });
});

describe("fields", () => {
  it("read pairs of finite numbers only", () => {
    expect(parsePair("1e-3,-2")).toEqual([1e-3, -2]);
    for (const text of [undefined, "", "1", "1,", "1,2,3", "1,Infinity", "a,b"]) expect(parsePair(text)).toBeUndefined();
  });

  it("read axes with numbers and with units", () => {
    const axis = { key: "operation.velocity", from: "1 µm/s", to: 100, scale: "log" } as const;
    expect(parseAxis(writeAxis(axis))).toEqual(axis);
    for (const text of ["a~1~2", "a~1~2~cubic", "~1~2~log", "a~~2~log", "a~1~2~log~3"]) expect(parseAxis(text)).toBeUndefined();
    expect(numberOrText(" 1e-3 ")).toBe(1e-3);
    expect(numberOrText("Infinity")).toBe("Infinity");
  });

  it("read words of their list", () => {
    expect(parseWords("a,b,a", ["a", "b"])).toEqual(["a", "b"]);
    expect(parseWords("", ["a"])).toEqual([]);
    expect(parseWords("c", ["a"])).toBeUndefined();
  });
});
