/** Rows that are too many to be drawn: what the server answers instead of them, how that is told, and the rows themselves. */

import type { Range, Window } from "../../chart/scale";
import type { ChartSpec, Layer } from "../../chart/spec";
import { RequestError, postFrames, slot } from "../../wire/request";
import type { Arrays, Part } from "./useArrays";

/** Values that a CSV takes at most. */
const MOST_EXPORTED = 1_000_000;

/** Some rows of an array, by their index. */
export interface Rows {
  readonly from: number;
  /** The one after the last. */
  readonly to: number;
}

/** Rows in even bins, of each of which the smallest and the largest value are known. */
export interface Thinning extends Rows {
  readonly bins: number;
}

/** How a part of so many rows is thinned; null where every row comes. */
export function thinningOf(part: Part, count: number): Thinning | null {
  const { from, to } = rowsOf(part, count);
  const most = Math.max(part.most ?? Number.POSITIVE_INFINITY, 2);
  return to - from > most ? { from, to, bins: Math.floor(most / 2) } : null;
}

/** The rows that a part asks for. */
export function rowsOf(part: Part, count: number): Rows {
  const to = Math.min(part.to ?? count, count);
  return { from: Math.min(part.from ?? 0, to), to };
}

/** Where a bin begins: those of the server end at ⌊k · rows/bins⌋. */
function startOf({ from, to, bins }: Thinning, bin: number): number {
  return from + Math.floor((bin * (to - from)) / bins);
}

/** The numbers of the rows, from 1: those at the ends of every bin where they are thinned. */
export function rowNumbers(rows: Rows, thinning: Thinning | null): Float64Array {
  if (!thinning) return Float64Array.from({ length: rows.to - rows.from }, (_, i) => rows.from + i + 1);
  return Float64Array.from({ length: 2 * thinning.bins }, (_, i) => (i % 2 === 0 ? startOf(thinning, i / 2) + 1 : startOf(thinning, (i + 1) / 2)));
}

/** What stands under a chart of thinned rows. */
export function toldOf(thinning: Thinning, isComplex = false): string {
  const each = (thinning.to - thinning.from) / thinning.bins;
  const samples = Number.isInteger(each) ? String(each) : `${Math.floor(each)} or ${Math.ceil(each)}`;
  return `Of each ${samples} samples the smallest and the largest${isComplex ? " in magnitude" : ""} are drawn; the CSV has every sample that is in sight.`;
}

/** The rows of the bins that a window meets, from the smallest and the largest coordinate of each bin. */
export function rowsWithin(thinning: Thinning, ends: ArrayLike<number>, [low, high]: Range): Rows {
  let [first, last] = [-1, -1];
  for (let bin = 0; bin < thinning.bins; bin += 1) {
    if ((ends[2 * bin] as number) > high || (ends[2 * bin + 1] as number) < low) continue;
    if (first < 0) first = bin;
    last = bin;
  }
  return first < 0 ? { from: thinning.from, to: thinning.from } : { from: startOf(thinning, first), to: startOf(thinning, last + 1) };
}

/** Refuses what a CSV cannot take. */
export function checkExported(rows: number, width: number): void {
  if (rows * width <= MOST_EXPORTED) return;
  const values = width === 1 ? `${rows} samples` : `${rows} × ${width} values`;
  throw new RequestError(`${values} are in sight, and a CSV takes ${MOST_EXPORTED}`, 0, null, "Zoom in for fewer; results.zarr in the study folder has all of them.");
}

/** The rows themselves, none left out. */
export async function fetchRows(analysis: string, variables: readonly string[], { from, to }: Rows): Promise<Arrays> {
  const body = { analysis, variables, from, to, slot: slot(`study/csv/${variables.join()}`) };
  for await (const frame of postFrames("/api/study/arrays", body)) if (frame.kind === "arrays") return frame.arrays;
  throw new RequestError("the explorer sent no samples", 0, null, null);
}

/** A chart whose curves and points end where its window does; bands stay. */
export function inSight(spec: ChartSpec, { x: [low, high] }: Window): ChartSpec {
  const cut = (layer: Layer): Layer => {
    if (layer.kind !== "line" && layer.kind !== "points") return layer;
    const kept = Array.from(layer.x, (_, i) => i).filter((i) => (layer.x[i] as number) >= low && (layer.x[i] as number) <= high);
    return { ...layer, x: kept.map((i) => layer.x[i] as number), y: kept.map((i) => layer.y[i] as number) };
  };
  return { ...spec, layers: spec.layers.map(cut) };
}
