/** Runs of branches that lie upon each other: drawn twice, the dashes of one would fill the gaps of the other, and pass for a solid line. */

import { type Curve } from "../../chart/runs";
import { type Scale, fraction, rangeOf } from "../../chart/scale";

/** What cannot be told apart, in shares of the extent of all rows: less than a pixel or two of a chart. */
const NEAR = 1e-3;

/** Rows of branches, one after the other. */
export interface BranchRows extends Curve {
  /** The branch of each row. */
  readonly number: ArrayLike<number>;
}

/** Of the segments that `joins` says, from a row to the next, those that do not lie on ones of a branch before. */
export function drawnOnce({ x, y, number }: BranchRows, scale: Scale, joins: (row: number) => boolean): (row: number) => boolean {
  const [across, up] = [shares(x, scale), shares(y, "linear")];
  const drawn: number[] = [];
  const lies = (row: number) => (share: number) => {
    const at = between(across, up, row, share);
    return drawn.some((other) => number[other] !== number[row] && distance(at, between(across, up, other, 0), between(across, up, other, 1)) <= NEAR);
  };
  for (let row = 0; row + 1 < x.length; row += 1) {
    if (joins(row) && ![0, 0.5, 1].every(lies(row))) drawn.push(row);
  }
  const kept = new Set(drawn);
  return (row) => kept.has(row);
}

/** Places on an axis over the extent of all values. */
function shares(values: Float64Array, scale: Scale): Float64Array {
  const range = rangeOf(scale, [values]);
  return values.map((value) => fraction(scale, range, value));
}

type Place = readonly [number, number];

/** The place at a share of the way from a row to the next. */
function between(x: Float64Array, y: Float64Array, row: number, share: number): Place {
  const of = (values: Float64Array) => (1 - share) * (values[row] as number) + share * (values[row + 1] as number);
  return [of(x), of(y)];
}

/** From a place to the segment between two others. */
function distance([x, y]: Place, [ax, ay]: Place, [bx, by]: Place): number {
  const [dx, dy] = [bx - ax, by - ay];
  const along = ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1);
  const share = Math.min(Math.max(along, 0), 1);
  return Math.hypot(x - ax - share * dx, y - ay - share * dy);
}
