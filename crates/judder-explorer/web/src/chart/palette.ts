/**
 * Colours by meaning: one role is the same colour, dash and marker in every picture, here and in drawings, whose palette `MEANINGS` is. What
 * else the page needs stands here: colours in the dark, strokes and letters. Areas are apart in lightness too, lines in dash and marker: all
 * of it is legible in grey.
 */

import { MEANINGS } from "./meanings";

export type Theme = "light" | "dark";
export type Dash = "solid" | "dashed" | "dash-dotted" | "dotted";
export type Marker = "circle" | "square" | "diamond" | "triangle" | "cross";
/** Strokes over an area, for reading without colour. */
export type Pattern = "none" | "rising" | "falling" | "crossed" | "dots" | "level" | "upright" | "grid";

export interface LineStyle {
  readonly colour: string;
  readonly dash: Dash;
  readonly marker: Marker;
  readonly width: number;
}

export interface AreaStyle {
  readonly colour: string;
  readonly pattern: Pattern;
  /** One letter that stands for the area where it is asked for. */
  readonly letter: string;
  /** Of the strokes; left out, what the colour bears. */
  readonly stroke?: string;
}

export type LineRole =
  | "full-boundary"
  | "conservative-boundary"
  | "decoupled-boundary"
  | "reference"
  | { readonly series: number }
  | { readonly mode: number }
  | { readonly graded: number; readonly of: number }
  | { readonly body: number; readonly of: number };

/** Handed out in this order; the black one is white in the dark. */
const QUALITATIVE: Record<Theme, readonly string[]> = {
  light: MEANINGS.series.colours,
  dark: ["#56a5e0", "#f0803c", "#2fc79b", "#dd97bd", "#8fd0f5", "#f0b93a", "#ffffff"],
};

/** Widths are in points. */
export const PIXELS_PER_POINT = 4 / 3;

/** Inks of frames and texts. */
export const INK: Record<Theme, { ink: string; quiet: string; grid: string; ground: string }> = {
  light: { ink: MEANINGS.ink, quiet: MEANINGS.quiet, grid: "#e3e3e3", ground: MEANINGS.ground },
  dark: { ink: "#ececec", quiet: "#a8a8a8", grid: "#34383d", ground: "#16191d" },
};

/** Light areas between curves would glare in the dark. */
export const AREA_OPACITY: Record<Theme, number> = { light: 1, dark: 0.45 };

/** Whether a colour is so dark that strokes over it have to be light. */
export function isDark([red, green, blue]: Rgb): boolean {
  return 0.299 * red + 0.587 * green + 0.114 * blue < 115;
}

export function lineStyle(role: LineRole, theme: Theme): LineStyle {
  const { series, graded, lines } = MEANINGS;
  if (typeof role === "string") {
    const { colour, dash, marker, width } = lines[role];
    return { colour: theme === "light" ? colour : DARK_LINES[role], dash, marker, width: PIXELS_PER_POINT * width };
  }
  if ("graded" in role) {
    const share = role.graded / Math.max(role.of - 1, 1);
    return { colour: hex(shade(share, theme)), dash: "solid", marker: cycle(series.markers, role.graded), width: PIXELS_PER_POINT * graded.width };
  }
  if ("body" in role) {
    return { colour: hex(bodyGrey(role.body, role.of, theme)), dash: "solid", marker: "circle", width: PIXELS_PER_POINT * graded.width };
  }
  const index = "series" in role ? role.series : role.mode;
  const colour = cycle(QUALITATIVE[theme], index);
  return { colour, dash: cycle(series.dashes, index), marker: cycle(series.markers, index), width: PIXELS_PER_POINT * series.width };
}

const DARK_LINES: Record<keyof typeof MEANINGS.lines, string> = {
  "full-boundary": "#ffffff",
  "conservative-boundary": "#ffffff",
  "decoupled-boundary": "#ff6b7d",
  reference: "#a8a8a8",
};

function cycle<T>(list: readonly T[], index: number): T {
  return list[((index % list.length) + list.length) % list.length] as T;
}

/** Lengths of strokes and gaps in widths of the line. */
export const DASH_PATTERN: Record<Dash, readonly number[]> = MEANINGS.dashes;

const AREAS = MEANINGS.areas;

/** What a code stands for, as an area. */
export interface AreaClass extends AreaStyle {
  readonly name: string;
  /** Whether the pattern is drawn even where none is asked for: an area without a verdict is never plain. */
  readonly always?: boolean;
}

