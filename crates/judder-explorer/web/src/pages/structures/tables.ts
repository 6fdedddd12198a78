/** A variable as tables of one or two sides, each of which one chart can show. */

import { plainText } from "../../chart/markup";
import { brief } from "../../chart/readout";
import type { ScaleName } from "../../wire/api";
import { isOfQuantities } from "./generic";
import { type StudyAnalysis, type StudyVariable, axisLabel, sentence, unitMarkup, variable } from "./study";
import { type Rows, type Thinning, rowNumbers } from "./thinning";
import { type Arrays, numbers } from "./useArrays";

/** A dimension of a table. */
export interface Side {
  readonly name: string;
  readonly label: string;
  readonly scale: ScaleName;
  /** Its coordinate, or numbers from 1. */
  readonly values: Float64Array;
  /** The names of its entries, where they are no numbers. */
  readonly texts: readonly string[] | null;
  /** What its entries are, where they are quantities. */
  readonly quantities: Quantities | null;
  /** Whether its entries are only counted: nothing lies between them. */
  readonly isCounted: boolean;
}

interface Quantities {
  readonly units: readonly string[];
  /** Numbers and words of codes, apart by spaces; empty for other quantities. */
  readonly flagValues: readonly string[];
  readonly flagMeanings: readonly string[];
}

export interface Table {
  readonly title: string;
  /** Of the values. */
  readonly label: string;
  readonly sides: readonly Side[];
  readonly values: Float64Array;
  /** What its values mean, where they are codes; empty elsewhere. */
  readonly codes: string;
  /** Whether it is one of the quantities of a sweep, whose first key goes along. */
  readonly isSwept: boolean;
  /** Whether neighbours in a column are of one curve: not where a row is a list, whose n-th entry is not the n-th of the next one. */
  readonly isJoined: boolean;
}

/** Which rows the arrays have. */
interface Extent {
  readonly rows: Rows;
  readonly thinning: Thinning | null;
}

/** The tables of a variable; those of a complex one twice. */
export function tablesOf(analysis: StudyAnalysis, one: StudyVariable, arrays: Arrays, extent: Extent): readonly Table[] {
  const array = arrays.get(one.name);
  if (!array || array.data.length === 0) return [];
  const data = numbers(arrays, one.name);
  const parts: readonly (readonly [string, Float64Array])[] =
    array.type === "complex" ? [["real part of ", everyOther(data, 0)], ["imaginary part of ", everyOther(data, 1)]] : [["", data]];
  const sides = one.dimensions.map((name, k) => sideOf(analysis, name, arrays, k === 0 ? rowNumbers(extent.rows, extent.thinning) : counted(array.shape[k] as number)));
  return parts.flatMap(([part, values]) => {
    const title = `${analysis.name}: ${part}${wordsFor(analysis, one)}`;
    const axis = axisLabel(one);
    return split({ title, label: part ? sentence(`${part}${axis}`) : axis, sides, values, codes: codesOf(one), isSwept: false, isJoined: one.attributes["neighbours"] !== "apart" }, `${analysis.name}: ${part}`);
  });
}

/** What a variable is, with its name where others are called the same. */
function wordsFor(analysis: StudyAnalysis, { name, long_name: long }: StudyVariable): string {
  const own = name.replaceAll("_", " ");
  if (!long) return own;
  return analysis.variables.some((other) => other.name !== name && other.long_name === long) ? `${long} (${own})` : long;
}

/** What the codes of a variable mean. */
function codesOf({ attributes: { flag_values: values, flag_meanings: meanings } }: StudyVariable): string {
  return Array.isArray(values) && typeof meanings === "string" ? codeWords(values.map(String), meanings) : "";
}

function codeWords(values: readonly string[], meanings: string): string {
  const words = meanings.split(" ").map((word) => word.replaceAll("_", " "));
  return `${values.map((value, i) => `${value} is ${words[i] ?? "unknown"}`).join(", ")}.`;
}

function everyOther(values: Float64Array, offset: number): Float64Array {
  return Float64Array.from({ length: values.length / 2 }, (_, k) => values[2 * k + offset] as number);
}

