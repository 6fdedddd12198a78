/** Layers of a chart as SVG. */

import { area as areaOf, line as lineOf } from "d3-shape";
import { decimate } from "./decimate";
import type { Frame } from "./frame";
import { widthOf } from "./markup";
import { markerPath, patternOver } from "./marks";
import { AREA_OPACITY, DASH_PATTERN, INK, type LineStyle, type Theme, lineStyle } from "./palette";
import { letterPlaces } from "./raster";
import type { Range } from "./scale";
import { type Shape, round, shape } from "./scene";
import type { AreaLayer, BandsLayer, ChartSpec, ClassesLayer, Layer, LineLayer, PointsLayer, RegionLayer, RuleLayer } from "./spec";
import { SMALL_SIZE, label } from "./text";

export interface Drawing {
  readonly spec: ChartSpec;
  readonly frame: Frame;
  readonly theme: Theme;
  /** Distinguishes the ids of this picture. */
  readonly prefix: string;
  /** Whether lines lie over coloured areas and need a light rim. */
  readonly overAreas: boolean;
}

export function drawLayer(layer: Layer, drawing: Drawing): Shape[] {
  switch (layer.kind) {
    case "line":
      return drawLine(layer, drawing);
    case "points":
      return drawPoints(layer, drawing);
    case "bands":
      return drawBands(layer, drawing);
    case "area":
      return drawArea(layer, drawing);
    case "rule":
      return drawRule(layer, drawing);
    case "region":
      return drawRegion(layer, drawing);
    case "note":
    case "classes":
    case "values":
      return [];
  }
}

/** Lines over coloured areas are those of the light theme: the areas are the same in both. */
function styleOf(layer: LineLayer | PointsLayer | RuleLayer, drawing: Drawing): LineStyle {
  const style = lineStyle(layer.role, drawing.overAreas ? "light" : drawing.theme);
  return layer.kind === "line" && layer.width ? { ...style, width: layer.width } : style;
}

function stroke(style: LineStyle, dash = style.dash): Shape["attributes"] {
  const dashes = DASH_PATTERN[dash].map((length) => round(length * style.width)).join(" ");
  return { stroke: style.colour, "stroke-width": style.width, ...(dashes ? { "stroke-dasharray": dashes } : {}), fill: "none", "stroke-linejoin": "round" };
}

function pixels(values: ArrayLike<number>, at: (value: number) => number): Float64Array {
  const found = new Float64Array(values.length);
  // far beyond the plot is as good as just beyond, and keeps paths short and renderers safe
  for (let i = 0; i < values.length; i += 1) found[i] = Math.min(Math.max(at(values[i] as number), -1e4), 1e5);
  return found;
}

function linePath(layer: LineLayer, { frame }: Drawing): string {
  const { x, y } = decimate(pixels(layer.x, frame.px), pixels(layer.y, frame.py), frame.width);
  const draw = lineOf<number>()
    .defined((i) => !Number.isNaN(x[i]) && !Number.isNaN(y[i]))
    .x((i) => x[i] as number)
    .y((i) => y[i] as number)
    .digits(2);
  return draw(Array.from(x.keys())) ?? "";
}

function drawLine(layer: LineLayer, drawing: Drawing): Shape[] {
  const path = linePath(layer, drawing);
  return path === "" ? [] : [shape("path", { d: path, ...stroke(styleOf(layer, drawing), layer.dash) })];
}

/** The light rim that lifts a line off coloured areas. */
export function drawRim(layer: Layer, drawing: Drawing): Shape[] {
  const path = drawing.overAreas && layer.kind === "line" ? linePath(layer, drawing) : "";
  if (path === "" || layer.kind !== "line") return [];
  const width = styleOf(layer, drawing).width + 2;
  return [shape("path", { d: path, stroke: INK.light.ground, "stroke-width": width, "stroke-opacity": 0.6, fill: "none" })];
}

