/** Pixels of maps: every device pixel takes the colour of the cell whose centre is nearest on the axes' own measure. */

import { type AreaStyle, type Pattern, type Rgb, colourAt, isDark, rgb } from "./palette";
import { type Range, type Scale, type Window, fraction, rangeOf, stretch, valueAt } from "./scale";
import type { ClassesLayer, RasterLayer, ValuesLayer } from "./spec";

export interface Scales {
  readonly x: Scale;
  readonly y: Scale;
}

/** The column (or row) that every pixel of an axis shows, −1 outside of the data. */
export function cellsOf(centres: ArrayLike<number>, scale: Scale, range: Range, pixels: number): Int32Array {
  const cells = new Int32Array(pixels).fill(-1);
  const count = centres.length;
  if (count === 0) return cells;
  // a single cell has no width of its own
  if (count === 1) return cells.fill(0);
  const at = Float64Array.from(centres, (centre) => stretch(scale, centre));
  // the outer cells reach as far out as in
  const half = (from: number, to: number) => ((at[to] as number) - (at[from] as number)) / 2;
  const [first, last] = [(at[0] as number) - half(0, 1), (at[count - 1] as number) + half(count - 2, count - 1)];
  let cell = 0;
  for (let pixel = 0; pixel < pixels; pixel += 1) {
    const value = stretch(scale, valueAt(scale, range, (pixel + 0.5) / pixels));
    // a hair's width is forgiven: ends of a window have been rounded
    const hair = 1e-6 * Math.max(last - first, 1e-300);
    if (!(value >= first - hair && value <= last + hair)) continue;
    while (cell + 1 < count && value > ((at[cell] as number) + (at[cell + 1] as number)) / 2) cell += 1;
    cells[pixel] = cell;
  }
  return cells;
}

/** Whether a stroke of the pattern runs through this pixel; `size` is the number of device pixels of one pixel of the page. */
function strokes(pattern: Pattern, x: number, y: number, size: number): boolean {
  const every = (place: number, period: number, width: number) => ((place / size) % period + period) % period < width;
  switch (pattern) {
    case "none":
      return false;
    case "rising":
      return every(x + y, 9, 1.3);
    case "falling":
      return every(x - y, 9, 1.3);
    case "crossed":
      return every(x + y, 10, 1.3) || every(x - y, 10, 1.3);
    case "dots":
      return every(x, 7, 2) && every(y, 7, 2);
    case "level":
      return every(y, 6, 1.3);
    case "upright":
      return every(x, 5, 1.3);
    case "grid":
      return every(x, 9, 1.3) || every(y, 9, 1.3);
  }
}

/** Strokes are darker than a light area and lighter than a dark one, where they have no colour of their own. */
function strokeColour({ colour, stroke }: AreaStyle): Rgb {
  if (stroke) return rgb(stroke);
  const area = rgb(colour);
  const dark = isDark(area);
  const mix = (channel: number) => Math.round(dark ? channel + 0.55 * (255 - channel) : 0.55 * channel);
  return [mix(area[0]), mix(area[1]), mix(area[2])];
}

const pack = ([red, green, blue]: Rgb) => ((255 << 24) | (blue << 16) | (green << 8) | red) >>> 0;

/** RGBA pixels of a map over a window, the first row at the top. */
export function pixelsOf(
  layer: RasterLayer,
  scales: Scales,
  window: Window,
  width: number,
  height: number,
  size = 1,
): Uint8ClampedArray<ArrayBuffer> {
  const pixels = new Uint32Array(width * height);
  const columns = cellsOf(layer.x, scales.x, window.x, width);
  const rows = cellsOf(layer.y, scales.y, window.y, height).reverse();
  if (layer.kind === "classes") paintClasses(layer, pixels, columns, rows, size);
  else paintValues(layer, pixels, columns, rows, size);
  return new Uint8ClampedArray(pixels.buffer);
}

/** Whether a row of pixels shows the same cells as the one above it: a coarse map is mostly copied. */
function repeats(rows: Int32Array, row: number): boolean {
  return row > 0 && rows[row] === rows[row - 1];
}

/** Copies the row before; the place after it. */
function copyRow(pixels: Uint32Array, at: number, width: number): number {
  pixels.copyWithin(at, at - width, at);
  return at + width;
}