function counted(count: number): Float64Array {
  return Float64Array.from({ length: count }, (_, i) => i + 1);
}

function sideOf(analysis: StudyAnalysis, name: string, arrays: Arrays, numbered: Float64Array): Side {
  const own = variable(analysis, name);
  const found = numbers(arrays, name);
  const isKnown = found.length === numbered.length;
  const values = isKnown ? found : numbered;
  const texts = arrays.get(name)?.texts ?? [];
  const said = (end: string) => arrays.get(name + end)?.texts ?? [];
  const quantities = { units: said("_units"), flagValues: said("_flag_values"), flagMeanings: said("_flag_meanings") };
  const isLog = isKnown && own?.attributes["scale"] === "log" && values.every((value) => value > 0);
  const hasUnit = Boolean(own?.units) && own?.units !== "1";
  return {
    name,
    label: own ? axisLabel(own) : `Number of the ${name.replaceAll("_", " ")}`,
    scale: isLog ? "log" : "linear",
    values,
    texts: texts.length === numbered.length ? texts : null,
    quantities: isOfQuantities(analysis, name) ? quantities : null,
    isCounted: !isKnown || (!hasUnit && values.every((value, i) => value === (values[0] as number) + i)),
  };
}

/** Tables of two sides at most: quantities apart, and slices along the first of three. */
function split(table: Table, of: string): readonly Table[] {
  const { sides } = table;
  const idle = sides.findIndex((side) => side.values.length === 1 || side.quantities !== null);
  const axis = idle >= 0 ? idle : sides.length > 2 ? 0 : -1;
  const side = sides[axis];
  if (!side) return sides.length === 0 ? [] : [table];
  return Array.from(side.values.keys()).flatMap((k) =>
    split({ ...table, ...namedAt(table, side, k, of), sides: sides.filter((_, i) => i !== axis), values: sliced(table, axis, k) }, of),
  );
}

/** What one slice is called and means. */
function namedAt(table: Table, side: Side, k: number, of: string): Partial<Table> {
  const text = side.texts?.[k];
  if (!side.quantities || text === undefined) return { title: side.values.length > 1 ? `${table.title}, ${entryOf(side, k)}` : table.title };
  const [unit = "", values = "", meanings = ""] = [side.quantities.units[k], side.quantities.flagValues[k], side.quantities.flagMeanings[k]];
  const label = unit === "" || unit === "1" ? shortened(text) : `${shortened(text)} (${unitMarkup(unit)})`;
  return { title: `${of}${text}`, label, codes: values === "" ? "" : codeWords(values.split(" "), meanings), isSwept: true };
}

/** A longer name does not fit along an axis. */
const LONGEST = 28;

/** The name of a quantity without the analysis and the table that it is of, where it would be too long. */
function shortened(name: string): string {
  const rest = name.indexOf(".");
  return name.length <= LONGEST || rest < 0 ? name : shortened(name.slice(rest + 1));
}

/** An entry of a side in words: its text, or its value with the unit. */
export function entryOf(side: Side, k: number): string {
  const text = side.texts?.[k];
  if (text !== undefined) return text;
  const [, name, unit] = /^(.*?)(?: \(([^()]*)\))?$/.exec(plainText(side.label)) as unknown as [string, string, string | undefined];
  if (side.isCounted) return `${side.name.replaceAll("_", " ")} ${side.values[k]}`;
  return `${name.charAt(0).toLowerCase()}${name.slice(1)} = ${brief(side.values[k] as number)}${unit && unit !== "−" ? ` ${unit}` : ""}`;
}

/** The values at one place along an axis. */
function sliced({ sides, values }: Table, axis: number, at: number): Float64Array {
  const length = (some: readonly Side[]) => some.reduce((product, side) => product * side.values.length, 1);
  const [outer, inner, count] = [length(sides.slice(0, axis)), length(sides.slice(axis + 1)), (sides[axis] as Side).values.length];
  return Float64Array.from({ length: outer * inner }, (_, k) => values[(Math.floor(k / inner) * count + at) * inner + (k % inner)] as number);
}