/** Points within the plot, each whole; all of them are one path: thousands of elements would be slow. */
function drawPoints(layer: PointsLayer, drawing: Drawing): Shape[] {
  const { frame } = drawing;
  const style = styleOf(layer, drawing);
  const size = layer.size ?? 8;
  const outline = (diameter: number) => relative(markerPath(layer.marker ?? style.marker, diameter));
  const usual = outline(size);
  const marker = (i: number) => (layer.sizes ? outline(size * (layer.sizes[i] as number)) : usual);
  const parts: string[] = [];
  for (let i = 0; i < Math.min(layer.x.length, layer.y.length); i += 1) {
    const [x, y] = [frame.px(layer.x[i] as number), frame.py(layer.y[i] as number)];
    if (isOnPlot(frame, x, y)) parts.push(marker(i)(x, y));
  }
  if (parts.length === 0) return [];
  // rims would cut the lines on which points lie
  const isRimmed = !layer.crowded && (layer.sizes !== undefined || !drawing.spec.layers.some((other) => other.kind === "line"));
  const rim = INK[drawing.overAreas ? "light" : drawing.theme].ground;
  const paint = layer.hollow
    ? { fill: "none", stroke: style.colour, "stroke-width": 1.5 }
    : { fill: style.colour, ...(isRimmed ? { stroke: rim, "stroke-width": 0.8 } : {}) };
  return [shape("path", { d: parts.join(""), ...paint })];
}

/** Whether a place lies on the plot; ends of axes do, however they are rounded, be it to single precision. */
function isOnPlot({ left, top, width, height }: Frame, x: number, y: number): boolean {
  const [across, up] = [(x - left) / width, (y - top) / height];
  return across >= -1e-5 && across <= 1 + 1e-5 && up >= -1e-5 && up <= 1 + 1e-5;
}

/** A path about the origin, moved to a place; commands in small letters are relative and stay. */
function relative(path: string): (x: number, y: number) => string {
  const steps = path.match(/[A-Za-z][^A-Za-z]*/g) ?? [];
  return (x, y) =>
    steps
      .map((step) => {
        const [command, numbers] = [step.charAt(0), (step.slice(1).match(/-?[\d.]+(?:e-?\d+)?/g) ?? []).map(Number)];
        if (command === command.toLowerCase()) return step;
        if (command === "H") return `H${round((numbers[0] ?? 0) + x)}`;
        if (command === "V") return `V${round((numbers[0] ?? 0) + y)}`;
        // of an arc only the last pair is a place
        const fixed = command === "A" ? 5 : 0;
        const moved = numbers.map((number, i) => (i < fixed && command === "A" ? number : round(number + ((i - fixed) % 2 === 0 ? x : y))));
        return command + moved.join(" ");
      })
      .join("");
}

function drawBands(layer: BandsLayer, drawing: Drawing): Shape[] {
  const { frame, prefix } = drawing;
  const along = layer.across !== "y";
  const parts: string[] = [];
  for (let i = 0; i < layer.from.length; i += 1) {
    const at = along ? frame.px : frame.py;
    const [a, b] = [at(layer.from[i] as number), at(layer.to[i] as number)];
    if (Number.isNaN(a) || Number.isNaN(b)) continue;
    const [low, high] = along ? [frame.left, frame.left + frame.width] : [frame.top, frame.top + frame.height];
    const [first, last] = [Math.max(Math.min(a, b), low), Math.min(Math.max(a, b), high)];
    if (last <= first) continue;
    const [start, length] = [round(first), round(last - first)];
    parts.push(along ? `M${start} ${frame.top}h${length}v${frame.height}h${-length}z` : `M${frame.left} ${start}h${frame.width}v${length}h${-frame.width}z`);
  }
  return filled(parts.join(""), layer.style, drawing, patternOver(layer.style, prefix, drawing.theme === "dark" ? "light" : "dark"));
}

function drawArea(layer: AreaLayer, drawing: Drawing): Shape[] {
  const { frame, prefix } = drawing;
  const [x, low, high] = [pixels(layer.x, frame.px), pixels(layer.lower, frame.py), pixels(layer.upper, frame.py)];
  const draw = areaOf<number>()
    .defined((i) => ![x[i], low[i], high[i]].some(Number.isNaN))
    .x((i) => x[i] as number)
    .y0((i) => low[i] as number)
    .y1((i) => high[i] as number)
    .digits(2);
  return filled(draw(Array.from(x.keys())) ?? "", layer.style, drawing, patternOver(layer.style, prefix, drawing.theme === "dark" ? "light" : "dark"));
}

