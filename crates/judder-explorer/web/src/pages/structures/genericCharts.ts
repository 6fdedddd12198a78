/** Charts of any variables: what has no view of its own is drawn over its coordinates. */

import { chartCsv } from "../../chart/csv";
import type { Window } from "../../chart/scale";
import type { ChartSpec, LineLayer, PointsLayer } from "../../chart/spec";
import { CURVES, coordinates, widthOf } from "./generic";
import type { AxisNames } from "./state";
import type { StudyAnalysis, StudyVariable } from "./study";
import { type Side, type Table, entryOf, tablesOf } from "./tables";
import { type Thinning, checkExported, fetchRows, inSight, rowsOf, rowsWithin, thinningOf, toldOf } from "./thinning";
import type { Arrays, Part } from "./useArrays";

/** Fewer points than this are marked, and drawn large. */
const MARKED = 200;
/** How many points are drawn: as outlines, which fill them; the rims of others would cover their neighbours. */
const MANY = { size: 1.5, hollow: true } as const;
/** So many curves have names in the legend. */
const NAMED = 8;
/** The height of a chart, and what every name adds to it, in pixels. */
const [HEIGHT, ENTRY] = [300, 20];

export interface GenericChart {
  readonly spec: ChartSpec;
  readonly names: AxisNames;
  readonly height: number;
  readonly note?: string | undefined;
  /** What the CSV has, where it is not what is drawn. */
  readonly dataOf?: ((window: Window) => string | Promise<string>) | undefined;
}

/** The charts of one variable, of arrays that were asked for by a part. */
export function genericCharts(analysis: StudyAnalysis, one: StudyVariable, arrays: Arrays, part: Part): readonly GenericChart[] {
  const rows = one.shape[0] as number;
  const thinning = thinningOf(part, rows);
  const isComplex = arrays.get(one.name)?.type === "complex";
  return tablesOf(analysis, one, arrays, { rows: rowsOf(part, rows), thinning }).map((table, index) => {
    const isMap = !thinning && showsMap(table);
    const [first, second] = isMap && table.isSwept ? [...table.sides].reverse() : table.sides;
    const note = [thinning ? toldOf(thinning, isComplex) : "", table.codes].filter(Boolean).join(" ");
    const x = isMap ? `${second?.name}-map` : (first?.name ?? "x");
    return {
      spec: isMap ? mapSpec(table, true) : curvesSpec(table),
      names: { x, y: `${one.name}-${index}` },
      height: HEIGHT + ENTRY * (isMap ? 0 : namedCurves(table)),
      note: note || undefined,
      dataOf: thinning ? samplesOf(analysis, one, arrays, thinning, index) : isMap ? () => chartCsv(mapSpec(table, false)) : undefined,
    };
  });
}

/** Fetches the samples of a window of which the chart shows extremes. */
function samplesOf(analysis: StudyAnalysis, one: StudyVariable, arrays: Arrays, thinning: Thinning, index: number) {
  const ends = tablesOf(analysis, one, arrays, { rows: thinning, thinning })[index]?.sides[0]?.values ?? new Float64Array(0);
  return async (window: Window) => {
    const rows = rowsWithin(thinning, ends, window.x);
    checkExported(rows.to - rows.from, widthOf(one));
    const found = await fetchRows(analysis.name, [one.name, ...coordinates(analysis, [one])], rows);
    const table = tablesOf(analysis, one, found, { rows, thinning: null })[index];
    return table ? chartCsv(inSight(curvesSpec(table), window)) : "";
  };
}

/** Whether a table is one of a surface rather than of some curves. */
function showsMap({ sides: [first, second] }: Table): boolean {
  if (!first || !second || first.texts || second.texts) return false;
  const [rows, columns] = [first.values.length, second.values.length];
  const isSquare = rows === columns && rows > 2;
  return isSquare || columns > CURVES || (columns > NAMED && !first.isCounted && !second.isCounted);
}

