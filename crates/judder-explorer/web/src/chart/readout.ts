/** What a cursor reads off a chart. */

import { fraction } from "./scale";
import { type ChartSpec, isRaster } from "./spec";

export interface Reading {
  /** Markup. */
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

/** The axes' values at the cursor, and of every curve the point that is nearest along x. */
export function readings(spec: ChartSpec, cursor: { readonly x: number; readonly y: number }): readonly Reading[] {
  const axes = [
    { label: spec.x.label, value: brief(cursor.x) },
    { label: spec.y.label, value: brief(cursor.y) },
  ];
  const layers = spec.layers.flatMap((layer): Reading[] => {
    if (isRaster(layer)) {
      const [column, row] = [nearest(layer.x, cursor.x), nearest(layer.y, cursor.y)];
      if (column < 0 || row < 0) return [];
      const at = row * layer.x.length + column;
      if (layer.kind === "values") return [{ label: layer.label, value: brief(layer.values[at] as number) }];
      return [{ label: layer.label || "class", value: layer.classes[layer.codes[at] as number]?.name ?? "—" }];
    }
    if (layer.kind === "bands") {
      const place = layer.across === "y" ? cursor.y : cursor.x;
      const within = Array.from(layer.from).some((from, i) => place >= from && place <= (layer.to[i] as number));
      return within ? [{ label: layer.label, value: "here" }] : [];
    }
    if (layer.kind !== "line" || layer.label === "") return [];
    const at = nearest(layer.x, cursor.x);
    return at < 0 ? [] : [{ label: layer.label, value: brief(layer.y[at] as number) }];
  });
  return [...axes, ...layers];
}

/** The index of the value that is nearest, −1 where there is none. */
export function nearest(values: ArrayLike<number>, wanted: number): number {
  let [best, distance] = [-1, Number.POSITIVE_INFINITY];
  for (let i = 0; i < values.length; i += 1) {
    const away = Math.abs((values[i] as number) - wanted);
    if (away < distance) [best, distance] = [i, away];
  }
  return best;
}

/** Whether a cursor lies in what is shown. */
export function isShown(spec: ChartSpec, window: { x: readonly [number, number]; y: readonly [number, number] }, cursor: { x: number; y: number }): boolean {
  const [x, y] = [fraction(spec.x.scale, window.x, cursor.x), fraction(spec.y.scale, window.y, cursor.y)];
  return x >= -1e-9 && x <= 1 + 1e-9 && y >= -1e-9 && y <= 1 + 1e-9;
}
