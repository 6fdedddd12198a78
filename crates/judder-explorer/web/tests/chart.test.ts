import { describe, expect, it } from "vitest";
import { onPaper } from "../src/chart/axes";
import { chartCsv } from "../src/chart/csv";
import { decimate, visible } from "../src/chart/decimate";
import { draw } from "../src/chart/draw";
import { chartSvg } from "../src/chart/export";
import { homeWindow } from "../src/chart/frame";
import { drawLegend, legendEntries } from "../src/chart/legend";
import { classOf, colourAt, hex, lineStyle, rgb } from "../src/chart/palette";
import { cellsOf, letterPlaces, pixelsOf, valueRange } from "../src/chart/raster";
import { plainText, widthOf } from "../src/chart/markup";
import { readings } from "../src/chart/readout";
import type { Window } from "../src/chart/scale";
import { type Shape, markupOf } from "../src/chart/scene";
import { SMALL_SIZE, label } from "../src/chart/text";
import type { ChartSpec, ClassesLayer, Layer, ValuesLayer } from "../src/chart/spec";

const axis = (label: string, scale: "log" | "linear" = "linear") => ({ label, scale });
const count = 20_000;
const ramp = Float64Array.from({ length: count }, (_, i) => i / 25);

describe("decimation", () => {
  it("keeps every extreme of every pixel column", () => {
    const y = Float64Array.from(ramp, (_, i) => Math.sin(i / 7) + (i === 12_345 ? 1e3 : 0));
    const kept = decimate(ramp, y, 800);
    expect(kept.x.length).toBeLessThanOrEqual(4 * 801);
    const extremes = (x: Float64Array, y: Float64Array) => {
      const found = new Map<number, [number, number]>();
      x.forEach((value, i) => {
        const [low, high] = found.get(Math.floor(value)) ?? [Infinity, -Infinity];
        found.set(Math.floor(value), [Math.min(low, y[i] as number), Math.max(high, y[i] as number)]);
      });
      return found;
    };
    expect(extremes(kept.x, kept.y)).toEqual(extremes(ramp, y));
  });

  it("keeps gaps, closed curves and short lines", () => {
    const y = Float64Array.from(ramp, (_, i) => (i > 9_000 && i < 11_000 ? Number.NaN : i));
    expect(decimate(ramp, y, 800).y.filter(Number.isNaN).length).toBe(1);
    const circle = (turn: (angle: number) => number) => Float64Array.from(ramp, (_, i) => 100 * turn(i / 500));
    const closed = decimate(circle(Math.cos), circle(Math.sin), 300);
    expect(closed.x.length).toBeGreaterThan(500);
    expect(closed.x.at(-1)).toBe(100 * Math.cos((count - 1) / 500));
    expect(decimate([1, 2], [3, Number.NaN], 1).x.length).toBe(2);
    expect(decimate([], [], 0).x.length).toBe(0);
  });

  it("leaves out points that others hide, and none of a few", () => {
    const x = Array.from({ length: 3000 }, (_, i) => Math.floor(i / 10));
    const y = Array.from({ length: 3000 }, (_, i) => (i % 2 === 0 ? 7 : 100));
    expect(visible(x, y)).toHaveLength(300);
    expect(visible(x, y).slice(0, 3)).toEqual([0, 1, 20]);
    expect(visible([1, 1], [2, 2])).toEqual([0, 1]);
    expect(visible(x, x.map(() => Number.NaN))).toHaveLength(0);
  });
});

const MECHANISMS = ["stable", "flutter", "negative-damping", "both", "normal-force-coupling", "marginal", "unresolved"];

const map: ClassesLayer = {
  kind: "classes",
  label: "mechanism",
  x: [1e-2, 1e-1, 1],
  y: [0, 1],
  codes: Uint8Array.from([0, 1, 2, 3, 4, 6]),
  classes: MECHANISMS.map(classOf),
};
const scales = { x: "log", y: "linear" } as const;

