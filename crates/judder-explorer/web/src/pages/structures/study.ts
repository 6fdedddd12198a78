/** What a study folder holds, as the server tells it. */

import { getJson, postText } from "../../wire/request";

export interface StudyVariable {
  readonly name: string;
  readonly dimensions: readonly string[];
  readonly shape: readonly number[];
  readonly units: string | null;
  readonly long_name: string | null;
  readonly attributes: Readonly<Record<string, unknown>>;
}

export interface StudyAnalysis {
  readonly name: string;
  readonly kind: string;
  readonly status: string;
  /** Why it failed. */
  readonly reason?: string | null;
  readonly seconds: number | null;
  readonly scalars: Readonly<Record<string, unknown>>;
  readonly warnings: readonly string[];
  readonly attributes: Readonly<Record<string, unknown>>;
  readonly variables: readonly StudyVariable[];
}

export interface Study {
  readonly name: string;
  readonly title: string;
  readonly model: string;
  readonly version: string;
  readonly analyses: readonly StudyAnalysis[];
  readonly sounds: readonly { readonly path: string; readonly bytes: number }[];
  readonly warnings: readonly string[];
}

export const fetchStudy = (signal?: AbortSignal) => getJson<Study>("/api/study", signal);

/** The text of the case file of one analysis, with what it is made of. */
export const fetchStudyCase = (analysis: string) => postText("/api/study/case", { analysis });

export function variable(analysis: StudyAnalysis, name: string): StudyVariable | undefined {
  return analysis.variables.find((variable) => variable.name === name);
}

export function hasVariables(analysis: StudyAnalysis, ...names: readonly string[]): boolean {
  return names.every((name) => variable(analysis, name) !== undefined);
}

/** A text of the attributes. */
export function attribute(analysis: StudyAnalysis, name: string): string | undefined {
  const value = analysis.attributes[name];
  return typeof value === "string" ? value : undefined;
}

/** Longer names do not fit along an axis. */
const LONGEST = 34;

/** Names that are said by their first letters. */
const ABBREVIATED: ReadonlyMap<string, string> = new Map([["mac", "MAC"]]);

/** The label of a variable at an axis: its own, or its name in words with the unit. */
export function axisLabel(variable: StudyVariable): string {
  const label = variable.attributes["label"];
  if (typeof label === "string" && label !== "") return keyWords(label);
  const long = variable.long_name ?? "";
  const name = ABBREVIATED.get(variable.name) ?? sentence(long !== "" && long.length <= LONGEST ? long : variable.name.replaceAll("_", " "));
  return variable.units && variable.units !== "1" ? `${name} (${unitMarkup(variable.units)})` : name;
}

/** The path of a key with its unit. */
const KEY = /^(\w[\w-]*(?:\.[\w-]+)+)( \(.*\))?$/;

/** A label in words where it is the path of a key: its last part, and of what where the table's name does not say it. */
export function keyWords(label: string): string {
  const [, path, unit = ""] = KEY.exec(label) ?? [];
  const parts = path?.split(".") ?? [];
  const name = parts.pop();
  if (name === undefined) return label;
  const owner = parts.length > 1 ? ` of ${parts.join(".")}` : "";
  return `${sentence(name.replaceAll("_", " "))}${owner}${unit}`;
}

/** With a capital at the start. */
export function sentence(words: string): string {
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** `m/s^2` as markup. */
export function unitMarkup(unit: string): string {
  return unit.replace(/\^(-?\d+)/g, (_, power: string) => `^{${power.replace("-", "−")}}`);
}

/** The analyses by kind, in the order in which the kinds come first. */
export function byKind(analyses: readonly StudyAnalysis[]): readonly { readonly kind: string; readonly analyses: readonly StudyAnalysis[] }[] {
  const kinds = [...new Set(analyses.map((analysis) => analysis.kind))];
  const rank = (kind: string) => (ORDER.includes(kind) ? ORDER.indexOf(kind) : ORDER.length);
  kinds.sort((a, b) => rank(a) - rank(b));
  return kinds.map((kind) => ({ kind, analyses: analyses.filter((analysis) => analysis.kind === kind) }));
}

const ORDER: readonly string[] = ["steady-sliding", "locus", "modes", "eigen", "eigen-sweep", "march", "spectrogram", "growth"];

/** Whether the first dimension of an analysis is the position of the contact, so that places of one mean the same in another. */
export function isOverPosition(analysis: StudyAnalysis | undefined): boolean {
  return analysis !== undefined && hasVariables(analysis, "position");
}
