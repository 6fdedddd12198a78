// @vitest-environment happy-dom
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { render } from "preact";
import { act } from "preact/test-utils";
import { beforeAll, describe, expect, it } from "vitest";
import { draw } from "../src/chart/draw";
import { homeWindow } from "../src/chart/frame";
import { found } from "../src/chart/nearest";
import { MEANINGS } from "../src/chart/meanings";
import { pixelsOf } from "../src/chart/raster";
import { type Shape, markupOf } from "../src/chart/scene";
import type { ChartSpec, ClassesLayer, LineLayer, PointsLayer, ValuesLayer } from "../src/chart/spec";
import { type Figure, described } from "../src/report/described";
import { FigureView } from "../src/report/FigureView";
import { specOf, swings } from "../src/report/specs";

/** A figure with layers of every kind, as the tests of `judder-report` describe it. */
let figure: Figure;
let specs: readonly ChartSpec[];
const STILL = { phase: 0, hidden: new Set<string>() };

beforeAll(async () => {
  figure = await described(readFileSync(join(import.meta.dirname, "figure.json"), "utf8"));
  specs = figure.panels.map((panel) => specOf(figure, panel, STILL));
});

const layerOf = <T,>(panel: number, kind: string) => specs[panel]?.layers.find((layer) => layer.kind === kind) as T;
const SIZE = { width: 600, height: 400 };
const drawn = (spec: ChartSpec) => draw(spec, homeWindow(spec), SIZE, "light", "p");
const textOf = (shapes: readonly (Shape | string)[]): string => shapes.map((one) => (typeof one === "string" ? one : `${textOf(one.children)}|`)).join("");

