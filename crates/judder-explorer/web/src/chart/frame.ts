/** The geometry of a chart: where the plot lies, and from values to pixels. */

import { legendRows, type Entry, ROW } from "./legend";
import { widthOf } from "./markup";
import { type Range, type Window, fraction, rangeOf, stretch, shrink, valueAt } from "./scale";
import { type Axis, type ChartSpec, type Layer, isRaster } from "./spec";
import { LABEL_SIZE, SMALL_SIZE } from "./text";
import { type SecondTicks, secondTicks } from "./second";
import { type Ticks, namedTicks, ticks } from "./ticks";

export interface Size {
  readonly width: number;
  readonly height: number;
}

export interface Frame {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
  /** The whole picture. */
  readonly paper: Size;
  readonly window: Window;
  readonly xTicks: Ticks;
  readonly yTicks: Ticks;
  /** Those of a second axis, above the plot. */
  readonly second: SecondTicks | null;
  /** Pixels of a value; NaN where it has no place. */
  readonly px: (value: number) => number;
  readonly py: (value: number) => number;
}

/** What a chart shows at first. */
export function homeWindow(spec: ChartSpec): Window {
  const lists = (across: "x" | "y") => spec.layers.flatMap((layer) => extent(layer, across));
  const padding = spec.layers.some(isRaster) ? 0 : 0.04;
  return {
    x: spec.x.range ?? rangeOf(spec.x.scale, lists("x"), spec.layers.some((layer) => layer.kind === "points") ? padding : 0),
    y: spec.y.range ?? rangeOf(spec.y.scale, lists("y"), padding),
  };
}

function extent(layer: Layer, across: "x" | "y"): ArrayLike<number>[] {
  switch (layer.kind) {
    case "rule":
      return layer.across === across ? [[layer.at]] : [];
    case "bands":
      return (layer.across ?? "x") === across ? [layer.from, layer.to] : [];
    case "region":
      return [layer[across] ?? []];
    case "note":
      return [[layer[across]]];
    case "area":
      return across === "x" ? [layer.x] : [layer.lower, layer.upper];
    default:
      return [layer[across]];
  }
}

/** Room for labels: one for about so many pixels. */
const [ACROSS, UP] = [76, 44];
const BAR_ROOM = 86;
/** For ticks and label of a second axis. */
const SECOND_ROOM = 40;

function ticksOf(axis: Axis, range: Range, room: number): Ticks {
  return axis.names ? namedTicks(axis.names, axis.scale, range) : ticks(axis.scale, range, room);
}

export function frameOf(spec: ChartSpec, window: Window, size: Size, entries: readonly Entry[]): Frame {
  const top = 14 + ROW * legendRows(entries, size.width).length + (spec.second ? SECOND_ROOM : 0);
  const bottom = 26 + LABEL_SIZE + 8;
  const tallest = Math.max(size.height - top - bottom, 1);
  const widest = widestLabel(ticksOf(spec.y, window.y, tallest / UP));
  const left = Math.min(widest + LABEL_SIZE + 22, Math.max(size.width / 3, 30));
  // a label at the end of the axis reaches beyond it by its half
  const half = widestLabel(ticksOf(spec.x, window.x, (size.width - left) / ACROSS)) / 2;
  const right = spec.layers.some((layer) => layer.kind === "values") ? BAR_ROOM : Math.max(22, Math.ceil(half) + 2);
  const room = { width: Math.max(size.width - left - right, 1), height: tallest };
  const { width, height } = spec.equal && spec.layers.some(isRaster) ? fitted(spec, window, room) : room;
  const shown = spec.equal ? equalised(spec, window, width / height) : window;
  return {
    left,
    top,
    width,
    height,
    paper: size,
    window: shown,
    xTicks: ticksOf(spec.x, shown.x, width / ACROSS),
    yTicks: ticksOf(spec.y, shown.y, height / UP),
    second: spec.second ? secondTicks(spec.second, spec.x.scale, shown.x, width / ACROSS) : null,
    px: (value) => left + width * fraction(spec.x.scale, shown.x, value),
    py: (value) => top + height * (1 - fraction(spec.y.scale, shown.y, value)),
  };
}

function widestLabel({ major }: Ticks): number {
  return Math.ceil(Math.max(0, ...major.map((tick) => widthOf(tick.label) * SMALL_SIZE)));
}

/** How much narrower or lower than its room a plot may become. */
const LEAST = 0.25;

/** The part of the room that has the shape of what is shown: beyond a map there is nothing to show, not even numbers of its cells. */
function fitted(spec: ChartSpec, window: Window, { width, height }: Size): Size {
  const lengths = lengthsOf(spec, window);
  const ratio = lengths.x / lengths.y;
  return { width: Math.max(Math.min(width, height * ratio), LEAST * width), height: Math.max(Math.min(height, width / ratio), LEAST * height) };
}

/** How long the axes are in their own measures. */
function lengthsOf(spec: ChartSpec, window: Window): { readonly x: number; readonly y: number } {
  const length = (across: "x" | "y") => stretch(spec[across].scale, window[across][1]) - stretch(spec[across].scale, window[across][0]);
  return { x: length("x"), y: length("y") };
}

/** The window made wider or higher, so that units are equally long on both axes. */
function equalised(spec: ChartSpec, window: Window, ratio: number): Window {
  const grown = (scale: Window["x"], name: typeof spec.x.scale, wanted: number): Window["x"] => {
    const [from, to] = [stretch(name, scale[0]), stretch(name, scale[1])];
    const more = (wanted - (to - from)) / 2;
    return more <= 0 ? scale : [shrink(name, from - more), shrink(name, to + more)];
  };
  const lengths = lengthsOf(spec, window);
  return { x: grown(window.x, spec.x.scale, lengths.y * ratio), y: grown(window.y, spec.y.scale, lengths.x / ratio) };
}

/** The values at a place of the picture. */
export function valuesAt(spec: ChartSpec, frame: Frame, x: number, y: number): { x: number; y: number } {
  return {
    x: valueAt(spec.x.scale, frame.window.x, (x - frame.left) / frame.width),
    y: valueAt(spec.y.scale, frame.window.y, 1 - (y - frame.top) / frame.height),
  };
}