function filled(path: string, style: { colour: string }, drawing: Drawing, pattern: string | undefined): Shape[] {
  if (path === "") return [];
  const opacity = AREA_OPACITY[drawing.theme];
  return [
    shape("path", { d: path, fill: style.colour, "fill-opacity": opacity }),
    ...(pattern ? [shape("path", { d: path, fill: pattern, "fill-opacity": 0.6 })] : []),
  ];
}

function drawRule(layer: RuleLayer, drawing: Drawing): Shape[] {
  const { frame } = drawing;
  const at = layer.across === "x" ? frame.px(layer.at) : frame.py(layer.at);
  if (Number.isNaN(at)) return [];
  const path =
    layer.across === "x" ? `M${round(at)} ${frame.top}v${frame.height}` : `M${frame.left} ${round(at)}h${frame.width}`;
  return [shape("path", { d: path, ...stroke(styleOf(layer, drawing)) })];
}

function drawRegion(layer: RegionLayer, drawing: Drawing): Shape[] {
  const { left, top, width, height } = drawing.frame;
  const span = (ends: Range | null, at: (value: number) => number, low: number, length: number) => {
    if (!ends) return [low, low + length] as const;
    const [a, b] = [at(ends[0]), at(ends[1])];
    return [Math.max(Math.min(a, b), low), Math.min(Math.max(a, b), low + length)] as const;
  };
  const [x0, x1] = span(layer.x, drawing.frame.px, left, width);
  const [y0, y1] = span(layer.y, drawing.frame.py, top, height);
  if (!(x0 < x1 && y0 < y1)) return [];
  const path = `M${round(x0)} ${round(y0)}h${round(x1 - x0)}v${round(y1 - y0)}h${round(x0 - x1)}z`;
  return filled(path, layer.style, drawing, patternOver(layer.style, drawing.prefix, drawing.theme === "dark" ? "light" : "dark"));
}

/** The words of notes and along rules, with a rim, on the plot. */
export function drawWords(layer: Layer, { frame, theme, overAreas }: Drawing): Shape[] {
  const { left, top, width } = frame;
  const words = layer.kind === "note" ? layer.text : layer.kind === "rule" ? (layer.caption ?? "") : "";
  if (words === "" || (layer.kind !== "note" && layer.kind !== "rule")) return [];
  const length = widthOf(words) * SMALL_SIZE;
  const furthest = left + width - 6 - length;
  const ink = INK[overAreas ? "light" : theme];
  const at = (x: number, y: number) => [label(words, { x: Math.min(x, furthest), y, size: SMALL_SIZE, colour: ink.quiet, rim: ink.ground })];
  if (layer.kind === "note") {
    const [x, y] = [frame.px(layer.x), frame.py(layer.y)];
    return isOnPlot(frame, x, y) ? at(x, y + 4) : [];
  }
  const [x, y] = layer.across === "x" ? [frame.px(layer.at), top] : [left, frame.py(layer.at)];
  if (!isOnPlot(frame, x, y)) return [];
  // a label that would leave the plot on the right of its line goes to the left of it
  if (layer.across === "x") return at(x + 5 > furthest ? x - 5 - length : x + 5, top + 17);
  return at(left + 5, y - 4);
}

export function drawLetters(layer: ClassesLayer, drawing: Drawing): Shape[] {
  const { frame, spec } = drawing;
  const scales = { x: spec.x.scale, y: spec.y.scale };
  return letterPlaces(layer, scales, frame.window).map(({ code, x, y }) =>
    label(layer.classes[code]?.letter ?? "?", {
      x: frame.left + x * frame.width,
      y: frame.top + y * frame.height + 6,
      size: 17,
      colour: INK.light.ink,
      anchor: "middle",
      rim: INK.light.ground,
      bold: true,
    }),
  );
}
