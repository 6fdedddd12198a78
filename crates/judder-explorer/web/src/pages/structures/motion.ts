/** Where the contact is at a time, and when it is at a position. */

import { nearest } from "../../chart/readout";

export interface Motion {
  readonly time: Float64Array;
  readonly position: Float64Array;
}

/** The position at a time, between the stored ones. */
export function positionAt({ time, position }: Motion, at: number): number {
  const k = nearest(time, at);
  if (k < 0) return Number.NaN;
  const other = at > (time[k] as number) ? k + 1 : k - 1;
  const [t, s] = [time[k] as number, position[k] as number];
  const [u, r] = [time[other] ?? t, position[other] ?? s];
  return t === u ? s : s + ((r - s) * (at - t)) / (u - t);
}

/** When the contact first is at a position; NaN where it never is. */
export function timeAt({ time, position }: Motion, at: number): number {
  for (let k = 0; k + 1 < position.length; k += 1) {
    const [a, b] = [position[k] as number, position[k + 1] as number];
    if (a === b || (a - at) * (b - at) > 0) continue;
    return (time[k] as number) + ((at - a) / (b - a)) * ((time[k + 1] as number) - (time[k] as number));
  }
  return Number.NaN;
}

/** The part of a stretch of positions that is passed, as times; null where the contact never is in it. */
export function passed(motion: Motion, from: number, to: number): readonly [number, number] | null {
  const [first, last] = [motion.position[0] ?? Number.NaN, motion.position.at(-1) ?? Number.NaN];
  const [low, high] = [Math.min(first, last), Math.max(first, last)];
  if (!(to >= low && from <= high)) return null;
  const within = (at: number) => timeAt(motion, Math.min(Math.max(at, low), high));
  const [a, b] = [within(from), within(to)];
  return Number.isFinite(a) && Number.isFinite(b) ? [Math.min(a, b), Math.max(a, b)] : null;
}
