/** Where a value stands on an axis, and how windows are zoomed and moved. */

import type { ScaleName } from "../wire/api";

/** How values are spread along an axis; between −`linear` and `linear` a symmetric log axis is even, and as wide as two decades. */
export type Scale = ScaleName | { readonly "symmetric-log": { readonly linear: number } };

export type Range = readonly [from: number, to: number];

/** What a chart shows: the ranges of both axes. */
export interface Window {
  readonly x: Range;
  readonly y: Range;
}

/** Beyond this magnitude (and below its inverse, on log axes) differences overflow; nothing is drawn there. */
const LARGEST = 1e300;

export function drawable(scale: Scale, value: number): boolean {
  return scale === "log" ? value >= 1 / LARGEST && value <= LARGEST : Math.abs(value) <= LARGEST;
}

/** The value in the measure in which the axis is even. */
export function stretch(scale: Scale, value: number): number {
  if (scale === "linear") return value;
  if (scale === "log") return Math.log10(value);
  const { linear } = scale["symmetric-log"];
  if (Math.abs(value) <= linear) return value / linear;
  return Math.sign(value) * (1 + Math.log10(Math.abs(value)) - Math.log10(linear));
}

/** The inverse of `stretch`. */
export function shrink(scale: Scale, stretched: number): number {
  if (scale === "linear") return stretched;
  if (scale === "log") return 10 ** stretched;
  const { linear } = scale["symmetric-log"];
  if (Math.abs(stretched) <= 1) return stretched * linear;
  return Math.sign(stretched) * 10 ** (Math.abs(stretched) - 1 + Math.log10(linear));
}

/** 0 at the first end, 1 at the last, outside beyond them; NaN where the value has no place. */
export function fraction(scale: Scale, range: Range, value: number): number {
  if (!drawable(scale, value)) return Number.NaN;
  const [first, last] = [stretch(scale, range[0]), stretch(scale, range[1])];
  return (stretch(scale, value) - first) / (last - first);
}

/** The value at a fraction of the axis. */
export function valueAt(scale: Scale, range: Range, share: number): number {
  const [first, last] = [stretch(scale, range[0]), stretch(scale, range[1])];
  return shrink(scale, first + share * (last - first));
}

/** The range of the finite values with a share of padding at both ends; one that can be drawn in any case. */
export function rangeOf(scale: Scale, lists: readonly ArrayLike<number>[], padding = 0): Range {
  let [low, high] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (const list of lists) {
    for (let i = 0; i < list.length; i += 1) {
      const value = list[i] as number;
      if (!drawable(scale, value)) continue;
      if (value < low) low = value;
      if (value > high) high = value;
    }
  }
  if (low > high) return scale === "log" ? [0.1, 10] : [0, 1];
  return widened(scale, [low, high], padding);
}

/** The range with padding; wider where its values could not be told apart. */
function widened(scale: Scale, [low, high]: Range, padding = 0): Range {
  const [first, last] = [stretch(scale, low), stretch(scale, high)];
  const size = Math.max(Math.abs(low), Math.abs(high));
  const narrow = scale === "log" ? last - first < 1e-6 : high - low <= 1e-10 * Math.max(size, 1e-280);
  if (!narrow && padding === 0) return [low, high];
  const pad = !narrow ? padding * (last - first) : scale !== "linear" || size < 1e-280 ? 0.5 : 0.1 * size;
  return [shrink(scale, first - pad), shrink(scale, last + pad)];
}

/** The range that is `factor` as wide about the value at this fraction; the same range where it would be too narrow or wide. */
export function zoomed(scale: Scale, range: Range, factor: number, about: number): Range {
  return part(scale, range, about - about * factor, about + (1 - about) * factor);
}

/** The range moved by a share of itself. */
export function moved(scale: Scale, range: Range, share: number): Range {
  return part(scale, range, share, 1 + share);
}

/** The part of a range between two fractions of it (in either order). */
export function part(scale: Scale, range: Range, a: number, b: number): Range {
  const next: Range = [valueAt(scale, range, Math.min(a, b)), valueAt(scale, range, Math.max(a, b))];
  return usable(scale, next) ? next : range;
}

/** Whether the ends can be told apart and differences do not overflow. */
export function usable(scale: Scale, [from, to]: Range): boolean {
  if (!drawable(scale, from) || !drawable(scale, to) || !(from < to)) return false;
  const [first, last] = [stretch(scale, from), stretch(scale, to)];
  const width = last - first;
  return scale === "log" ? width > 1e-9 && width < 400 : width > 1e-9 * Math.max(Math.abs(first), Math.abs(last));
}