describe("a described figure", () => {
  it("has its arrays, in single precision or in digits, and its gaps", () => {
    const mode = layerOf<LineLayer>(3, "line");
    expect(mode.x).toHaveLength(40);
    expect(mode.x[39]).toBeCloseTo(3.9, 6);
    expect(mode.y[39]).toBeCloseTo(Math.sin(3.9), 6);
    expect(layerOf<LineLayer>(2, "line").x[2]).toBeNaN();
    expect(Array.from(layerOf<ClassesLayer>(0, "classes").codes)).toEqual([0, 1, 2, 2, 1, 0]);
    expect(layerOf<ValuesLayer>(1, "values").values[3]).toBeNaN();
  });

  it("is shown over its ranges on its scales", () => {
    expect(specs[2]?.y.scale).toEqual({ "symmetric-log": { linear: 0.1 } });
    expect(homeWindow(specs[2] as ChartSpec).y).toEqual(figure.panels[2]?.y.range);
    expect(specs[0]?.x.scale).toBe("log");
  });

  it("has the colours, dashes, markers and widths of its drawing", () => {
    const all = drawn(specs[2] as ChartSpec).over.map(markupOf).join("");
    expect(all).toMatch(new RegExp(`stroke="${MEANINGS.series.colours[1]}" stroke-width="[\\d.]+" stroke-dasharray="[\\d. ]+"`));
    expect(layerOf<LineLayer>(2, "line").width).toBeCloseTo((4 / 3) * MEANINGS.series.width, 12);
    expect(layerOf<PointsLayer>(2, "points").marker).toBe(MEANINGS.series.markers[4]);
  });

  it("is drawn with its region, notes, rules, second axis and names", () => {
    const { under, over } = drawn(specs[2] as ChartSpec);
    expect(markupOf(under[0] as Shape)).toContain(MEANINGS.areas.stable);
    const text = textOf(over);
    // the note and both rules
    expect(text.match(/τ̃\|0\|/g)?.length).toBeGreaterThanOrEqual(5);
    expect(text).toContain("20|");
    expect(textOf(drawn(specs[3] as ChartSpec).over)).toContain("velocity|");
  });

  it("hatches cells without an answer and without a value", () => {
    for (const kind of ["classes", "values"]) {
      const panel = kind === "classes" ? 0 : 1;
      const spec = specs[panel] as ChartSpec;
      const pixels = pixelsOf(layerOf<ClassesLayer>(panel, kind), { x: "log", y: "linear" }, homeWindow(spec), 90, 60);
      const colours = new Set<string>();
      for (let k = 0; k < pixels.length; k += 4) colours.add(Array.from(pixels.subarray(k, k + 3), (channel) => channel.toString(16)).join(""));
      expect(colours, kind).toContain("ffffff");
      expect(colours, kind).toContain("8c8c8c");
    }
  });

  it("draws markers in their sizes", () => {
    const { sizes } = layerOf<PointsLayer>(3, "points");
    expect(Array.from(sizes ?? [])).toEqual([1, 3]);
    const path = markupOf(drawn(specs[3] as ChartSpec).over.find((one) => one.tag === "path" && one.attributes["stroke-width"] === 0.8) as Shape);
    const radii = Array.from(path.matchAll(/A([\d.]+)/g), ([, radius]) => Number(radius));
    const squares = Array.from(path.matchAll(/h([\d.]+)/g), ([, side]) => Number(side));
    const extents = radii.length > 0 ? radii : squares;
    expect(Math.max(...extents) / Math.min(...extents)).toBeCloseTo(3, 1);
  });

  it("tells of the nearest point, and of a map's cell", () => {
    const spec = specs[2] as ChartSpec;
    const { frame } = drawn(spec);
    const near = found(spec, frame, { x: 2.01, y: 0.5 });
    expect(near.at).toEqual({ x: 2, y: 0.5 });
    expect(near.readings.map(({ value }) => value)).toEqual(["$τ̃_{0}$ (N)", "2", "0.5"]);
    const map = specs[0] as ChartSpec;
    expect(found(map, drawn(map).frame, { x: 11, y: 0.1 }).readings[0]?.value).toBe("flutter");
    const keys = specs[3] as ChartSpec;
    expect(found(keys, drawn(keys).frame, { x: 1.01, y: 0.5 }).readings.map(({ value }) => value)).toContain("load");
  });

  it("moves what swings about its rest", () => {
    const panel = figure.panels[3] as Figure["panels"][number];
    expect([swings(panel), swings(figure.panels[2] as typeof panel)]).toEqual([true, false]);
    const at = (phase: number) => specOf(figure, panel, { phase, hidden: new Set() }).layers[0] as LineLayer;
    const [rest, a, b] = [Math.sin(0.5) - Math.sin(0.5), Math.sin(0.5), 0.5 * Math.sin(0.5)];
    for (const phase of [0.3, 1, 2.5, 6]) {
      expect(at(phase).y[5]).toBeCloseTo(rest + a * Math.cos(phase) - b * Math.sin(phase), 6);
      expect(at(phase).x[5]).toBeCloseTo(0.5, 6);
    }
  });
});

describe("a figure of a report", () => {
  const shown = async () => {
    const host = document.createElement("div");
    await act(() => render(<FigureView figure={figure} />, host));
    return host;
  };

  it("has a chart for each panel, and each label once in its legend", async () => {
    const host = await shown();
    expect(host.querySelectorAll(".chart")).toHaveLength(4);
    const labels = Array.from(host.querySelectorAll(".figure-legend li"), (entry) => entry.textContent);
    expect(labels).toContain("flutter");
    expect(new Set(labels).size).toBe(labels.length);
  });

  it("hides and shows what its legend is asked to", async () => {
    const host = await shown();
    const button = Array.from(host.querySelectorAll<HTMLButtonElement>("button.legend-entry")).find((one) => one.textContent?.includes("bubbles"));
    const markers = () => host.querySelectorAll(".panel")[3]?.querySelectorAll(`.chart-over path[stroke-width="0.8"]`).length;
    expect(markers()).toBe(1);
    await act(() => button?.click());
    expect([markers(), button?.getAttribute("aria-pressed")]).toEqual([0, "false"]);
    await act(() => button?.click());
    expect(markers()).toBe(1);
  });

  it("can be set swinging", async () => {
    const host = await shown();
    const button = host.querySelector<HTMLButtonElement>(".figure-play button");
    await act(() => button?.click());
    expect([button?.textContent, button?.getAttribute("aria-pressed")]).toEqual(["Stop", "true"]);
    await act(() => button?.click());
    expect(button?.textContent).toBe("Swing");
  });
});
