/** The legend: what the layers mean, in rows above the plot. */

import { AREA_OPACITY, DASH_PATTERN, INK, type AreaStyle, type LineStyle, type Theme, isDark, lineStyle, rgb } from "./palette";
import { markerShape, patternOver } from "./marks";
import { widthOf } from "./markup";
import { type Shape, round, shape } from "./scene";
import { type ChartSpec, type Layer, isRaster } from "./spec";
import { SMALL_SIZE, label } from "./text";

export const ROW = 21;
export const KEY = 24;
const GAP = 16;

export interface Entry {
  readonly text: string;
  readonly area?: AreaStyle;
  readonly hatched?: boolean;
  /** Whether the area hides the ground, as those of maps do. */
  readonly opaque?: boolean;
  readonly line?: LineStyle;
  readonly hasLine?: boolean;
  readonly hasMarker?: boolean;
  readonly hollow?: boolean;
  /** Whether the line lies over coloured areas, which are light in both themes. */
  readonly overAreas?: boolean;
}

/** Entries of layers, each text once, with the samples of all that have it. */
export function legendEntries({ layers }: Pick<ChartSpec, "layers">, theme: Theme): readonly Entry[] {
  const overAreas = layers.some(isRaster);
  const merged = new Map<string, Entry>();
  for (const entry of layers.flatMap((layer) => entriesOf(layer, theme, overAreas))) {
    const known = merged.get(entry.text);
    merged.set(entry.text, known ? joined(known, entry) : entry);
  }
  return [...merged.values()];
}

function joined(known: Entry, other: Entry): Entry {
  const all = { ...other, ...known };
  return { ...all, hasLine: known.hasLine === true || other.hasLine === true, hasMarker: known.hasMarker === true || other.hasMarker === true };
}

function entriesOf(layer: Layer, theme: Theme, overAreas: boolean): Entry[] {
  if (layer.kind === "classes") {
    const present = new Set(layer.codes);
    return layer.classes.flatMap((area, code) =>
      present.has(code)
        ? [{ text: `${layer.letters ? `${area.letter}: ` : ""}${area.legend ?? area.name}`, area, opaque: true, hatched: layer.hatched === true || area.always === true }]
        : [],
    );
  }
  if (layer.label === "" || layer.kind === "values" || layer.kind === "note") return [];
  if (layer.kind === "bands" || layer.kind === "area" || layer.kind === "region") return [{ text: layer.label, area: layer.style, hatched: true }];
  const style = lineStyle(layer.role, overAreas ? "light" : theme);
  const width = layer.kind === "line" && layer.width ? { width: layer.width } : {};
  const line = { ...style, ...width, ...(layer.kind === "line" && layer.dash ? { dash: layer.dash } : {}), ...(layer.kind === "points" && layer.marker ? { marker: layer.marker } : {}) };
  return [
    {
      text: layer.label,
      line,
      hasLine: layer.kind !== "points",
      hasMarker: layer.kind === "points" || (layer.kind === "line" && layer.marked === true),
      hollow: layer.kind === "points" && layer.hollow === true,
      overAreas,
    },
  ];
}

const lengthOf = (entry: Entry) => KEY + 6 + widthOf(entry.text) * SMALL_SIZE + GAP;

/** Entries in rows that fit. */
export function legendRows(entries: readonly Entry[], width: number): readonly (readonly Entry[])[] {
  const rows: Entry[][] = [];
  let room = 0;
  for (const entry of entries) {
    const length = lengthOf(entry);
    if (rows.length === 0 || room < length) {
      rows.push([]);
      room = width - 16;
    }
    rows.at(-1)?.push(entry);
    room -= length;
  }
  return rows;
}

export function drawLegend(entries: readonly Entry[], width: number, theme: Theme, prefix: string): Shape[] {
  const { ink } = INK[theme];
  return legendRows(entries, width).flatMap((row, index) => {
    const middle = 6 + ROW * (index + 0.5);
    let left = 8;
    return row.flatMap((entry) => {
      const at = round(left);
      left += lengthOf(entry);
      return [...drawKey(entry, at, middle, theme, prefix), label(entry.text, { x: at + KEY + 6, y: middle + 4, size: SMALL_SIZE, colour: ink })];
    });
  });
}

export function drawKey(entry: Entry, left: number, middle: number, theme: Theme, prefix: string): Shape[] {
  const area = entry.area ? drawAreaKey(entry.area, entry, left, middle, theme, prefix) : [];
  const style = entry.line;
  if (!style) return area;
  const ground = shape("rect", { x: left, y: round(middle - 6), width: KEY, height: 12, fill: INK.light.ground });
  const line = shape("line", {
    x1: left,
    x2: left + KEY,
    y1: middle,
    y2: middle,
    stroke: style.colour,
    "stroke-width": style.width,
    "stroke-dasharray": DASH_PATTERN[style.dash].map((length) => round(length * style.width)).join(" "),
  });
  const marker = markerShape(style, left + KEY / 2, middle, 8, entry.hollow === true);
  return [...area, ...(entry.overAreas && theme === "dark" ? [ground] : []), ...(entry.hasLine ? [line] : []), ...(entry.hasMarker ? [marker] : [])];
}

function drawAreaKey(area: AreaStyle, entry: Entry, left: number, middle: number, theme: Theme, prefix: string): Shape[] {
  const box = { x: left, y: round(middle - 6), width: KEY, height: 12, stroke: INK[theme].ink, "stroke-width": 0.6 };
  const light = entry.opaque ? isDark(rgb(area.colour)) : theme === "dark";
  const over = entry.hatched ? patternOver(area, prefix, light ? "light" : "dark") : undefined;
  const ground = shape("rect", { ...box, fill: area.colour, "fill-opacity": entry.opaque ? 1 : AREA_OPACITY[theme] });
  return over ? [ground, shape("rect", { ...box, fill: over })] : [ground];
}