function paintClasses(layer: ClassesLayer, pixels: Uint32Array, columns: Int32Array, rows: Int32Array, size: number): void {
  const colours = layer.classes.map((area) => (area.colour === "none" ? 0 : pack(rgb(area.colour))));
  const inks = layer.classes.map((area) => (area.colour === "none" ? 0 : pack(strokeColour(area))));
  const patterns = layer.classes.map((area) => (layer.hatched || area.always ? area.pattern : "none"));
  const plain = patterns.every((pattern) => pattern === "none" || pattern === "upright");
  const stride = layer.x.length;
  for (let row = 0, at = 0; row < rows.length; row += 1) {
    const from = (rows[row] as number) * stride;
    if (plain && repeats(rows, row)) {
      at = copyRow(pixels, at, columns.length);
      continue;
    }
    for (let column = 0; column < columns.length; column += 1, at += 1) {
      const cell = columns[column] as number;
      if (from < 0 || cell < 0) continue;
      const code = layer.codes[from + cell] as number;
      const pattern = patterns[code] ?? "none";
      const stroke = pattern !== "none" && strokes(pattern, column, row, size);
      pixels[at] = (stroke ? inks[code] : colours[code]) ?? 0;
    }
  }
}

const STEPS = 256;

function paintValues(layer: ValuesLayer, pixels: Uint32Array, columns: Int32Array, rows: Int32Array, size: number): void {
  const range = valueRange(layer);
  const colours = Uint32Array.from({ length: STEPS }, (_, step) => pack(colourAt(layer.colours, step / (STEPS - 1))));
  const of = (value: number) => {
    const share = fraction(layer.scale, range, value);
    return Number.isNaN(share) ? 0 : (colours[Math.round(Math.min(Math.max(share, 0), 1) * (STEPS - 1))] as number);
  };
  const cells = Uint32Array.from({ length: layer.values.length }, (_, index) => of(layer.values[index] as number));
  // no colour of a value is 0
  const gaps = layer.gaps && cells.includes(0) ? gapPaint(layer.gaps, size) : undefined;
  const stride = layer.x.length;
  for (let row = 0, at = 0; row < rows.length; row += 1) {
    const from = (rows[row] as number) * stride;
    if (!gaps && repeats(rows, row)) {
      at = copyRow(pixels, at, columns.length);
      continue;
    }
    for (let column = 0; column < columns.length; column += 1, at += 1) {
      const cell = columns[column] as number;
      if (from >= 0 && cell >= 0) pixels[at] = cells[from + cell] || (gaps?.(column, row) ?? 0);
    }
  }
}

/** The pixels of cells without a value. */
function gapPaint(style: AreaStyle, size: number): (column: number, row: number) => number {
  const [ground, ink] = [pack(rgb(style.colour)), pack(strokeColour(style))];
  return (column, row) => (strokes(style.pattern, column, row, size) ? ink : ground);
}

/** The range of a map of values; symmetric about zero for diverging colours. */
export function valueRange(layer: ValuesLayer): Range {
  if (layer.range) return layer.range;
  const range = rangeOf(layer.scale, [layer.values]);
  const most = Math.max(Math.abs(range[0]), Math.abs(range[1]));
  return layer.colours === "diverging" ? [-most, most] : range;
}

/** A place for the letter of each class that is shown: the middle of its largest square, in fractions of the plot from its top left. */
export function letterPlaces(layer: ClassesLayer, scales: Scales, window: Window): { code: number; x: number; y: number }[] {
  const [width, height] = [72, 48];
  const columns = cellsOf(layer.x, scales.x, window.x, width);
  const rows = cellsOf(layer.y, scales.y, window.y, height).reverse();
  const codeAt = (x: number, y: number) =>
    (rows[y] as number) < 0 || (columns[x] as number) < 0
      ? -1
      : (layer.codes[(rows[y] as number) * layer.x.length + (columns[x] as number)] as number);
  const side = new Int32Array(width * height);
  const best = new Map<number, { side: number; x: number; y: number }>();
  for (let y = 0; y < height; y += 1) {
    for (let x = 0; x < width; x += 1) {
      const code = codeAt(x, y);
      const same = x > 0 && y > 0 && [codeAt(x - 1, y), codeAt(x, y - 1), codeAt(x - 1, y - 1)].every((other) => other === code);
      const before = (dx: number, dy: number) => side[(y - dy) * width + x - dx] as number;
      const here = same ? 1 + Math.min(before(1, 0), before(0, 1), before(1, 1)) : 1;
      side[y * width + x] = here;
      if (code >= 0 && here > (best.get(code)?.side ?? 2)) best.set(code, { side: here, x, y });
    }
  }
  return [...best].map(([code, { side, x, y }]) => ({
    code,
    x: (x + 1 - side / 2) / width,
    y: (y + 1 - side / 2) / height,
  }));
}
