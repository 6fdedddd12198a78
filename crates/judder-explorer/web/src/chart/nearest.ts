/** What stands nearest to the cursor in the picture: a point of a curve, or the cell of a map. */

import type { Frame } from "./frame";
import { type Point, type Reading, brief, nearest } from "./readout";
import { type Axis, type ChartSpec, type LineLayer, type PointsLayer, type RasterLayer, isRaster } from "./spec";

export interface Found {
  readonly readings: readonly Reading[];
  /** The point of a curve that is told of. */
  readonly at?: Point;
}

/** How far a point may be from the cursor, in pixels, and over a map, whose cells are told of elsewhere. */
const [REACH, REACH_ON_MAP] = [30, 8];

export function found(spec: ChartSpec, frame: Frame, cursor: Point): Found {
  const map = spec.layers.find(isRaster);
  const curve = curveAt(spec, frame, cursor, map ? REACH_ON_MAP : REACH);
  if (curve) return curve;
  return { readings: (map && cellAt(map, spec, cursor)) ?? [told(spec.x, cursor.x), told(spec.y, cursor.y)] };
}

function told(axis: Axis, value: number): Reading {
  const name = axis.names?.find(([place]) => place === value)?.[1];
  return { label: axis.label, value: name ?? brief(value) };
}

function curveAt(spec: ChartSpec, frame: Frame, cursor: Point, reach: number): Found | null {
  const [cursorX, cursorY] = [frame.px(cursor.x), frame.py(cursor.y)];
  let best: { readonly layer: LineLayer | PointsLayer; readonly index: number } | null = null;
  let least = reach;
  for (const layer of spec.layers) {
    if (layer.kind !== "line" && layer.kind !== "points") continue;
    for (let index = 0; index < layer.x.length; index += 1) {
      const distance = Math.hypot(frame.px(layer.x[index] as number) - cursorX, frame.py(layer.y[index] as number) - cursorY);
      // NaN is not nearer
      if (distance < least) [best, least] = [{ layer, index }, distance];
    }
  }
  if (!best) return null;
  const { layer, index } = best;
  const at = { x: layer.x[index] as number, y: layer.y[index] as number };
  const name = layer.label === "" ? [] : [{ label: "", value: layer.label }];
  return { at, readings: [...name, told(spec.x, at.x), told(spec.y, at.y)] };
}

function cellAt(map: RasterLayer, spec: ChartSpec, cursor: Point): readonly Reading[] | undefined {
  const [column, row] = [nearest(map.x, cursor.x, spec.x.scale), nearest(map.y, cursor.y, spec.y.scale)];
  if (column < 0 || row < 0) return undefined;
  const cell = row * map.x.length + column;
  const place = [told(spec.x, map.x[column] as number), told(spec.y, map.y[row] as number)];
  if (map.kind === "values") return [...place, { label: map.label, value: brief(map.values[cell] as number) }];
  const area = map.classes[map.codes[cell] as number];
  return [{ label: "", value: area?.legend ?? area?.name ?? "—" }, ...place];
}
