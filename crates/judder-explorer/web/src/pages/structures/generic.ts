/** Charts of any variables: what has no view of its own is drawn over its coordinates. */

import type { ChartSpec, LineLayer, PointsLayer } from "../../chart/spec";
import { type StudyAnalysis, type StudyVariable, axisLabel, sentence, variable } from "./study";
import { type Arrays, numbers } from "./useArrays";

/** More curves in one chart tell nothing. */
const CURVES = 40;
/** Fewer points than this are marked. */
const MARKED = 200;
/** Values of an axis that are asked for at most. */
export const MOST = 4000;

/** Variables of one or two dimensions that can be drawn; coordinates are axes, not curves. */
export function drawable(analysis: StudyAnalysis, without: readonly string[]): readonly StudyVariable[] {
  return analysis.variables.filter((one) => {
    const [first, second] = one.shape;
    const isCoordinate = one.dimensions.length === 1 && one.dimensions[0] === one.name;
    const fits = one.shape.length === 1 ? (first as number) > 1 : one.shape.length === 2 && (first as number) > 1 && (second as number) <= 2 * CURVES;
    return !isCoordinate && fits && !without.includes(one.name);
  });
}

/** Coordinates that those variables lie over. */
export function coordinates(analysis: StudyAnalysis, drawn: readonly StudyVariable[]): readonly string[] {
  const names = new Set(drawn.flatMap((one) => one.dimensions));
  return [...names].filter((name) => {
    const found = variable(analysis, name);
    return found !== undefined && found.dimensions.length === 1;
  });
}

/** The values of a dimension: its coordinate, or numbers from 1. */
function valuesOf(arrays: Arrays, name: string, count: number): Float64Array {
  const own = numbers(arrays, name);
  return own.length === count ? own : Float64Array.from({ length: count }, (_, i) => i + 1);
}

function labelOf(analysis: StudyAnalysis, name: string): string {
  const own = variable(analysis, name);
  const words = name.replaceAll("_", " ");
  return own ? axisLabel(own) : `Number of the ${words}`;
}

/** The charts of one variable: two of a complex one. */
export function genericSpecs(analysis: StudyAnalysis, one: StudyVariable, arrays: Arrays): readonly ChartSpec[] {
  const array = arrays.get(one.name);
  if (!array || array.data.length === 0) return [];
  const data = numbers(arrays, one.name);
  const parts: readonly (readonly [string, Float64Array])[] =
    array.type === "complex" ? [["real part of ", everyOther(data, 0)], ["imaginary part of ", everyOther(data, 1)]] : [["", data]];
  return parts.flatMap(([part, values]) => {
    const title = `${analysis.name}: ${part}${one.long_name || one.name.replaceAll("_", " ")}`;
    const axis = axisLabel(one);
    const named = { title, label: part ? sentence(`${part}${axis}`) : axis };
    const [rows, columns] = array.shape as [number, number | undefined];
    if (columns !== undefined && columns === rows && rows > 2) return [square(analysis, one, named, values, arrays, rows)];
    return [curves(analysis, one, named, values, arrays, rows, columns ?? 1)];
  });
}

interface Named {
  readonly title: string;
  readonly label: string;
}

/** A table of as many rows as columns, such as one of modes against modes, as a map. */
function square(analysis: StudyAnalysis, one: StudyVariable, named: Named, values: Float64Array, arrays: Arrays, count: number): ChartSpec {
  const [first, second] = one.dimensions as [string, string];
  return {
    title: named.title,
    x: { label: labelOf(analysis, second), scale: "linear", range: [0.5, count + 0.5] },
    y: { label: labelOf(analysis, first), scale: "linear", range: [0.5, count + 0.5] },
    layers: [{ kind: "values", label: named.label, x: edged(valuesOf(arrays, second, count)), y: edged(valuesOf(arrays, first, count)), values: repeated(values, count), colours: "sequential", scale: "linear" }],
    equal: true,
  };
}

/** Cells that reach half a step beyond the first and the last number: a map ends at the centres of its outer cells. */
function edged(values: Float64Array): Float64Array {
  const [first, last] = [values[0] as number, values.at(-1) as number];
  return Float64Array.from([first - 0.5, first, ...values.subarray(1, -1), last, last + 0.5]);
}

/** The values with their first and last rows and columns once more, for the outer halves of cells. */
function repeated(values: Float64Array, count: number): Float64Array {
  const index = (k: number) => Math.min(Math.max(k - 1, 0), count - 1);
  const side = count + 2;
  return Float64Array.from({ length: side * side }, (_, k) => values[index(Math.floor(k / side)) * count + index(k % side)] as number);
}

function curves(analysis: StudyAnalysis, one: StudyVariable, named: Named, values: Float64Array, arrays: Arrays, rows: number, columns: number): ChartSpec {
  const first = one.dimensions[0] ?? "";
  const x = valuesOf(arrays, first, rows);
  const shown = Math.min(columns, CURVES);
  const counted = rows <= MARKED && x.every((value, i) => value === (x[0] as number) + i);
  const layers = Array.from({ length: shown }, (_, column): LineLayer | PointsLayer => {
    const label = columns > 1 && columns <= 8 ? `${(one.dimensions[1] ?? "").replaceAll("_", " ")} ${column + 1}` : "";
    const y = Float64Array.from({ length: rows }, (_, row) => values[row * columns + column] as number);
    // nothing lies between things that are only counted
    if (counted) return { kind: "points", label, x, y, role: { series: column } };
    return { kind: "line", label, x, y, role: { series: column }, marked: rows <= MARKED };
  });
  return { title: named.title, x: { label: labelOf(analysis, first), scale: "linear" }, y: { label: named.label, scale: "linear" }, layers };
}

function everyOther(values: Float64Array, offset: number): Float64Array {
  return Float64Array.from({ length: values.length / 2 }, (_, k) => values[2 * k + offset] as number);
}
