/** A second scale along the upper side of a plot: its ticks, where they stand among the abscissae (`judder-report`, second_axis.rs). */

import { type Range, type Scale, drawable } from "./scale";
import type { SecondAxis } from "./spec";
import { type Tick, ticks } from "./ticks";

export interface SecondTicks {
  /** Labels, and the abscissae above which they stand, ascending. */
  readonly major: readonly Tick[];
  /** Abscissae of the short ticks. */
  readonly minor: readonly number[];
  readonly exponent: number | null;
}

/** The ticks over the range of the axis below. */
export function secondTicks(second: SecondAxis, scale: Scale, below: Range, room: number): SecondTicks {
  const ends = below.map((x) => interpolated(second, x));
  const [from, to] = [Math.min(...ends), Math.max(...ends)];
  // what stands still has no scale
  if (!Number.isFinite(from) || to - from <= 1e-9 * Math.max(Math.abs(from), Math.abs(to))) return { major: [], minor: [], exponent: null };
  const { major, minor, exponent } = ticks("linear", [from, to], room);
  const isShown = (x: number) => drawable(scale, x) && x >= below[0] && x <= below[1];
  const places = major.map(({ value, label }) => ({ value: inverse(second, value), label })).filter(({ value }) => isShown(value));
  return { major: places.sort((a, b) => a.value - b.value), minor: minor.map((value) => inverse(second, value)).filter(isShown), exponent };
}

/** The value at an abscissa, straight between points and held beyond them. */
function interpolated({ x, value }: SecondAxis, at: number): number {
  const count = x.length;
  let after = 0;
  while (after < count && (x[after] as number) <= at) after += 1;
  if (count === 0) return Number.NaN;
  if (after === 0 || after === count) return value[Math.min(after, count - 1)] as number;
  const [low, high] = [x[after - 1] as number, x[after] as number];
  const [first, last] = [value[after - 1] as number, value[after] as number];
  return first + ((last - first) * (at - low)) / (high - low);
}

/** The first abscissa with this value; NaN where there is none. */
function inverse({ x, value }: SecondAxis, wanted: number): number {
  for (let k = 0; k + 1 < value.length; k += 1) {
    const [first, last] = [value[k] as number, value[k + 1] as number];
    if (first === last || (first - wanted) * (last - wanted) > 0) continue;
    const [low, high] = [x[k] as number, x[k + 1] as number];
    return low + ((high - low) * (wanted - first)) / (last - first);
  }
  return Number.NaN;
}
