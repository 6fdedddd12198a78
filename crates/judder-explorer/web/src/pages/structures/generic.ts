/** Which variables have a chart without a view of their own, and what is asked of the server for it. */

import { type StudyAnalysis, type StudyVariable, variable } from "./study";
import type { Part } from "./useArrays";

/** More curves in one chart tell nothing. */
export const CURVES = 40;
/** More charts of one variable tell nothing. */
const SLICES = 12;
/** Values of a variable that are asked for whole; the chart itself leaves out what no pixel shows. */
const WHOLE = 300_000;
/** Values that come whole where there is no other way. */
const LARGEST = 1_000_000;
/** Rows that are asked for of a longer variable. */
const MOST = 4000;

/** Whether every entry along a dimension has a name and a unit of its own, such as the quantities of a sweep. */
export function isOfQuantities(analysis: StudyAnalysis, dimension: string): boolean {
  return variable(analysis, `${dimension}_units`) !== undefined;
}

/** The dimensions that a chart has to show, by their place: those of one entry say nothing, and quantities have charts of their own. */
function shownDimensions(analysis: StudyAnalysis, one: StudyVariable): readonly number[] {
  return Array.from(one.shape.keys()).filter((k) => (one.shape[k] as number) > 1 && !isOfQuantities(analysis, one.dimensions[k] as string));
}

function count(one: StudyVariable): number {
  return one.shape.reduce((product, length) => product * length, 1);
}

/** Values of one row. */
export function widthOf(one: StudyVariable): number {
  return one.shape.slice(1).reduce((product, length) => product * length, 1);
}

/** Whether a variable is so long that extremes of its rows have to do. */
function isLong(analysis: StudyAnalysis, one: StudyVariable): boolean {
  const shown = shownDimensions(analysis, one);
  return count(one) > WHOLE && shown[0] === 0 && shown.length <= 2 && widthOf(one) <= CURVES;
}

/** Variables that a chart could be made of: coordinates are axes, what is said of quantities is words, and one value is no picture. */
function candidates(analysis: StudyAnalysis, without: readonly string[]): readonly StudyVariable[] {
  return analysis.variables.filter((one) => {
    const isCoordinate = one.dimensions.length === 1 && one.dimensions[0] === one.name;
    return !isCoordinate && !without.includes(one.name) && count(one) > 0 && shownDimensions(analysis, one).length > 0;
  });
}

/** Why a variable has no chart; undefined where it has one. */
function whyNot(analysis: StudyAnalysis, one: StudyVariable): string | undefined {
  const shown = shownDimensions(analysis, one);
  if (shown.length > 3) return `it has ${shown.length} dimensions`;
  const [first] = shown;
  const slices = one.shape[first as number] as number;
  if (shown.length === 3 && slices > SLICES) return `${slices} slices along ${(one.dimensions[first as number] as string).replaceAll("_", " ")} are too many`;
  if (count(one) > LARGEST && !isLong(analysis, one)) return `${count(one)} values are too many`;
  return undefined;
}

/** Variables that are drawn. */
export function drawable(analysis: StudyAnalysis, without: readonly string[]): readonly StudyVariable[] {
  return candidates(analysis, without).filter((one) => whyNot(analysis, one) === undefined);
}

/** Variables that are not drawn, with the reason. */
export function undrawn(analysis: StudyAnalysis, without: readonly string[]): readonly (readonly [string, string])[] {
  return candidates(analysis, without).flatMap((one) => {
    const reason = whyNot(analysis, one);
    return reason === undefined ? [] : [[one.name, reason] as const];
  });
}

/** What is said of every entry of a dimension of quantities. */
const SAID = ["", "_units", "_flag_values", "_flag_meanings"];

/** What those variables lie over: their coordinates, and what is said of quantities. */
export function coordinates(analysis: StudyAnalysis, drawn: readonly StudyVariable[]): readonly string[] {
  const names = new Set(drawn.flatMap((one) => one.dimensions).flatMap((name) => SAID.map((end) => name + end)));
  return [...names].filter((name) => variable(analysis, name)?.dimensions.length === 1);
}

/** Variables that are asked for at once. */
export interface ArraysRequest {
  readonly drawn: readonly StudyVariable[];
  readonly names: readonly string[];
  readonly part: Part;
}

/** One request for what comes whole, and one for long variables over each dimension: a part is one of the first dimension. */
export function requestsOf(analysis: StudyAnalysis, drawn: readonly StudyVariable[]): readonly ArraysRequest[] {
  const request = (some: readonly StudyVariable[], part: Part) => {
    const own = some.map((one) => one.name);
    return { drawn: some, names: [...own, ...coordinates(analysis, some).filter((name) => !own.includes(name))], part };
  };
  const whole = drawn.filter((one) => !isLong(analysis, one));
  const long = drawn.filter((one) => isLong(analysis, one));
  const along = [...new Set(long.map((one) => one.dimensions[0]))];
  return [
    ...(whole.length > 0 ? [request(whole, {})] : []),
    ...along.map((name) => request(long.filter((one) => one.dimensions[0] === name), { most: MOST })),
  ];
}