describe("maps", () => {
  it("show in every pixel the nearest cell on the axis' own measure", () => {
    expect([...cellsOf([1e-2, 1e-1, 1], "log", [1e-2, 1], 4)]).toEqual([0, 1, 1, 2]);
    expect([...cellsOf([0, 1], "linear", [-1, 2], 6)]).toEqual([-1, 0, 0, 1, 1, -1]);
    expect([...cellsOf([], "linear", [0, 1], 2)]).toEqual([-1, -1]);
    expect([...cellsOf([5], "linear", [4, 6], 1)]).toEqual([0]);
  });

  it("have their first row at the bottom, and nothing outside of the data", () => {
    const pixels = pixelsOf(map, scales, { x: [1e-2, 1], y: [0, 1] }, 3, 2);
    const at = (column: number, row: number) => hex([...pixels.slice(4 * (row * 3 + column), 4 * (row * 3 + column) + 3)] as never);
    expect([at(0, 1), at(1, 1), at(2, 1), at(0, 0), at(1, 0)]).toEqual(MECHANISMS.slice(0, 5).map((word) => classOf(word).colour));
    const beyond = pixelsOf(map, scales, { x: [1e3, 1e4], y: [0, 1] }, 2, 2);
    expect([...beyond].every((channel) => channel === 0)).toBe(true);
    expect(pixelsOf(map, scales, { x: [1e-2, 1], y: [0, 1] }, 1, 1).length).toBe(4);
  });

  it("can be read without colour", () => {
    const window = { x: [1e-2, 1], y: [0, 1] } as const;
    const flutter = { ...map, codes: new Uint8Array(6).fill(1), hatched: true };
    const pixels = new Uint32Array(pixelsOf(flutter, scales, window, 60, 60).buffer);
    expect(new Set(pixels).size).toBe(2);
    const [place] = letterPlaces(flutter, scales, window);
    expect(place?.code).toBe(1);
    expect(Math.abs((place?.y ?? 0) - 0.5)).toBeLessThan(0.05);
  });

  it("of values leave NaN out, and are symmetric where colours diverge", () => {
    const values: ValuesLayer = { kind: "values", label: "E", x: [0, 1], y: [0], values: [Number.NaN, -3], colours: "diverging", scale: "linear" };
    expect(valueRange({ ...values, values: [1, -3] })).toEqual([-3, 3]);
    const pixels = pixelsOf({ ...values, range: [-3, 3] }, { x: "linear", y: "linear" }, { x: [0, 1], y: [0, 0.1] }, 2, 1);
    expect([...pixels]).toEqual([0, 0, 0, 0, ...colourAt("diverging", 0), 255]);
  });
});

describe("colours", () => {
  /** CIE lightness L* of an sRGB colour. */
  const lightness = (colour: string) => {
    const linear = rgb(colour).map((c) => (c / 255 <= 0.04045 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4));
    return 116 * Math.cbrt(0.2126 * (linear[0] ?? 0) + 0.7152 * (linear[1] ?? 0) + 0.0722 * (linear[2] ?? 0)) - 16;
  };

  it("of areas are apart in grey", () => {
    const order = ["stable", "normal-force-coupling", "negative-damping", "destabilised-by-damping", "flutter", "both"].map((word) => lightness(classOf(word).colour));
    const states = [100, ...["lift-off", "stick", "slip ahead"].map((word) => lightness(classOf(word).colour))];
    for (const list of [order, states]) list.slice(1).forEach((next, i) => expect((list[i] as number) - next).toBeGreaterThan(7));
  });

  it("of lines are never invisible", () => {
    for (let series = 0; series < 7; series += 1) {
      expect(lightness(lineStyle({ series }, "light").colour)).toBeLessThan(75);
      expect(lightness(lineStyle({ series }, "dark").colour)).toBeGreaterThan(55);
    }
  });
});

const curves: ChartSpec = {
  title: "Motion <of> a “point” & more",
  x: axis("Time $t$ (s)"),
  y: axis("Velocity $v$ (m/s)"),
  layers: [
    { kind: "line", label: "speed, x", x: [0, 0.1, 0.2], y: [1e-7, Number.NaN, 0.1 + 0.2], role: { series: 0 } },
    { kind: "line", label: "y", x: [0, 0.1, 0.2], y: [1, 2, 3], role: { series: 1 }, marked: true },
  ],
};

