/** What the server sends and takes; the words are those of case files. */

import { getJson, postJson, postText } from "./request";

export type ScaleName = "log" | "linear";

/** A range over a key, as a case file takes it: a plain number is the group, a text may carry a unit. */
export interface KeyAxis {
  readonly key: string;
  readonly from: number | string;
  readonly to: number | string;
  readonly scale: ScaleName;
}

/** The ends of what a number may be: `from` and `to` belong to it, `above` and `below` do not. */
export interface Bounds {
  readonly from?: number;
  readonly above?: number;
  readonly to?: number;
  readonly below?: number;
}

/** What the value of a key may be. */
export type Form =
  /** A plain number is the `group`, a text carries the `unit` or one like it; null where there is none. */
  | { readonly kind: "number"; readonly group: string | null; readonly unit: string | null; readonly range: Bounds }
  | { readonly kind: "whole"; readonly range: Bounds }
  | { readonly kind: "choice"; readonly words: readonly { readonly word: string; readonly doc: string }[] }
  | { readonly kind: "table"; readonly keys: readonly Declaration[] }
  | { readonly kind: "flag" | "text" | "list" | "named" | "either" | "other" };

/** A key of a case file, and what is said of it. */
export interface Declaration {
  readonly name: string;
  readonly doc: string;
  readonly symbol: string;
  readonly required: boolean;
  /** What it is where it is left out, as a case file says it; null where that is not known. */
  readonly default: unknown;
  /** What its value may be, in words. */
  readonly words: string;
  readonly form: Form;
}

export interface Key {
  readonly path: string;
  readonly section: string;
  readonly symbol: string;
  /** The dimensionless group that a plain number means; null where a plain number is in `unit`. */
  readonly group: string | null;
  readonly unit: string;
  readonly doc: string;
  readonly range: Bounds;
  /** Whether the case takes it: of two keys that say the same only the one that it has. */
  readonly settable?: boolean;
  readonly slider: { readonly from: number; readonly to: number; readonly scale: ScaleName };
  readonly label: string;
  readonly label_si: string;
}

/** A key that takes one of a few words. */
export interface Choice {
  readonly path: string;
  readonly section: string;
  readonly doc: string;
  readonly words: readonly string[];
  /** What the case says; another value than a word, such as a file, by its name. */
  readonly value: string;
}

export interface Session {
  readonly version: string;
  readonly title: string;
  readonly case: { readonly name: string; readonly file?: string; readonly model: string; readonly text: string } | null;
  readonly keys: readonly Key[];
  /** Keys of the case that take one of a few words. */
  readonly choices?: readonly Choice[];
  /** Values of the case as it was opened; null where it has no keys to move. */
  readonly values?: CaseValues | null;
  readonly map: { readonly x: KeyAxis; readonly y: KeyAxis } | null;
  readonly analyses: readonly { readonly name: string; readonly kind: string }[];
  /** What is said of the keys of each kind of analysis. */
  readonly settings?: Readonly<Record<string, { readonly doc: string; readonly keys: readonly Declaration[] }>>;
  readonly study: { readonly name: string } | null;
}

/** The key by which a case chooses its contact law, where it has one. */
export function lawOfCase({ choices }: Pick<Session, "choices">): Choice | undefined {
  return choices?.find(({ path }) => path === "contact.law");
}

export interface CaseValue {
  readonly path: string;
  readonly form: "group" | "si";
  readonly number: number;
  readonly si: number | null;
  readonly group: number | null;
}

export interface CaseValues {
  readonly values: readonly CaseValue[];
  readonly scales: Readonly<Record<string, number>>;
}

export type Pair = readonly [number, number];

/** The document of `judder point --json`. */
export interface PointDocument {
  readonly groups: Readonly<Record<string, number>>;
  readonly equilibrium: Readonly<Record<string, number>>;
  readonly contact: Readonly<Record<string, number>>;
  readonly eigenvalues: readonly Pair[];
  readonly growth_rate: number;
  /** The least and the greatest that the law has with its errors; null where these are not known. */
  readonly growth_rate_within_law: Pair | null;
  readonly verdict: string;
  /** Whether the law with its errors has other verdicts too; null where that is not known. */
  readonly marginal_within_law: boolean | null;
  readonly mechanism: string | null;
  readonly equivalent_damping: number | null;
  /** 0 for a formula, null where it is not known. */
  readonly equivalent_damping_error: number | null;
  readonly critical_shear_strength: readonly number[];
  /** The ranges in which the errors of the law leave the thresholds; null where these are not known. */
  readonly critical_shear_strength_within_law: readonly Pair[] | null;
  readonly critical_load: readonly number[];
  readonly critical_load_within_law: readonly Pair[] | null;
  readonly growth_shares: Readonly<Record<"damping" | "stiffness", readonly Pair[]>> | null;
  readonly warnings: readonly string[];
}

export interface Point {
  readonly point: PointDocument;
  readonly modes: readonly { readonly eigenvalue: Pair; readonly shape: readonly Pair[] }[];
  readonly dimensional: Readonly<Record<string, number | null>>;
}

/** A table of `[[analysis]]`. */
export type Analysis = Readonly<Record<string, unknown>> & { readonly name: string; readonly kind: string };

export const fetchSession = (signal?: AbortSignal) => getJson<Session>("/api/session", signal);
export const fetchCase = (set: readonly string[], signal?: AbortSignal) =>
  postJson<CaseValues>("/api/case", { set }, signal);
export const fetchPoint = (set: readonly string[], signal?: AbortSignal) =>
  postJson<Point>("/api/point", { set }, signal);

/** The text of the case file of a view. */
export const fetchCaseFile = (set: readonly string[], analysis: Analysis | null, model?: string | undefined) =>
  postText("/api/export", { set, analysis, ...(model ? { model } : {}) });
