/**
 * Colours by meaning: one role is the same colour, dash and marker in every picture, here and in the reports
 * (`judder-report`, palette.rs). Areas are apart in lightness too, lines in dash and marker: all of it is legible in grey.
 */

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
}

export type LineRole =
  | "full-boundary"
  | "conservative-boundary"
  | "decoupled-boundary"
  | "reference"
  | { readonly series: number }
  | { readonly mode: number }
  | { readonly graded: number; readonly of: number };

/** Okabe and Ito's colours in the order in which they are handed out; the black one is white in the dark. */
const QUALITATIVE: Record<Theme, readonly string[]> = {
  light: ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#000000"],
  dark: ["#56a5e0", "#f0803c", "#2fc79b", "#dd97bd", "#8fd0f5", "#f0b93a", "#ffffff"],
};
const DASHES: readonly Dash[] = ["solid", "dashed", "dash-dotted", "dotted"];
const MARKERS: readonly Marker[] = ["circle", "square", "diamond", "triangle", "cross"];

/** Inks of frames and texts. */
export const INK: Record<Theme, { ink: string; quiet: string; grid: string; ground: string }> = {
  light: { ink: "#1a1a1a", quiet: "#6b6b6b", grid: "#e3e3e3", ground: "#ffffff" },
  dark: { ink: "#ececec", quiet: "#a8a8a8", grid: "#34383d", ground: "#16191d" },
};

/** Light areas between curves would glare in the dark. */
export const AREA_OPACITY: Record<Theme, number> = { light: 1, dark: 0.45 };

/** Whether a colour is so dark that strokes over it have to be light. */
export function isDark([red, green, blue]: Rgb): boolean {
  return 0.299 * red + 0.587 * green + 0.114 * blue < 115;
}

export function lineStyle(role: LineRole, theme: Theme): LineStyle {
  const solid = { dash: "solid", marker: "circle", width: 1.6 } as const;
  const { ink, quiet } = INK[theme];
  const black = theme === "light" ? "#000000" : "#ffffff";
  if (role === "full-boundary") return { ...solid, colour: black };
  if (role === "conservative-boundary") return { ...solid, colour: black, dash: "dashed" };
  if (role === "decoupled-boundary") return { ...solid, colour: theme === "light" ? "#c8102e" : "#ff6b7d" };
  if (role === "reference") return { colour: quiet, dash: "dotted", marker: "circle", width: 1 };
  if ("graded" in role) {
    const share = role.graded / Math.max(role.of - 1, 1);
    // the ends of viridis that are too close to the ground are left out
    const fraction = theme === "light" ? 0.82 * share : 0.3 + 0.7 * share;
    return { ...solid, colour: hex(colourAt("sequential", fraction)), marker: cycle(MARKERS, role.graded) };
  }
  const index = "series" in role ? role.series : role.mode;
  const colour = cycle(QUALITATIVE[theme], index) ?? ink;
  return { colour, dash: cycle(DASHES, index), marker: cycle(MARKERS, index), width: 1.6 };
}

function cycle<T>(list: readonly T[], index: number): T {
  return list[((index % list.length) + list.length) % list.length] as T;
}

/** Lengths of strokes and gaps in widths of the line. */
export const DASH_PATTERN: Record<Dash, readonly number[]> = {
  solid: [],
  dashed: [4.5, 2.5],
  "dash-dotted": [6, 2.2, 1.2, 2.2],
  dotted: [1.2, 2],
};

/** Classes of a stability map, by their codes. */
export interface StabilityClass extends AreaStyle {
  readonly name: string;
  /** Whether the pattern is drawn even where none is asked for: an area without a verdict is never plain. */
  readonly always?: boolean;
}

export const STABILITY: readonly StabilityClass[] = [
  { name: "stable", colour: "#f3f3ef", pattern: "none", letter: "S" },
  { name: "flutter", colour: "#5b90c4", pattern: "rising", letter: "F" },
  { name: "negative damping", colour: "#eeab55", pattern: "falling", letter: "N" },
  { name: "both", colour: "#6a4682", pattern: "crossed", letter: "B" },
  { name: "normal-force coupling", colour: "#efdc8f", pattern: "dots", letter: "C" },
  { name: "marginal", colour: "#6b6b6b", pattern: "level", letter: "M" },
  { name: "unresolved", colour: "#8c8c8c", pattern: "upright", letter: "?", always: true },
  { name: "destabilised by damping", colour: "#6fb09a", pattern: "grid", letter: "D" },
];

/** Where the errors of the contact law decide, in the place of a class. */
export const WITHIN_LAW: StabilityClass = { name: "marginal within the law", colour: "#dfdfe6", pattern: "crossed", letter: "L", always: true };

/** Contact states of a motion, by their codes; slip is the plain ground. */
export const CONTACT_STATES: readonly StabilityClass[] = [
  { name: "stick", colour: "#b9d9b2", pattern: "rising", letter: "K" },
  { name: "slip", colour: "none", pattern: "none", letter: "S" },
  { name: "slip ahead", colour: "#d89fc1", pattern: "crossed", letter: "A" },
  { name: "lift-off", colour: "#dde9f7", pattern: "dots", letter: "L" },
];

export type ColourMap = "sequential" | "diverging";
export type Rgb = readonly [number, number, number];

const STOPS: Record<ColourMap, readonly Rgb[]> = {
  sequential: [
    [0x44, 0x01, 0x54],
    [0x47, 0x2d, 0x7b],
    [0x3b, 0x52, 0x8b],
    [0x2c, 0x72, 0x8e],
    [0x21, 0x91, 0x8c],
    [0x28, 0xae, 0x80],
    [0x5e, 0xc9, 0x62],
    [0xad, 0xdc, 0x30],
    [0xfd, 0xe7, 0x25],
  ],
  diverging: [
    [0x21, 0x66, 0xac],
    [0x43, 0x93, 0xc3],
    [0x92, 0xc5, 0xde],
    [0xd1, 0xe5, 0xf0],
    [0xf7, 0xf7, 0xf7],
    [0xfd, 0xdb, 0xc7],
    [0xf4, 0xa5, 0x82],
    [0xd6, 0x60, 0x4d],
    [0xb2, 0x18, 0x2b],
  ],
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

export function hex(colour: Rgb): string {
  return `#${colour.map((channel) => channel.toString(16).padStart(2, "0")).join("")}`;
}

export function rgb(colour: string): Rgb {
  const number = Number.parseInt(colour.slice(1), 16);
  return [(number >> 16) & 255, (number >> 8) & 255, number & 255];
}
