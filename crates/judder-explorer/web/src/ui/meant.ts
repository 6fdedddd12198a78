/** What an error speaks of, in words of the page. */

import { type RequestError, allOf, isPassing } from "../wire/request";

/** The source of an option: it stands in its own field, and its line tells nothing. */
const OPTION = "--set";

/** Fields of pages that have other names than the keys of the case file that they become. */
const FIELDS: Readonly<Record<string, string>> = {
  "x.from": "From, x axis",
  "x.to": "To, x axis",
  "y.from": "From, y axis",
  "y.to": "To, y axis",
  velocity: "speed",
  indentation: "depth",
};

/** Where an error lies: a line of the user's own case file, or the field or key that is meant. */
export type Meant = { readonly line: number; readonly source: string; readonly text: string } | { readonly field: string; readonly text: string };

/** The key that a message names first. */
function keyIn(message: string): string | undefined {
  return /`([^`]+)`/.exec(message)?.[1];
}

/** Whether an error, or one beside it, speaks of the key at this path or of the table that it stands in. */
export function blames(error: RequestError | null, path: string): boolean {
  return allOf(error).some((one) => {
    const key = isPassing(one) ? undefined : keyIn(one.message);
    return key !== undefined && (key === path || path.startsWith(`${key}.`));
  });
}

/** The first error of each key that is blamed, and all others. */
export function byKey(error: RequestError | null, keys: readonly string[], set: Readonly<Record<string, string>>): { readonly blamed: ReadonlyMap<string, RequestError>; readonly others: readonly RequestError[] } {
  const blamed = new Map<string, RequestError>();
  const others = allOf(error).filter((one) => {
    const key = blamedKey(one, keys, set);
    if (key === undefined || blamed.has(key)) return true;
    blamed.set(key, one);
    return false;
  });
  return { blamed, others };
}

/** The key of the case that an error speaks of: named in it, or set by the option at whose text it points. */
export function blamedKey({ message, place }: RequestError, keys: readonly string[], set: Readonly<Record<string, string>>): string | undefined {
  const said = [message, place?.text ?? "", place?.source ?? ""].join(" ");
  const isAt = (key: string) => place?.source === OPTION && place.text === set[key] && place.column === key.length + 2;
  return keys.find((key) => said.includes(key)) ?? keys.find(isAt);
}

/**
 * The server reads a case that the page has composed, whose lines nobody has seen. A line is named only where the user's text has the
 * same at that place; elsewhere the key that the message names first.
 */
export function meant({ message, place }: RequestError, caseText: string | null): Meant | null {
  if (!place || place.source === OPTION) return null;
  const own = caseText?.split("\n")[place.line - 1];
  const isOwn = place.text !== "" && own?.slice(place.column - 1).startsWith(place.text);
  if (caseText === null || isOwn) return place;
  const key = keyIn(message);
  return key === undefined ? null : { field: FIELDS[key] ?? key, text: place.text };
}
