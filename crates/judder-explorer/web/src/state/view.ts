/** The state of a view and its address: `/page?set=key=value&…&field=text`. */

export const PAGES = ["map", "point", "contact", "structures"] as const;
export type Page = (typeof PAGES)[number];

export interface View {
  readonly page: Page;
  /** `--set` options on top of the case: key to text, in the order in which they were first set. */
  readonly set: Readonly<Record<string, string>>;
  /** What the page itself keeps, as texts; see `fields.ts`. */
  readonly fields: Readonly<Record<string, string>>;
}

/** Whether a text is a value of this field of a page. */
export type Accepts = (text: string) => boolean;
/** The fields that pages know. */
export type PageFields = Readonly<Record<Page, Readonly<Record<string, Accepts>>>>;

export interface Parsed {
  readonly view: View;
  /** What was dropped, and why: shown once. */
  readonly told: readonly string[];
}

/** A key as a case file writes it, with items of lists by name or number. */
const KEY = /^[A-Za-z_][\w-]*(\.[\w-]+|\[[^\]]+\])*$/;
const LONGEST = 4096;

export function parseView(path: string, query: string, known: PageFields, start: Page = "map"): Parsed {
  const told: string[] = [];
  const name = path.replace(/^\/+|\/+$/g, "");
  const page = PAGES.find((page) => page === name) ?? start;
  if (name !== "" && page !== name) told.push(`There is no page “${name}”.`);
  const set: Record<string, string> = {};
  const fields: Record<string, string> = {};
  for (const [field, text] of new URLSearchParams(query)) {
    if (field === "set") {
      const option = parseOption(text);
      if (option) set[option[0]] = option[1];
      else told.push(`“set=${shorten(text)}” of the address is no option: it would be set=key=value.`);
    } else if (!Object.hasOwn(known[page], field)) {
      told.push(`“${shorten(field)}” of the address means nothing on this page.`);
    } else if (known[page][field]?.(text)) {
      fields[field] = text;
    } else {
      told.push(`“${field}=${shorten(text)}” of the address cannot be read.`);
    }
  }
  return { view: { page, set, fields }, told };
}

/** Key and text of `key=value`. */
function parseOption(text: string): [string, string] | undefined {
  const sign = text.indexOf("=");
  const [key, value] = [text.slice(0, sign).trim(), text.slice(sign + 1).trim()];
  return sign > 0 && KEY.test(key) && value !== "" && value.length <= LONGEST ? [key, value] : undefined;
}

function shorten(text: string): string {
  return text.length > 40 ? `${text.slice(0, 40)}…` : text;
}

/** Drops options on keys that the case does not have. */
export function keepKnownKeys(view: View, known: ReadonlySet<string>): Parsed {
  const entries = Object.entries(view.set);
  const kept = entries.filter(([key]) => known.has(key));
  if (kept.length === entries.length) return { view, told: [] };
  const told = entries.filter(([key]) => !known.has(key)).map(([key]) => `The case has no key “${shorten(key)}”.`);
  return { view: { ...view, set: Object.fromEntries(kept) }, told };
}

/** The address of a view; equal views have equal addresses. */
export function writeView(view: View): string {
  const query: string[] = Object.entries(view.set).map(([key, text]) => `set=${escape(`${key}=${text}`)}`);
  const fields = Object.entries(view.fields).sort(([a], [b]) => (a < b ? -1 : 1));
  query.push(...fields.map(([field, text]) => `${escape(field)}=${escape(text)}`));
  return `/${view.page}${query.length > 0 ? `?${query.join("&")}` : ""}`;
}

/** Percent-encodes what would end a value, and leaves the rest legible. */
function escape(text: string): string {
  return encodeURIComponent(text).replace(/%(3D|2C|3A|2F|5B|5D)/g, (code) => decodeURIComponent(code));
}

/** The options of a view as the server takes them. */
export function options(view: View): string[] {
  return Object.entries(view.set).map(([key, text]) => `${key}=${text}`);
}

export function withOption(view: View, key: string, text: string | undefined): View {
  const set: Record<string, string> = { ...view.set };
  if (text === undefined) delete set[key];
  else set[key] = text;
  return { ...view, set };
}

export function withFields(view: View, change: Readonly<Record<string, string | undefined>>): View {
  const fields: Record<string, string> = { ...view.fields };
  for (const [field, text] of Object.entries(change)) {
    if (text === undefined) delete fields[field];
    else fields[field] = text;
  }
  return { ...view, fields };
}
