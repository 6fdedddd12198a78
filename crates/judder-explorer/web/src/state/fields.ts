/** Fields of addresses: texts that are read and written, and what each page keeps. */

import type { KeyAxis, ScaleName } from "../wire/api";
import type { Accepts, PageFields } from "./view";

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
/** As many points as span a range. */
export const anyCount: Accepts = (text) => Number.isInteger(Number(text)) && Number(text) > 1;
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

/** What the map can show on top of the mechanisms. */
export const OVERLAYS = ["full", "conservative", "decoupled", "critical"] as const;

/** The parts of the contact page; only the one that is shown is computed. */
export const CONTACT_PARTS = ["material", "law", "fit", "solution"] as const;
export const QUANTITIES = ["force", "area", "friction"] as const;
export const LAW_NAMES = ["oscillator-paper", "oscillator-paper-corrected", "hertz", "bem"] as const;
/** Relative accuracies, as case files write them. */
export const CONTACT_ACCURACIES = ["1e-2", "3e-3", "1e-3", "3e-4"] as const;
export const FIT_ACCURACIES = ["3e-2", "1e-2", "3e-3"] as const;
export const VELOCITY_SCALES = ["0.01", "1"] as const;

/** What the point page computes when it is asked to. */
export const RUNS = ["motion", "cycle", "branch"] as const;

/** What can be heard: of the modes there are as many as an oscillator has eigenvalues. */
const SOUNDS = ["motion", "cycle", "mode-1", "mode-2", "mode-3", "mode-4"] as const;

/** Every page's fields: a page that keeps more adds them here. */
export const PAGE_FIELDS: PageFields = {
  map: {
    x: anyAxis,
    y: anyAxis,
    show: words(OVERLAYS),
    cursor: anyPair,
    pin: anyPair,
    marks: words(["hatch", "letters"]),
  },
  point: {
    along: anyText,
    trail: words(["off"]),
    still: words(["on"]),
    run: words(RUNS),
    live: words(["on"]),
    duration: anyText,
    start: anyNumber,
    points: anyCount,
    branch: anyAxis,
    steps: anyCount,
    simulated: words(["on"]),
    sound: oneOf(SOUNDS),
    factor: anyPositive,
    volume: anyShare,
  },
  contact: {
    part: oneOf(CONTACT_PARTS),
    quantity: oneOf(QUANTITIES),
    speeds: anyLogRange,
    depths: anyLogRange,
    cursor: anyPair,
    compare: oneOf(LAW_NAMES),
    fit_accuracy: oneOf(FIT_ACCURACIES),
    velocity_scale: oneOf(VELOCITY_SCALES),
    velocity: anyText,
    indentation: anyText,
    load: anyText,
    accuracy: oneOf(CONTACT_ACCURACIES),
  },
  structures: {
    analysis: anyText,
    at: anyNumber,
    mode: anyNumber,
    look: anyPair,
    scale: anyNumber,
    phase: anyNumber,
    zoom: anyRanges,
    signals: anyText,
    over: words(["time", "position"]),
  },
};
