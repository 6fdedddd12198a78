/** The data of a chart as CSV: units in the header, numbers with all their digits. */

import { plainText } from "./markup";
import type { Axis, ChartSpec, Layer, LineLayer, PointsLayer } from "./spec";

export function chartCsv(spec: ChartSpec): string {
  const curves = spec.layers.filter((layer): layer is LineLayer | PointsLayer => layer.kind === "line" || layer.kind === "points");
  const first = curves[0];
  const shared = first && curves.length === spec.layers.length && curves.every((curve) => sameNumbers(curve.x, first.x));
  return shared ? wide(spec, curves) : long(spec);
}

/** Curves over the same values: a column each. */
function wide(spec: ChartSpec, curves: readonly (LineLayer | PointsLayer)[]): string {
  const unit = unitOf(nameOf(spec.y));
  const headings = curves.map((curve) => {
    const text = plainText(curve.label);
    if (text === "") return nameOf(spec.y);
    return unit === "" ? text : `${text} (${unit})`;
  });
  const x = curves[0]?.x ?? [];
  const rows = Array.from(x, (value, i) => [value, ...curves.map((curve) => curve.y[i] ?? Number.NaN)]);
  return table([nameOf(spec.x), ...headings], rows);
}

/** Everything else: one row a point, with the name of its layer. */
function long(spec: ChartSpec): string {
  const rows = spec.layers.flatMap(rowsOf);
  const map = spec.layers.find((layer) => layer.kind === "classes" || layer.kind === "values");
  const value = map?.kind === "values" ? plainText(map.label) : "class";
  const ends = spec.layers.some((layer) => layer.kind === "bands" || layer.kind === "area");
  const width = ends ? 5 : map ? 4 : 3;
  const headings = ["layer", nameOf(spec.x), nameOf(spec.y), value, "end"].slice(0, width);
  return table(headings, rows.map((row) => row.slice(0, width)));
}

type Cell = string | number;

function rowsOf(layer: Layer): Cell[][] {
  const name = plainText(layer.label);
  switch (layer.kind) {
    case "rule":
      return [layer.across === "x" ? [name, layer.at, ""] : [name, "", layer.at]];
    case "bands":
      return Array.from(layer.from, (from, i) => {
        const place: Cell[] = layer.across === "y" ? ["", from] : [from, ""];
        return [name, ...place, "", layer.to[i] ?? ""];
      });
    case "area":
      return Array.from(layer.x, (x, i) => [name, x, layer.lower[i] ?? "", "", layer.upper[i] ?? ""]);
    case "line":
    case "points":
      return Array.from(layer.x, (x, i) => [name, x, layer.y[i] ?? ""]);
    case "classes":
      return cells(layer.x, layer.y, (i) => [name, layer.classes[layer.codes[i] as number]?.name ?? ""]);
    case "values":
      return cells(layer.x, layer.y, (i) => [name, layer.values[i] ?? ""]);
  }
}

function cells(x: ArrayLike<number>, y: ArrayLike<number>, at: (index: number) => [string, Cell]): Cell[][] {
  return Array.from(y, (yValue, row) =>
    Array.from(x, (xValue, column): Cell[] => {
      const [name, value] = at(row * x.length + column);
      return [name, xValue, yValue, value];
    }),
  ).flat();
}

function nameOf(axis: Axis): string {
  return axis.name ?? plainText(axis.label);
}

/** What stands in brackets at the end of a label. */
function unitOf(label: string): string {
  return /\(([^()]*)\)$/.exec(label)?.[1] ?? "";
}

function sameNumbers(a: ArrayLike<number>, b: ArrayLike<number>): boolean {
  return a === b || (a.length === b.length && Array.from(a).every((value, i) => Object.is(value, b[i])));
}

/** RFC 4180 with line feeds; a number is the shortest text that reads back to it, NaN an empty cell. */
export function table(headings: readonly string[], rows: readonly (readonly Cell[])[]): string {
  const cell = (value: Cell) => {
    const text = typeof value === "number" ? (Number.isNaN(value) ? "" : String(value)) : value;
    return /[",\n\r]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
  };
  return [headings, ...rows].map((row) => `${row.map(cell).join(",")}\n`).join("");
}