/** A table as a map, its outer cells whole or, as data, with nothing added. */
function mapSpec(table: Table, whole: boolean): ChartSpec {
  const { title, label, sides, values } = table.isSwept ? transposed(table) : table;
  const [down, across] = sides as readonly [Side, Side];
  const [y, x] = [linedUp(down), linedUp(across)];
  const [padY, padX] = [whole && y.isCounted, whole && x.isCounted];
  const width = x.values.length;
  const [rows, columns] = [indices(y.values.length, padY), indices(width, padX)];
  const shown = Float64Array.from({ length: rows.length * columns.length }, (_, k) => {
    const [row, column] = [rows[Math.floor(k / columns.length)] as number, columns[k % columns.length] as number];
    return values[row * width + column] as number;
  });
  return {
    title,
    x: { label: x.label, scale: x.scale },
    y: { label: y.label, scale: y.scale },
    layers: [{ kind: "values", label, x: padX ? edged(x.values) : x.values, y: padY ? edged(y.values) : y.values, values: shown, colours: "sequential", scale: "linear" }],
    equal: isLevel(x, y),
  };
}

/** Whether both sides have as many values over the same length: their units are drawn equally long. */
function isLevel(x: Side, y: Side): boolean {
  const [across, up] = [x, y].map(({ values }) => (values.at(-1) as number) - (values[0] as number)) as [number, number];
  return x.values.length === y.values.length && x.scale === "linear" && y.scale === "linear" && Math.abs(across / up - 1) < 0.01;
}

/** A side of a map: its values have to ascend, and are numbers where they do not. */
function linedUp(side: Side): Side {
  if (side.values.every((value, i) => i === 0 || value > (side.values[i - 1] as number))) return side;
  return { ...side, label: `Number of the ${side.name.replaceAll("_", " ")}`, scale: "linear", values: side.values.map((_, i) => i + 1), isCounted: true };
}

/** Cells that reach half a step beyond the first and the last number: a map ends at the centres of its outer cells. */
function edged(values: Float64Array): Float64Array {
  const [first, last] = [values[0] as number, values.at(-1) as number];
  return Float64Array.from([first - 0.5, ...values, last + 0.5]);
}

/** The places of the values of a side, the first and the last once more for the outer halves of their cells. */
function indices(count: number, padded: boolean): readonly number[] {
  const own = Array.from({ length: count }, (_, i) => i);
  return padded ? [0, ...own, count - 1] : own;
}

function curvesSpec(table: Table): ChartSpec {
  const { title, label, sides, values, codes, isJoined } = turned(table);
  const [along, other] = sides as readonly [Side, Side | undefined];
  const [rows, columns] = [along.values.length, other?.values.length ?? 1];
  // nothing lies between things that are only counted, nor between codes
  const isApart = along.isCounted || codes !== "" || !isJoined;
  const order = inOrder(along.values);
  const layers = Array.from({ length: columns }, (_, column): LineLayer | PointsLayer => {
    const curve = { label: other && namedCurves(table) > 0 ? entryOf(other, column) : "", x: Float64Array.from(order, (row) => along.values[row] as number), role: { series: column } };
    const y = Float64Array.from(order, (row) => values[row * columns + column] as number);
    if (isApart) return { kind: "points", ...curve, y, ...(rows > MARKED ? MANY : {}) };
    return { kind: "line", ...curve, y, marked: rows <= MARKED };
  });
  return { title, x: { label: along.label, scale: along.scale }, y: { label, scale: "linear" }, layers };
}

/** The rows as they follow one another along their axis: as they stand, or by their values where those go to and fro. */
function inOrder(along: Float64Array): readonly number[] {
  const rows = Array.from(along.keys());
  const at = (row: number) => along[row] as number;
  const goes = (way: 1 | -1) => rows.every((row) => row === 0 || way * (at(row) - at(row - 1)) >= 0);
  return goes(1) || goes(-1) || along.some(Number.isNaN) ? rows : rows.sort((a, b) => at(a) - at(b));
}

/** How many curves of a table have names. */
function namedCurves(table: Table): number {
  const count = turned(table).sides[1]?.values.length ?? 0;
  return count <= NAMED ? count : 0;
}

/** A table whose rows are numbers: entries with names are curves. */
function turned(table: Table): Table {
  const [first, second] = table.sides;
  return first?.texts && second && !second.texts ? transposed(table) : table;
}

/** A table of two sides with its rows as columns. */
function transposed({ sides, values, ...rest }: Table): Table {
  const [first, second] = sides as readonly [Side, Side];
  const [rows, columns] = [first.values.length, second.values.length];
  return { ...rest, sides: [second, first], values: Float64Array.from(values, (_, k) => values[(k % rows) * columns + Math.floor(k / rows)] as number) };
}