describe("exports", () => {
  it("of curves over the same values are a column each, with units and all digits", () => {
    expect(chartCsv(curves)).toBe(
      'Time t (s),"speed, x (m/s)",y (m/s)\n0,1e-7,1\n0.1,,2\n0.2,0.30000000000000004,3\n',
    );
  });

  it("are no formulas", () => {
    const named = { ...curves, layers: curves.layers.map((layer) => ({ ...layer, name: "=1+1" })) };
    expect(chartCsv(named).split("\n")[0]).toContain("'=1+1");
    const row = chartCsv({ ...curves, layers: [map, { kind: "rule", label: "@now", across: "x", at: -0.5, role: "reference" }] });
    expect(row.trimEnd().split("\n").at(-1)).toBe("'@now,-0.5,,");
  });

  it("of anything else are one row a point", () => {
    const spec: ChartSpec = { ...curves, layers: [map, { kind: "rule", label: "now", across: "x", at: 0.5, role: "reference" }] };
    const lines = chartCsv(spec).trimEnd().split("\n");
    expect(lines[0]).toBe("layer,Time t (s),Velocity v (m/s),class");
    expect(lines).toHaveLength(1 + 6 + 1);
    expect(lines[3]).toBe("mechanism,1,0,negative damping");
    expect(lines[7]).toBe("now,0.5,,");
  });

  it("have a column for ends, and none for classes without a map", () => {
    const bands = { kind: "bands", label: "stick", from: [1, 4], to: [2, 5], style: classOf("flutter") } as const;
    expect(chartCsv({ ...curves, layers: [bands] })).toBe("layer,Time t (s),Velocity v (m/s),end\nstick,1,,2\nstick,4,,5\n");
    expect(chartCsv({ ...curves, layers: [{ ...bands, across: "y" }] })).toContain("stick,,4,5\n");
  });

  it("leave out what only helps the eye, and name each line with the key along it", () => {
    const line = { kind: "line", x: [1, 2], y: [3, 4], role: { series: 0 } } as const;
    const far = { kind: "bands", label: "stable", from: [-1e200], to: [0], style: classOf("stable"), scenery: true } as const;
    const axisRule = { kind: "rule", label: "", across: "y", at: 0, role: "reference" } as const;
    const along = { name: "load (N)", values: [10, 20] };
    const layers = [far, axisRule, { ...line, label: "path", name: "line 1", along }, { ...line, x: [5, 6], label: "", name: "line 2", along }];
    expect(chartCsv({ ...curves, layers })).toBe("layer,load (N),Time t (s),Velocity v (m/s)\nline 1,10,1,3\nline 1,20,2,4\nline 2,10,5,3\nline 2,20,6,4\n");
    expect(chartCsv({ ...curves, layers: [axisRule, ...curves.layers] })).toBe(chartCsv(curves));
  });

  it("are SVG that stands alone", async () => {
    const spec: ChartSpec = { ...curves, layers: [{ ...map, letters: true, hatched: true }, ...curves.layers] };
    const encode = async (pixels: Uint8ClampedArray, width: number, height: number) => {
      expect(pixels.length).toBe(4 * width * height);
      return "data:image/png;base64,AAAA";
    };
    const svg = await chartSvg(spec, homeWindow(spec), { width: 600, height: 400 }, encode);
    expect(svg).toContain('href="data:image/png;base64,AAAA"');
    expect(svg).toContain("<title>Motion &lt;of&gt; a “point” &amp; more</title>");
    expect(svg).not.toMatch(/NaN|Infinity|undefined|\sstyle=|<script/);
    const opened = (svg.match(/<[a-zA-Z][^>]*[^/]>/g) ?? []).length;
    expect(opened).toBe((svg.match(/<\/[a-zA-Z]+>/g) ?? []).length);
  });

  it("are made of charts of one pixel and of nothing", async () => {
    const empty: ChartSpec = { title: "", x: axis("x", "log"), y: axis("y"), layers: [{ kind: "line", label: "", x: [], y: [], role: "reference" }] };
    for (const size of [{ width: 1, height: 1 }, { width: 30, height: 2000 }]) {
      for (const spec of [curves, empty, { ...curves, layers: [] }, { ...curves, equal: true }]) {
        const svg = await chartSvg(spec, homeWindow(spec), size, async () => "");
        expect(svg).not.toMatch(/NaN|Infinity|undefined/);
      }
    }
    expect(chartCsv(empty)).toBe("x,y\n");
  });

  it("of twenty thousand points are small", async () => {
    const long: ChartSpec = { ...curves, layers: [{ kind: "line", label: "", x: ramp, y: ramp.map((t) => Math.sin(t)), role: { series: 0 } }] };
    const svg = await chartSvg(long, homeWindow(long), { width: 800, height: 400 });
    expect(svg.length).toBeLessThan(80_000);
  });
});