const UNRESOLVED: AreaClass = { name: "unresolved", colour: AREAS.unresolved, pattern: "upright", letter: "?", always: true };

/** Mechanisms of a stability map and contact states of a motion, by the words that codes stand for; slip is the plain ground. */
const CLASSES: Readonly<Record<string, AreaClass>> = {
  stable: { name: "stable", colour: AREAS.stable, pattern: "none", letter: "S" },
  flutter: { name: "flutter", colour: AREAS.flutter, pattern: "rising", letter: "F" },
  "negative-damping": { name: "negative damping", colour: AREAS["negative-damping"], pattern: "falling", letter: "N" },
  both: { name: "both", colour: AREAS.both, pattern: "crossed", letter: "B" },
  "normal-force-coupling": { name: "normal-force coupling", colour: AREAS["normal-force-coupling"], pattern: "dots", letter: "C" },
  marginal: { name: "marginal", colour: MEANINGS.lines.reference.colour, pattern: "level", letter: "M" },
  unresolved: UNRESOLVED,
  "destabilised-by-damping": { name: "destabilised by damping", colour: AREAS["destabilised-by-damping"], pattern: "grid", letter: "D" },
  // where the errors of the contact law decide, in the place of a class
  "marginal within the law": { name: "marginal within the law", colour: AREAS["within-law"], pattern: "crossed", letter: "L", always: true },
  stick: { name: "stick", colour: AREAS.stick, pattern: "rising", letter: "K" },
  slip: { name: "slip", colour: "none", pattern: "none", letter: "S" },
  "slip ahead": { name: "slip ahead", colour: AREAS["slip-ahead"], pattern: "crossed", letter: "A" },
  "lift-off": { name: "lift-off", colour: AREAS["lift-off"], pattern: "dots", letter: "L" },
};

/** The class that such a word means; one that is not known is unresolved. */
export function classOf(word: string): AreaClass {
  return CLASSES[word] ?? UNRESOLVED;
}

/** Where along a parameter something is unstable. */
export const UNSTABLE_ZONE: AreaStyle = { colour: AREAS["unstable-zone"], pattern: "rising", letter: "U" };

export type ColourMap = "sequential" | "diverging";
export type Rgb = readonly [number, number, number];

const STOPS: Record<ColourMap, readonly Rgb[]> = {
  sequential: MEANINGS.stops.sequential.map(rgb),
  diverging: MEANINGS.stops.diverging.map(rgb),
};

/** The colour at a fraction of the range; outside it the end colours, for NaN the lower one. */
export function colourAt(map: ColourMap, fraction: number): Rgb {
  const stops = STOPS[map];
  const place = (Number.isNaN(fraction) ? 0 : Math.min(Math.max(fraction, 0), 1)) * (stops.length - 1);
  const below = Math.min(Math.floor(place), stops.length - 2);
  const [a, b] = [stops[below] as Rgb, stops[below + 1] as Rgb];
  const mix = (i: 0 | 1 | 2) => Math.round(a[i] + (b[i] - a[i]) * (place - below));
  return [mix(0), mix(1), mix(2)];
}

/** The colour at a share of what is graded: the end of viridis that is too close to the ground is left out. */
export function shade(share: number, theme: Theme): Rgb {
  return colourAt("sequential", theme === "light" ? MEANINGS.graded.end * share : 0.3 + 0.7 * share);
}

/** How much of the ground is in the greys of bodies, from the first to the last. */
const GREYS = [0.05, 0.5] as const;

/** The grey of one of several bodies, colours being what is told of them; of a single one that of quiet words. */
export function bodyGrey(index: number, of: number, theme: Theme): Rgb {
  const { ink, ground, quiet } = INK[theme];
  if (of < 2) return rgb(quiet);
  const share = GREYS[0] + ((GREYS[1] - GREYS[0]) * index) / (of - 1);
  const [a, b] = [rgb(ink), rgb(ground)];
  const mix = (i: 0 | 1 | 2) => Math.round(a[i] + (b[i] - a[i]) * share);
  return [mix(0), mix(1), mix(2)];
}

export function hex(colour: Rgb): string {
  return `#${colour.map((channel) => channel.toString(16).padStart(2, "0")).join("")}`;
}

export function rgb(colour: string): Rgb {
  const number = Number.parseInt(colour.slice(1), 16);
  return [(number >> 16) & 255, (number >> 8) & 255, number & 255];
}
