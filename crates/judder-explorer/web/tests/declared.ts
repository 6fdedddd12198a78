/** What the server declares of some settings, cut short. */

import type { Bounds, Choice, Declaration, Form } from "../src/wire/api";
import { pageFields } from "../src/state/pages";

const key = (name: string, form: Form, of: unknown = null): Declaration => ({ name, doc: `what ${name} is.`, symbol: "", required: false, default: of, words: "a value", form });
export const number = (name: string, range: Bounds, of: unknown, units: { group?: string | null; unit?: string | null } = {}) =>
  key(name, { kind: "number", group: "", unit: null, range, ...units }, of);
export const whole = (name: string, from: number, of: unknown) => key(name, { kind: "whole", range: { from } }, of);
const table = (name: string, keys: readonly Declaration[], of: unknown = null) => key(name, { kind: "table", keys }, of);
const choice = (name: string, ...words: readonly string[]) => key(name, { kind: "choice", words: words.map((word) => ({ word, doc: "" })) }, words[0]);

const start = table("start", [number("disturbance", {}, null), number("x", {}, null)], { disturbance: 0.2 });
const duration = number("duration", { above: 0 }, 2000, { group: "ω_nx t", unit: "s" });
const span = (name: string) => table(name, [number("from", { above: 0 }, null), number("to", { above: 0 }, null), whole("points", 2, 51)]);

export const settings = {
  motion: { doc: "", keys: [start, duration, whole("points", 16, 4096), number("tolerance", { above: 1e-14, to: 1e-2 }, 1e-8)] },
  "limit-cycle": { doc: "", keys: [start, number("tolerance", { above: 1e-14, to: 1e-2 }, 1e-10)] },
  bifurcation: { doc: "", keys: [table("sweep", [key("key", { kind: "text" }), whole("points", 2, null)]), choice("direction", "both", "forward"), start, key("branches", { kind: "flag" }, false)] },
  contact: { doc: "", keys: [number("velocity", { from: 0 }, null), number("accuracy", { above: 0, to: 0.2 }, 1e-3), key("cells", { kind: "other" })] },
  "contact-law": { doc: "", keys: [span("velocity"), choice("method", "collapse", "sweep")] },
  fit: { doc: "", keys: [span("velocity"), number("accuracy", { above: 0, to: 0.2 }, 1e-2), number("velocity_scale", { above: 0 }, 0.01)] },
};

const law: Choice = { path: "contact.law", section: "contact", doc: "", words: ["hertz", "bem"], value: "hertz" };
export const PAGE_FIELDS = pageFields({ settings, choices: [law] });