describe("a plot", () => {
  const size = { width: 900, height: 420 };
  const outlines = (shapes: readonly Shape[]) => shapes.filter(({ tag }) => tag === "path").map(({ attributes }) => String(attributes["d"]));

  it("shows markers at the ends of its axes whole, and none of what lies beyond", () => {
    const ends = { label: "ends", x: [0, 0, 1, 1, 0.5], y: [0, 1, 0, 1, 0.5], role: { series: 0 } } as const;
    const layers: readonly Layer[] = [{ kind: "points", ...ends }, { kind: "line", ...ends, marked: true }];
    for (const layer of layers) {
      const beyond = { ...layer, x: [...ends.x, 1.001, -0.001], y: [...ends.y, 0.5, 0.5] } as Layer;
      const spec: ChartSpec = { title: "", x: { ...axis("x"), range: [0, 1] }, y: { ...axis("y"), range: [0, 1] }, layers: [beyond] };
      const { frame, over } = draw(spec, homeWindow(spec), size, "light", "p");
      // what is clipped by the plot lies in a group
      const circles = outlines(over).map((path) => [...path.matchAll(/M([\d.]+)[ ,]/g)].map((found) => Number(found[1])));
      const drawn = circles.find((starts) => starts.length > 1) ?? [];
      // an outline of a circle begins at its right-hand end
      const radius = (drawn.at(-1) ?? 0) - frame.left - frame.width / 2;
      expect(drawn.map((x) => Math.round(x - radius - frame.left)), layer.kind).toEqual(ends.x.map((x) => Math.round(x * frame.width)));
    }
  });

  const matrix = (side: number): ChartSpec => {
    const at = Float64Array.from({ length: side }, (_, i) => i + 1);
    const layer: ValuesLayer = { kind: "values", label: "MAC", x: at, y: at, values: new Float64Array(side * side), colours: "sequential", scale: "linear" };
    return { title: "", x: axis("mode"), y: axis("mode"), equal: true, layers: [layer] };
  };

  it("of a map of equal units has the shape of the map: no numbers of cells that are none", () => {
    for (const wide of [size, { width: 300, height: 700 }]) {
      const spec = matrix(11);
      const { frame } = draw(spec, homeWindow(spec), wide, "light", "p");
      expect(frame.window).toEqual(homeWindow(spec));
      for (const tick of [...frame.xTicks.major, ...frame.yTicks.major]) expect(Math.abs(tick.value - 6)).toBeLessThanOrEqual(5);
      expect(frame.width).toBeCloseTo(frame.height, 6);
    }
  });

  it("of a narrow strip of a map is no line: it shows more of the ground, in equal units", () => {
    const spec = matrix(11);
    const { frame } = draw(spec, { x: [1, 11], y: [5, 5.1] }, size, "light", "p");
    expect(frame.height).toBeGreaterThan(80);
    const unit = [frame.width / (frame.window.x[1] - frame.window.x[0]), frame.height / (frame.window.y[1] - frame.window.y[0])];
    expect(unit[0]).toBeCloseTo(unit[1] ?? 0, 6);
  });
});

describe("the legend", () => {
  const role = "full-boundary";
  const boundary = { kind: "line", label: "boundary", x: [1e-2, 1], y: [0, 1], role } as const;
  const now = { kind: "rule", label: "now", across: "x", at: 0.5, role: "decoupled-boundary" } as const;
  const point = { kind: "points", label: "here", x: [0.5], y: [0.5], role: { series: 1 } } as const;
  const dark = (layers: ChartSpec["layers"]) => {
    const spec: ChartSpec = { ...curves, layers };
    const entries = legendEntries(spec, "dark");
    return { entries, shapes: drawLegend(entries, 600, "dark", "c") };
  };

  it("shows lines over a map as they are drawn there, on a light ground", () => {
    const { entries, shapes } = dark([map, boundary, now, point]);
    const lines = entries.slice(-3);
    expect(lines.map(({ line }) => line)).toEqual([lineStyle(role, "light"), lineStyle(now.role, "light"), lineStyle(point.role, "light")]);
    expect(shapes.filter(({ tag, attributes }) => tag === "rect" && attributes["fill"] === "#ffffff")).toHaveLength(3);
  });

  it("shows lines over the page's own ground in the theme's colours", () => {
    const { entries, shapes } = dark([boundary, now, point]);
    expect(entries.map(({ line }) => line?.colour)).toEqual([boundary, now, point].map(({ role }) => lineStyle(role, "dark").colour));
    expect(shapes.filter(({ tag }) => tag === "rect")).toEqual([]);
  });
});

describe("axis labels", () => {
  it("stay on the paper", () => {
    const long = "How far the true eigenvalue may be (1/s)";
    expect(onPaper("Mode", 94, 250)).toBe(94);
    expect(onPaper(long, 94, 300)).toBeGreaterThan(94);
    expect(onPaper(long, 280, 300)).toBeLessThan(200);
    expect(onPaper(long, 94, 100)).toBe(50);
  });
});

