/** The data of a chart as CSV: units in the header, numbers with all their digits. */

import { plainText } from "./markup";
import { type Axis, type ChartSpec, type Layer, type LineLayer, type PointsLayer, type RasterLayer, isRaster } from "./spec";

export function chartCsv(spec: ChartSpec): string {
  const layers = spec.layers.filter(isData);
  const curves = layers.filter((layer): layer is LineLayer | PointsLayer => layer.kind === "line" || layer.kind === "points");
  const first = curves[0];
  const shared = first && curves.length === layers.length && curves.every((curve) => sameNumbers(curve.x, first.x));
  return shared ? wide(spec, curves) : long(spec, layers);
}

/** A rule without a label only guides the eye. */
function isData(layer: Layer): boolean {
  return !layer.scenery && layer.kind !== "note" && (layer.kind !== "rule" || layer.label !== "");
}

/** Curves over the same values: a column each. */
function wide(spec: ChartSpec, curves: readonly (LineLayer | PointsLayer)[]): string {
  const unit = unitOf(nameOf(spec.y));
  const headings = curves.map((curve) => {
    const text = nameOfLayer(curve);
    if (text === "") return nameOf(spec.y);
    return unit === "" ? text : `${text} (${unit})`;
  });
  const x = curves[0]?.x ?? [];
  const rows = Array.from(x, (value, i) => [value, ...curves.map((curve) => curve.y[i] ?? Number.NaN)]);
  return table([nameOf(spec.x), ...headings], rows);
}

/** One row of a layer: what stands in each column. */
interface Row {
  readonly layer: string;
  readonly x?: Cell;
  readonly y?: Cell;
  readonly value?: Cell;
  readonly end?: Cell;
  readonly along?: Cell;
}

/** Everything else: one row a point, with the name of its layer. */
function long(spec: ChartSpec, layers: readonly Layer[]): string {
  const map = layers.find(isRaster);
  const along = layers.flatMap((layer) => (layer.kind === "line" && layer.along ? [layer.along.name] : []))[0];
  const ends = layers.some((layer) => layer.kind === "bands" || layer.kind === "area");
  const columns: readonly (readonly [column: keyof Row, heading: string])[] = [
    ["layer", "layer"],
    ...(along === undefined ? [] : [["along", along] as const]),
    ["x", nameOf(spec.x)],
    ["y", nameOf(spec.y)],
    ...(map ? [["value", map.kind === "values" ? nameOfLayer(map) : "class"] as const] : []),
    ...(ends ? [["end", "end"] as const] : []),
  ];
  const rows = layers.flatMap(rowsOf).map((row) => columns.map(([column]) => row[column] ?? ""));
  return table(columns.map(([, heading]) => heading), rows);
}

type Cell = string | number;

function rowsOf(layer: Layer): Row[] {
  const name = nameOfLayer(layer);
  switch (layer.kind) {
    case "rule":
      return [{ layer: name, [layer.across]: layer.at }];
    case "note":
      return [];
    case "region":
      return (["x", "y"] as const).flatMap((across) => (layer[across] ? [{ layer: name, [across]: layer[across][0], end: layer[across][1] }] : []));
    case "bands":
      return Array.from(layer.from, (from, i) => ({ layer: name, [layer.across ?? "x"]: from, end: layer.to[i] ?? "" }));
    case "area":
      return Array.from(layer.x, (x, i) => ({ layer: name, x, y: layer.lower[i] ?? "", end: layer.upper[i] ?? "" }));
    case "line":
      return Array.from(layer.x, (x, i) => ({ layer: name, x, y: layer.y[i] ?? "", along: layer.along?.values[i] ?? "" }));
    case "points":
      return Array.from(layer.x, (x, i) => ({ layer: name, x, y: layer.y[i] ?? "" }));
    case "classes":
      return cells(layer, name, (i) => layer.classes[layer.codes[i] as number]?.name ?? "");
    case "values":
      return cells(layer, name, (i) => layer.values[i] ?? "");
  }
}

function cells({ x, y }: RasterLayer, layer: string, at: (index: number) => Cell): Row[] {
  return Array.from(y, (yValue, row) =>
    Array.from(x, (xValue, column) => ({ layer, x: xValue, y: yValue, value: at(row * x.length + column) })),
  ).flat();
}

function nameOfLayer(layer: Layer): string {
  return layer.name ?? plainText(layer.label);
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

/** A text that a spreadsheet would take for a formula after an apostrophe, by which it takes it for a text, as in the tables of studies. */
function guarded(text: string): string {
  return /^[=+\-@\t\r]/.test(text) && Number.isNaN(Number(text)) ? `'${text}` : text;
}

/** RFC 4180 with line feeds; a number is the shortest text that reads back to it, NaN an empty cell; no text is a formula. */
export function table(headings: readonly string[], rows: readonly (readonly Cell[])[]): string {
  const cell = (value: Cell) => {
    const text = typeof value === "number" ? (Number.isNaN(value) ? "" : String(value)) : guarded(value);
    return /[",\n\r]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
  };
  return [headings, ...rows].map((row) => `${row.map(cell).join(",")}\n`).join("");
}
