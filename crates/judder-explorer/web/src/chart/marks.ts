/** Markers of points and patterns of areas, as SVG. */

import { symbol, symbolCircle, symbolCross, symbolDiamond, symbolSquare, symbolTriangle } from "d3-shape";
import { INK, type AreaStyle, type LineStyle, type Marker, type Pattern } from "./palette";
import { type Shape, round, shape } from "./scene";

const SYMBOLS: Record<Marker, typeof symbolCircle> = {
  circle: symbolCircle,
  square: symbolSquare,
  diamond: symbolDiamond,
  triangle: symbolTriangle,
  cross: symbolCross,
};

/** The outline of a marker of this diameter about the origin. */
export function markerPath(marker: Marker, size: number): string {
  return symbol(SYMBOLS[marker], (Math.PI / 4) * size * size).digits(2)() ?? "";
}

export function markerShape(style: LineStyle, x: number, y: number, size: number, hollow: boolean): Shape {
  return shape("path", {
    d: markerPath(style.marker, size),
    transform: `translate(${round(x)} ${round(y)})`,
    fill: hollow ? "none" : style.colour,
    stroke: style.colour,
    "stroke-width": hollow ? 1.5 : 0.5,
  });
}

const STROKES: Record<Exclude<Pattern, "none">, string> = {
  rising: "M-2 10L10 -2M-2 2L2 -2M6 10L10 6",
  falling: "M-2 -2L10 10M6 -2L10 2M-2 6L2 10",
  crossed: "M-2 10L10 -2M-2 -2L10 10",
  dots: "M3 4H5",
  level: "M0 4H8",
  upright: "M4 0V8",
  grid: "M0 4H8M4 0V8",
};

/** The ink of a pattern: that of the theme over areas that the ground shines through, otherwise one that the area's colour bears. */
export type PatternInk = "dark" | "light";

const INKS: Record<PatternInk, string> = { dark: INK.light.ink, light: INK.dark.ink };

/** The definitions of all patterns. */
export function patternShapes(prefix: string): Shape[] {
  return (["dark", "light"] as const).flatMap((ink) => patternsIn(prefix, ink));
}

function patternsIn(prefix: string, ink: PatternInk): Shape[] {
  return Object.entries(STROKES).map(([name, path]) =>
    shape(
      "pattern",
      { id: `${prefix}-${ink}-${name}`, width: 8, height: 8, patternUnits: "userSpaceOnUse" },
      shape("path", { d: path, stroke: INKS[ink], "stroke-width": name === "dots" ? 2 : 1, fill: "none", "stroke-opacity": 0.55 }),
    ),
  );
}

/** What fills an area on top of its colour. */
export function patternOver(style: AreaStyle, prefix: string, ink: PatternInk): string | undefined {
  return style.pattern === "none" ? undefined : `url(#${prefix}-${ink}-${style.pattern})`;
}