describe("labels of any length", () => {
  it("are drawn in part and told whole, and read in no time", () => {
    for (const part of ["word ", "_{", "$", "_{a}", "$x$"]) {
      const text = part.repeat(100_000 / part.length);
      const start = performance.now();
      const long = { ...axis(text), label: text };
      const spec: ChartSpec = { title: "", x: long, y: long, layers: [{ kind: "line", label: text, x: [0, 1], y: [0, 1], role: { series: 0 } }] };
      const { over, under } = draw(spec, homeWindow(spec), { width: 600, height: 400 }, "light", "p");
      plainText(text);
      expect(performance.now() - start, part).toBeLessThan(1000);
      const svg = [...under, ...over].map(markupOf).join("");
      expect(svg.length, part).toBeLessThan(100_000);
    }
    const long = markupOf(label(`$τ$ ${"a".repeat(500)}`, { x: 0, y: 0, size: 12, colour: "#000" }));
    expect(long).toContain(`${"a".repeat(196)}…</tspan>`);
    expect(long).toContain(`<title>τ ${"a".repeat(500)}</title>`);
    expect(markupOf(label("short", { x: 0, y: 0, size: 12, colour: "#000" }))).not.toContain("title");
  });
});

describe("tick labels", () => {
  /** Texts below the plot, with the pixels that they take. */
  const below = (window: Window, size: { width: number; height: number }) => {
    const { frame, over } = draw(curves, window, size, "light", "c");
    const bottom = frame.top + frame.height + 18;
    const texts = over.filter(({ tag, attributes }) => tag === "text" && Math.abs(Number(attributes["y"]) - bottom) < 1);
    return texts.map(({ attributes, children }) => {
      const half = (widthOf(children.map((span) => (span as Shape).children.join("")).join("")) * SMALL_SIZE) / 2;
      return { from: Number(attributes["x"]) - half, to: Number(attributes["x"]) + half };
    });
  };

  it("of a deep zoom stay on the paper, and apart", () => {
    for (const depth of [1, 1e-3, 1e-6, 1e-8, 1e-11]) {
      for (const width of [300, 620, 1100]) {
        const places = below({ x: [1 - depth, 1], y: [0, 3] }, { width, height: 400 });
        expect(places.length, `${depth} ${width}`).toBeGreaterThan(0);
        places.forEach(({ from, to }, i) => {
          expect(from).toBeGreaterThan(i === 0 ? 0 : (places[i - 1]?.to ?? 0));
          expect(to).toBeLessThanOrEqual(width);
        });
      }
    }
  });

  it("of a colour bar leave out the power of ten that its title names, as those of axes do", () => {
    const values: ValuesLayer = { kind: "values", label: "Residual (−)", x: [0, 1], y: [0, 1], values: [0, 1e-3, 2e-3, 4e-3], colours: "sequential", scale: "linear" };
    const spec: ChartSpec = { ...curves, layers: [values] };
    const { over } = draw(spec, homeWindow(spec), { width: 600, height: 400 }, "light", "c");
    const text = (shape: Shape): string => shape.children.map((child) => (typeof child === "string" ? child : text(child))).join("");
    expect(over.filter(({ tag }) => tag === "text").map(text)).toContain("Residual (10−3)");
  });
});

describe("the cursor", () => {
  const at = (spec: ChartSpec, x: number, y: number) => readings(spec, { x, y }).map(({ label, value }) => `${label}: ${value}`);

  it("reads the nearest point of every curve, and says where that is", () => {
    expect(at(curves, 0.11, 5)).toEqual(["Time $t$ (s): 0.11", "Velocity $v$ (m/s): 5", "values at: 0.1", "speed, x: —", "y: 2"]);
    const [first] = curves.layers;
    const other = { kind: "line", label: "z", x: [0, 0.12], y: [7, 8], role: { series: 2 } } as const;
    expect(at({ ...curves, layers: [first as Layer, other] }, 0.19, 5).slice(2)).toEqual(["speed, x: 0.3 at 0.2", "z: 8 at 0.12"]);
  });

  it("reads the nearest node of a map in the measure of its axes", () => {
    const values: ValuesLayer = { kind: "values", label: "E", x: [1, 100], y: [1, 2], values: [1, 2, 3, 4], colours: "sequential", scale: "linear" };
    const spec: ChartSpec = { title: "", x: axis("x", "log"), y: axis("y"), layers: [values] };
    expect(at(spec, 20, 1.2)).toEqual(["x: 20", "y: 1.2", "values at: 100, 1", "E: 2"]);
    expect(at({ ...spec, x: axis("x") }, 20, 1.2).slice(2)).toEqual(["values at: 1, 1", "E: 1"]);
    expect(at({ ...spec, layers: [{ ...values, x: [] }] }, 20, 1.2)).toHaveLength(2);
  });
});
