/** The settings of analyses that pages offer, from what is declared of them: their fields in an address, and the tables that they make. */

import type { Analysis, Bounds, Declaration, Session } from "../wire/api";
import { numberOrText } from "./fields";
import type { Accepts } from "./view";

/** A key of an analysis with one value: a number, a word or a mark. */
export interface Setting extends Declaration {
  /** Its name, behind those of the tables that it stands in. */
  readonly path: string;
  /** Its field in an address. */
  readonly field: string;
}

export type Declared = NonNullable<Session["settings"]>;
type Fields = Readonly<Record<string, string>>;

/** What pages move themselves: axes, windows of charts, the operating point. */
const OWN: Readonly<Record<string, readonly string[]>> = {
  bifurcation: ["sweep.key", "sweep.from", "sweep.to", "sweep.scale", "branches"],
  contact: ["velocity", "indentation", "load"],
  "contact-law": ["velocity", "indentation"],
  fit: ["velocity", "indentation"],
};

/** What is asked for at first, where what a case takes by itself would keep a page waiting or is not known. */
const FIRST: Readonly<Record<string, Fields>> = {
  motion: { duration: "500" },
  bifurcation: { "sweep.points": "21" },
  contact: { accuracy: "1e-2" },
};

/** Settings whose fields have names of their own; all others are called by their kind and path. */
const FIELDS: Fields = {
  "motion/duration": "duration",
  "motion/points": "points",
  "motion/start.disturbance": "start",
  "limit-cycle/start.disturbance": "start",
  "bifurcation/start.disturbance": "start",
  "bifurcation/sweep.points": "steps",
  "contact/accuracy": "accuracy",
  "fit/accuracy": "fit_accuracy",
  "fit/velocity_scale": "velocity_scale",
};

const SINGLE: readonly string[] = ["number", "whole", "flag", "choice", "other"];

/** The settings of a kind of analysis that a page offers. */
export function settingsOf(declared: Declared | undefined, kind: string): readonly Setting[] {
  const isOwn = (path: string) => (OWN[kind] ?? []).some((own) => path === own || path.startsWith(`${own}.`));
  // a table that is left out has a default of its own
  const within = (keys: readonly Declaration[], before: string, whole: unknown): readonly Setting[] =>
    keys.flatMap((key) => {
      const path = before + key.name;
      const standard = key.default ?? (whole as Record<string, unknown> | null)?.[key.name] ?? null;
      if (key.form.kind === "table") return within(key.form.keys, `${path}.`, standard);
      return SINGLE.includes(key.form.kind) && !isOwn(path) ? [{ ...key, default: standard, path, field: FIELDS[`${kind}/${path}`] ?? `${kind}.${path}` }] : [];
    });
  return within(declared?.[kind]?.keys ?? [], "", null);
}

/** The fields of the settings of some kinds of analyses. */
export function fieldsOf(declared: Declared | undefined, kinds: readonly string[]): Readonly<Record<string, Accepts>> {
  return Object.fromEntries(kinds.flatMap((kind) => settingsOf(declared, kind)).map((setting) => [setting.field, (text: string) => accepts(setting, text)]));
}

function lies({ from, above, to, below }: Bounds, number: number): boolean {
  return !(number < (from ?? number) || number <= (above ?? Number.NEGATIVE_INFINITY) || number > (to ?? number) || number >= (below ?? Number.POSITIVE_INFINITY));
}

/** Whether a key may have the value that a text says, as far as that can be seen without the server: it alone reads units. */
export function accepts({ form }: Pick<Declaration, "form">, text: string): boolean {
  const number = text.trim() === "" ? Number.NaN : Number(text);
  switch (form.kind) {
    case "number":
      return Number.isFinite(number) ? form.group !== null && lies(form.range, number) : form.unit !== null && text.length <= 200 && /\d/.test(text);
    case "whole":
      return Number.isInteger(number) && lies(form.range, number);
    case "flag":
      return text === "true" || text === "false";
    case "choice":
      return form.words.some(({ word }) => word === text);
    default:
      return text.trim() !== "" && text.length <= 200;
  }
}

/** What a setting says: as the address has it, as a page asks for it at first, or as a case takes it by itself. */
export function textOf(kind: string, setting: Setting, fields: Fields): string {
  return fields[setting.field] ?? FIRST[kind]?.[setting.path] ?? String(setting.default ?? "");
}

/** An analysis with the settings that an address or the page gives; what they leave out a case takes by itself. */
export function analysisOf(declared: Declared | undefined, kind: string, fields: Fields, name = kind): Analysis {
  const analysis: Record<string, unknown> = { name, kind };
  for (const { path, field, form } of settingsOf(declared, kind)) {
    const text = fields[field] ?? FIRST[kind]?.[path];
    if (text === undefined) continue;
    const steps = path.split(".");
    const last = steps.pop() as string;
    const table = steps.reduce((table, step) => (table[step] ??= {}) as Record<string, unknown>, analysis);
    table[last] = form.kind === "flag" ? text === "true" : form.kind === "choice" ? text : numberOrText(text);
  }
  return analysis as Analysis;
}
