/** Fewer points that draw the same picture: a line of 20 000 points costs no more than the pixels that it covers. */

export interface Polyline {
  readonly x: Float64Array;
  readonly y: Float64Array;
}

/** Up to this many points a pixel column nothing is left out. */
const KEPT_PER_COLUMN = 4;

/**
 * Points in pixels, decimated: where x ascends, the first, lowest, highest and last point of every pixel column; elsewhere what moves by
 * less than half a pixel goes. NaN (a gap) stays.
 */
export function decimate(x: ArrayLike<number>, y: ArrayLike<number>, width: number): Polyline {
  const count = Math.min(x.length, y.length);
  if (count <= KEPT_PER_COLUMN * Math.max(width, 1)) return { x: Float64Array.from(x).subarray(0, count), y: Float64Array.from(y).subarray(0, count) };
  return ascends(x, count) ? byColumn(x, y, count) : byDistance(x, y, count);
}

/** Up to this many points nothing is left out. */
const FEW_POINTS = 2000;
/** Points that are closer than this cannot be told apart, in pixels. */
const CELL = 2;

/** The indices of points, given in pixels, that no earlier one hides. */
export function visible(x: ArrayLike<number>, y: ArrayLike<number>): readonly number[] {
  const indices = Array.from({ length: Math.min(x.length, y.length) }, (_, i) => i);
  if (indices.length <= FEW_POINTS) return indices;
  const taken = new Set<number>();
  return indices.filter((i) => {
    const cell = Math.floor((x[i] as number) / CELL) * 2 ** 20 + Math.floor((y[i] as number) / CELL);
    if (Number.isNaN(cell) || taken.has(cell)) return false;
    taken.add(cell);
    return true;
  });
}

function ascends(x: ArrayLike<number>, count: number): boolean {
  let before = Number.NEGATIVE_INFINITY;
  for (let i = 0; i < count; i += 1) {
    const value = x[i] as number;
    if (Number.isNaN(value)) continue;
    if (value < before) return false;
    before = value;
  }
  return true;
}

/** The indices that matter of each pixel column, in their order. */
function byColumn(x: ArrayLike<number>, y: ArrayLike<number>, count: number): Polyline {
  const kept: number[] = [];
  let [column, first, low, high, last] = [Number.NaN, -1, -1, -1, -1];
  const flush = () => {
    if (first >= 0) kept.push(...[...new Set([first, low, high, last])].sort((a, b) => a - b));
    first = -1;
  };
  for (let i = 0; i < count; i += 1) {
    const [px, py] = [x[i] as number, y[i] as number];
    if (Number.isNaN(px) || Number.isNaN(py)) {
      flush();
      if (!Number.isNaN(y[kept.at(-1) ?? -1] ?? Number.NaN)) kept.push(i);
      continue;
    }
    if (first < 0 || Math.floor(px) !== column) {
      flush();
      column = Math.floor(px);
      first = low = high = last = i;
    } else {
      if (py < (y[low] as number)) low = i;
      if (py > (y[high] as number)) high = i;
      last = i;
    }
  }
  flush();
  return pick(x, y, kept);
}

function byDistance(x: ArrayLike<number>, y: ArrayLike<number>, count: number): Polyline {
  const kept: number[] = [];
  let [lastX, lastY] = [Number.NaN, Number.NaN];
  for (let i = 0; i < count; i += 1) {
    const [dx, dy] = [(x[i] as number) - lastX, (y[i] as number) - lastY];
    // comparisons with NaN are false: gaps and what follows them stay
    if (i < count - 1 && Math.abs(dx) < 0.5 && Math.abs(dy) < 0.5) continue;
    kept.push(i);
    [lastX, lastY] = [x[i] as number, y[i] as number];
  }
  return pick(x, y, kept);
}

function pick(x: ArrayLike<number>, y: ArrayLike<number>, kept: readonly number[]): Polyline {
  return { x: Float64Array.from(kept, (i) => x[i] as number), y: Float64Array.from(kept, (i) => y[i] as number) };
}
