/** What a cursor reads off a chart. */

import { type Scale, fraction, stretch } from "./scale";
import { type ChartSpec, type Layer, isRaster } from "./spec";

export interface Reading {
  /** Both are markup. */
  readonly label: string;
  readonly value: string;
}

/** A number as it is written: one that would begin with zeros by its power of ten, as `judder point` prints it. */
export function written(value: number): string {
  return value !== 0 && Math.abs(value) < 1e-3 ? value.toExponential() : String(value);
}

/** A number in a few digits, for reading; exact values stand elsewhere. */
export function brief(value: number, digits = 5): string {
  if (!Number.isFinite(value)) return "—";
  return written(Number(value.toPrecision(digits))).replaceAll("-", "−");
}

export type Point = { readonly x: number; readonly y: number };

/** What a layer says, and the coordinates of its point that says so. */
interface Told extends Reading {
  readonly at?: readonly number[];
}

/** The cursor's place, and what every layer says at its point that is nearest: where that is stands once, if it is the same for all. */
export function readings(spec: ChartSpec, cursor: Point): readonly Reading[] {
  const axes = [
    { label: spec.x.label, value: brief(cursor.x) },
    { label: spec.y.label, value: brief(cursor.y) },
  ];
  const told = spec.layers.flatMap((layer) => toldBy(layer, spec, cursor));
  const text = ({ at }: Told) => at?.map((value) => brief(value)).join(", ");
  const places = new Set(told.filter(({ at }) => at).map(text));
  const [place] = places;
  if (place !== undefined && places.size === 1) return [...axes, { label: "values at", value: place }, ...told];
  return [...axes, ...told.map((one) => (one.at ? { label: one.label, value: `${one.value} at ${text(one)}` } : one))];
}

function toldBy(layer: Layer, spec: ChartSpec, cursor: Point): Told[] {
  if (isRaster(layer)) {
    const [column, row] = [nearest(layer.x, cursor.x, spec.x.scale), nearest(layer.y, cursor.y, spec.y.scale)];
    if (column < 0 || row < 0) return [];
    const index = row * layer.x.length + column;
    const at = [layer.x[column] as number, layer.y[row] as number];
    if (layer.kind === "values") return [{ label: layer.label, value: brief(layer.values[index] as number), at }];
    return [{ label: layer.label || "class", value: layer.classes[layer.codes[index] as number]?.name ?? "—", at }];
  }
  if (layer.kind === "bands") {
    const place = layer.across === "y" ? cursor.y : cursor.x;
    const within = Array.from(layer.from).some((from, i) => place >= from && place <= (layer.to[i] as number));
    return within ? [{ label: layer.label, value: "here" }] : [];
  }
  if (layer.kind !== "line" || layer.label === "") return [];
  const index = nearest(layer.x, cursor.x, spec.x.scale);
  return index < 0 ? [] : [{ label: layer.label, value: brief(layer.y[index] as number), at: [layer.x[index] as number] }];
}

/** The index of the value that is nearest in the measure of its axis, −1 where there is none. */
export function nearest(values: ArrayLike<number>, wanted: number, scale: Scale = "linear"): number {
  const place = stretch(scale, wanted);
  let [best, distance] = [-1, Number.POSITIVE_INFINITY];
  for (let i = 0; i < values.length; i += 1) {
    const away = Math.abs(stretch(scale, values[i] as number) - place);
    if (away < distance) [best, distance] = [i, away];
  }
  return best;
}

/** Whether a cursor lies in what is shown. */
export function isShown(spec: ChartSpec, window: { x: readonly [number, number]; y: readonly [number, number] }, cursor: { x: number; y: number }): boolean {
  const [x, y] = [fraction(spec.x.scale, window.x, cursor.x), fraction(spec.y.scale, window.y, cursor.y)];
  return x >= -1e-9 && x <= 1 + 1e-9 && y >= -1e-9 && y <= 1 + 1e-9;
}
