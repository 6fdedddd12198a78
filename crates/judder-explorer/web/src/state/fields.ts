/** Fields of addresses: texts that are read and written. */

import type { KeyAxis, ScaleName } from "../wire/api";
import type { Accepts } from "./view";

/** `a,b`: two numbers. */
export function parsePair(text: string | undefined): readonly [number, number] | undefined {
  const parts = text?.split(",") ?? [];
  const numbers = parts.map((part) => (part.trim() === "" ? Number.NaN : Number(part)));
  const [a, b] = numbers;
  return numbers.length === 2 && a !== undefined && b !== undefined && numbers.every(Number.isFinite) ? [a, b] : undefined;
}

/** `key~from~to~scale`; a plain number is the group, anything else a text with a unit. */
export function parseAxis(text: string | undefined): KeyAxis | undefined {
  const [key, from, to, scale, ...rest] = text?.split("~") ?? [];
  if (!key || !from || !to || rest.length > 0 || (scale !== "log" && scale !== "linear")) return undefined;
  return { key, from: numberOrText(from), to: numberOrText(to), scale: scale satisfies ScaleName };
}

/** Ends of different units cannot be compared here. */
function isReversed({ from, to }: KeyAxis): boolean {
  const parts = (end: number | string) => /^([-+\d.eE]*)\s*(.*)$/.exec(String(end)) ?? ["", "", ""];
  const [[, low, unit], [, high, other]] = [parts(from), parts(to)];
  return unit === other && Number(low) >= Number(high);
}

export function writeAxis(axis: KeyAxis): string {
  return [axis.key, axis.from, axis.to, axis.scale].join("~");
}

/** A number where the text is one, as in a case file. */
export function numberOrText(text: string): number | string {
  const number = Number(text);
  return text.trim() !== "" && Number.isFinite(number) ? number : text.trim();
}

/** `a,b,c`: words of a given list, each once; the empty text is the empty list. */
export function parseWords<T extends string>(text: string | undefined, allowed: readonly T[]): readonly T[] | undefined {
  if (text === undefined) return undefined;
  const words = text === "" ? [] : text.split(",");
  return words.every((word) => (allowed as readonly string[]).includes(word)) ? ([...new Set(words)] as T[]) : undefined;
}

export const anyText: Accepts = (text) => text.length <= 200;
export const anyNumber: Accepts = (text) => text.trim() !== "" && Number.isFinite(Number(text));
/** A number above zero. */
export const anyPositive: Accepts = (text) => anyNumber(text) && Number(text) > 0;
export const anyShare: Accepts = (text) => anyNumber(text) && Number(text) >= 0 && Number(text) <= 1;
export const anyPair: Accepts = (text) => parsePair(text) !== undefined;
/** Two numbers above zero, the smaller first: a range of a logarithmic axis. */
export const anyLogRange: Accepts = (text) => {
  const [from, to] = parsePair(text) ?? [0, 0];
  return from > 0 && from < to;
};
/** An axis from a smaller to a larger value, as far as that can be seen without the server. */
export const anyAxis: Accepts = (text) => {
  const axis = parseAxis(text);
  return axis !== undefined && !isReversed(axis);
};
export const words = (allowed: readonly string[]): Accepts => (text) => parseWords(text, allowed) !== undefined;

/** One word of a given list. */
export const oneOf = (allowed: readonly string[]): Accepts => (text) => allowed.includes(text);

/** `name:from:to,…`: ranges of named axes, each once, with `from` below `to`. */
export function parseRanges(text: string | undefined): Readonly<Record<string, readonly [number, number]>> | undefined {
  const ranges: Record<string, readonly [number, number]> = {};
  for (const part of text ? text.split(",") : []) {
    const [name, from, to, ...rest] = part.split(":");
    const [low, high] = [from, to].map((end) => (end ? Number(end) : Number.NaN)) as [number, number];
    if (!name || rest.length > 0 || !(low < high) || !Number.isFinite(low) || !Number.isFinite(high) || Object.hasOwn(ranges, name)) return undefined;
    ranges[name] = [low, high];
  }
  return ranges;
}

export const anyRanges: Accepts = (text) => text.length <= 2000 && parseRanges(text) !== undefined;

/** The boundaries of a map, and what it can show on top of the mechanisms. */
export const BOUNDARIES = ["full", "conservative", "decoupled"] as const;
export const OVERLAYS = [...BOUNDARIES, "critical"] as const;

/** The parts of the contact page; only the one that is shown is computed. */
export const CONTACT_PARTS = ["material", "law", "fit", "solution"] as const;
export const QUANTITIES = ["force", "area", "friction"] as const;

/** What the point page computes when it is asked to. */
export const RUNS = ["motion", "cycle", "branch"] as const;
