/** Frame, grid, ticks and labels of a chart. */

import type { Frame } from "./frame";
import { widthOf } from "./markup";
import { INK, type Theme } from "./palette";
import { type Shape, round, shape } from "./scene";
import { type ChartSpec, isRaster } from "./spec";
import { LABEL_SIZE, SMALL_SIZE, label } from "./text";
import type { Tick } from "./ticks";

/** What lies below the data: ground and grid. */
export function drawGround(spec: ChartSpec, frame: Frame, theme: Theme): Shape[] {
  if (spec.layers.some(isRaster)) return [];
  const { grid } = INK[theme];
  const { left, top, width, height } = frame;
  const upright = frame.xTicks.major.map((tick) => segment(frame.px(tick.value), top, frame.px(tick.value), top + height));
  const level = frame.yTicks.major.map((tick) => segment(left, frame.py(tick.value), left + width, frame.py(tick.value)));
  return [shape("path", { d: [...upright, ...level].join(""), stroke: grid, "stroke-width": 1, fill: "none" })];
}

function segment(x1: number, y1: number, x2: number, y2: number): string {
  return `M${round(x1)} ${round(y1)}L${round(x2)} ${round(y2)}`;
}

export function drawAxes(spec: ChartSpec, frame: Frame, theme: Theme): Shape[] {
  const { ink } = INK[theme];
  const { left, top, width, height } = frame;
  const bottom = top + height;
  // maps have the same light areas in both themes
  const onAreas = spec.layers.some(isRaster) ? INK.light.ink : ink;
  const x = (length: number) => (value: number) => segment(frame.px(value), bottom, frame.px(value), bottom - length);
  const y = (length: number) => (value: number) => segment(left, frame.py(value), left + length, frame.py(value));
  const values = (list: readonly Tick[]) => list.map((tick) => tick.value);
  const marks = [
    ...values(frame.xTicks.major).map(x(7)),
    ...frame.xTicks.minor.map(x(3.5)),
    ...values(frame.yTicks.major).map(y(7)),
    ...frame.yTicks.minor.map(y(3.5)),
    ...(frame.second?.major ?? []).map((tick) => segment(frame.px(tick.value), top, frame.px(tick.value), top + 7)),
    ...(frame.second?.minor ?? []).map((value) => segment(frame.px(value), top, frame.px(value), top + 3.5)),
  ];
  const xLabels = thinned(frame.xTicks.major, frame.px, (tick) => Math.max(widthOf(tick.label) * SMALL_SIZE + 8, 34)).map((tick) =>
    label(tick.label, { x: frame.px(tick.value), y: bottom + 18, size: SMALL_SIZE, colour: ink, anchor: "middle" }),
  );
  const yLabels = thinned(frame.yTicks.major, frame.py, () => 15).map((tick) =>
    label(tick.label, { x: left - 7, y: frame.py(tick.value) + 4, size: SMALL_SIZE, colour: ink, anchor: "end" }),
  );
  const place = { size: LABEL_SIZE, colour: ink, anchor: "middle" } as const;
  const [along, up] = [withPower(spec.x.label, frame.xTicks.exponent), withPower(spec.y.label, frame.yTicks.exponent)];
  return [
    shape("rect", { x: left, y: top, width, height, fill: "none", stroke: ink, "stroke-width": 1 }),
    shape("path", { d: marks.join(""), stroke: onAreas, "stroke-width": 1, fill: "none" }),
    ...xLabels,
    ...yLabels,
    ...drawSecond(spec, frame, ink),
    label(along, { ...place, x: onPaper(along, left + width / 2, frame.paper.width), y: bottom + 40 }),
    label(up, { ...place, x: LABEL_SIZE + 1, y: onPaper(up, top + height / 2, frame.paper.height), turn: -90 }),
  ];
}

/** The labels of a second axis, above the plot. */
function drawSecond(spec: ChartSpec, frame: Frame, ink: string): Shape[] {
  if (!spec.second || !frame.second) return [];
  const { left, top, width } = frame;
  const above = thinned(frame.second.major, frame.px, (tick) => widthOf(tick.label) * SMALL_SIZE + 8).map((tick) =>
    label(tick.label, { x: frame.px(tick.value), y: top - 7, size: SMALL_SIZE, colour: ink, anchor: "middle" }),
  );
  const title = withPower(spec.second.label, frame.second.exponent);
  const middle = onPaper(title, left + width / 2, frame.paper.width);
  return [...above, label(title, { x: middle, y: top - 26, size: LABEL_SIZE, colour: ink, anchor: "middle" })];
}

/** The middle of an axis label: that of its axis, or as near to it as the paper lets a long one come. */
export function onPaper(text: string, middle: number, paper: number): number {
  const half = Math.min((widthOf(text) * LABEL_SIZE) / 2, paper / 2);
  return Math.min(Math.max(middle, half), paper - half);
}

/** Labels that keep this distance in pixels from the one before. */
function thinned(list: readonly Tick[], at: (value: number) => number, distance: (tick: Tick) => number): Tick[] {
  let taken = Number.NEGATIVE_INFINITY;
  return list.filter((tick) => {
    const place = at(tick.value);
    if (tick.label === "" || Math.abs(place - taken) < distance(tick)) return false;
    taken = place;
    return true;
  });
}

/** The label with the power of ten that the ticks leave out: `"Time (10^{−3} s)"`. */
export function withPower(text: string, exponent: number | null): string {
  if (exponent === null) return text;
  const power = `10^{${String(exponent).replace("-", "−")}}`;
  const unit = /^(.*)\(([^()]*)\)$/.exec(text);
  if (!unit) return `${text} (${power})`;
  const [, name, inside] = unit;
  return `${name}(${power}${inside === "−" || inside === "" ? "" : ` ${inside}`})`;
}
