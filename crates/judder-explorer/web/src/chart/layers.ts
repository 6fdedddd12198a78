/** Layers of a chart as SVG. */

import { area as areaOf, line as lineOf } from "d3-shape";
import { decimate } from "./decimate";
import type { Frame } from "./frame";
import { markerPath, patternOver } from "./marks";
import { AREA_OPACITY, DASH_PATTERN, INK, type LineStyle, type Theme, lineStyle } from "./palette";
import { letterPlaces } from "./raster";
import { type Shape, round, shape } from "./scene";
import type { AreaLayer, BandsLayer, ChartSpec, ClassesLayer, Layer, LineLayer, PointsLayer, RuleLayer } from "./spec";
import { label } from "./text";

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
    case "classes":
    case "values":
      return [];
  }
}

/** Lines over coloured areas are those of the light theme: the areas are the same in both. */
function styleOf(layer: LineLayer | PointsLayer | RuleLayer, drawing: Drawing): LineStyle {
  return lineStyle(layer.role, drawing.overAreas ? "light" : drawing.theme);
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

function drawLine(layer: LineLayer, drawing: Drawing): Shape[] {
  const { frame } = drawing;
  const { x, y } = decimate(pixels(layer.x, frame.px), pixels(layer.y, frame.py), frame.width);
  const draw = lineOf<number>()
    .defined((i) => !Number.isNaN(x[i]) && !Number.isNaN(y[i]))
    .x((i) => x[i] as number)
    .y((i) => y[i] as number)
    .digits(2);
  const path = draw(Array.from(x.keys())) ?? "";
  if (path === "") return [];
  const style = styleOf(layer, drawing);
  const rim = { d: path, stroke: "#ffffff", "stroke-width": style.width + 2, "stroke-opacity": 0.6, fill: "none" };
  return [
    ...(drawing.overAreas ? [shape("path", rim)] : []),
    shape("path", { d: path, ...stroke(style, layer.dash) }),
  ];
}

/** Points within the plot, each whole; all of them are one path: thousands of elements would be slow. */
function drawPoints(layer: PointsLayer, drawing: Drawing): Shape[] {
  const { frame } = drawing;
  const style = styleOf(layer, drawing);
  const marker = relative(markerPath(layer.marker ?? style.marker, layer.size ?? 8));
  const parts: string[] = [];
  for (let i = 0; i < Math.min(layer.x.length, layer.y.length); i += 1) {
    const [x, y] = [frame.px(layer.x[i] as number), frame.py(layer.y[i] as number)];
    if (isOnPlot(frame, x, y)) parts.push(marker(x, y));
  }
  if (parts.length === 0) return [];
  const rim = drawing.overAreas ? "#ffffff" : INK[drawing.theme].ground;
  const paint = layer.hollow
    ? { fill: "none", stroke: style.colour, "stroke-width": 1.5 }
    : { fill: style.colour, stroke: rim, "stroke-width": 0.8 };
  return [shape("path", { d: parts.join(""), ...paint })];
}

/** Whether a place lies on the plot; ends of axes do, however they are rounded. */
function isOnPlot({ left, top, width, height }: Frame, x: number, y: number): boolean {
  const [across, up] = [(x - left) / width, (y - top) / height];
  return across >= -1e-9 && across <= 1 + 1e-9 && up >= -1e-9 && up <= 1 + 1e-9;
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

export function drawLetters(layer: ClassesLayer, drawing: Drawing): Shape[] {
  const { frame, spec } = drawing;
  const scales = { x: spec.x.scale, y: spec.y.scale };
  return letterPlaces(layer, scales, frame.window).map(({ code, x, y }) =>
    label(layer.classes[code]?.letter ?? "?", {
      x: frame.left + x * frame.width,
      y: frame.top + y * frame.height + 6,
      size: 17,
      colour: "#1a1a1a",
      anchor: "middle",
      rim: "#ffffff",
      bold: true,
    }),
  );
}
