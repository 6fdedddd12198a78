/** A whole chart as a tree of SVG elements. */

import { drawAxes, drawGround, onPaper, withPower } from "./axes";
import { visible } from "./decimate";
import { type Frame, type Size, frameOf } from "./frame";
import { drawLayer, drawLetters, drawRim, drawWords } from "./layers";
import { drawLegend, legendEntries } from "./legend";
import { patternShapes } from "./marks";
import { INK, type Theme, colourAt, hex } from "./palette";
import { valueRange } from "./raster";
import { type Window, fraction } from "./scale";
import { type Shape, round, shape } from "./scene";
import { type ChartSpec, type Layer, type PointsLayer, type ValuesLayer, isRaster } from "./spec";
import { SMALL_SIZE, LABEL_SIZE, label } from "./text";
import { ticks } from "./ticks";

export interface Scene {
  readonly frame: Frame;
  /** Definitions, what lies under the rasters, and what lies over them. */
  readonly definitions: readonly Shape[];
  readonly under: readonly Shape[];
  readonly over: readonly Shape[];
}

export function draw(spec: ChartSpec, window: Window, size: Size, theme: Theme, prefix: string): Scene {
  const entries = spec.explained ? [] : legendEntries(spec, theme);
  const frame = frameOf(spec, window, size, entries);
  const { ink } = INK[theme];
  const overAreas = spec.layers.some(isRaster);
  const clip = `${prefix}-plot`;
  const drawing = { spec, frame, theme, prefix, overAreas };
  const { left, top, width, height } = frame;
  const below = (kind: string) => kind === "bands" || kind === "area" || kind === "region";
  const clipped = (shapes: readonly Shape[]) => shape("g", { "clip-path": `url(#${clip})` }, ...shapes);
  const layers = (under: boolean) =>
    spec.layers
      .filter((layer) => below(layer.kind) === under)
      .flatMap(withMarkers)
      .flatMap((layer) => (layer.kind === "points" ? drawLayer(sparse(layer, frame), drawing) : [clipped(drawLayer(layer, drawing))]));
  const bars = spec.layers.filter((layer) => layer.kind === "values").slice(0, 1);
  const letters = spec.layers.flatMap((layer) => (layer.kind === "classes" && layer.letters ? drawLetters(layer, drawing) : []));
  return {
    frame,
    definitions: [
      shape(
        "defs",
        {},
        shape("clipPath", { id: clip }, shape("rect", { x: left, y: top, width, height })),
        ...patternShapes(prefix),
      ),
    ],
    under: [...layers(true), ...drawGround(spec, frame, theme)],
    over: [
      // all rims before all lines: no rim cuts a line
      clipped(spec.layers.flatMap((layer) => drawRim(layer, drawing))),
      ...layers(false),
      clipped(letters),
      ...drawAxes(spec, frame, theme),
      ...spec.layers.flatMap((layer) => drawWords(layer, drawing)),
      ...drawLegend(entries, size.width, theme, prefix),
      ...bars.flatMap((layer) => drawBar(layer, frame, ink)),
    ],
  };
}

/** A line, and the points that it marks: markers at the ends of an axis reach over the frame, lines do not. */
function withMarkers(layer: Layer): Layer[] {
  if (layer.kind !== "line" || !layer.marked) return [layer];
  return [layer, { kind: "points", label: "", x: layer.x, y: layer.y, role: layer.role, size: 6 }];
}

/** A layer without the points that others hide. */
function sparse(layer: PointsLayer, frame: Frame): PointsLayer {
  if (layer.sizes) return layer;
  const kept = visible(Array.from(layer.x, frame.px), Array.from(layer.y, frame.py));
  if (kept.length === layer.x.length) return layer;
  return { ...layer, x: kept.map((i) => layer.x[i] as number), y: kept.map((i) => layer.y[i] as number) };
}

const BAR_STEPS = 64;

/** The bar that tells the colours of a map of values. */
function drawBar(layer: ValuesLayer, frame: Frame, ink: string): Shape[] {
  const range = valueRange(layer);
  const [left, width] = [frame.left + frame.width + 14, 12];
  const step = frame.height / BAR_STEPS;
  const steps = Array.from({ length: BAR_STEPS }, (_, index) =>
    shape("rect", {
      x: left,
      y: round(frame.top + frame.height - (index + 1) * step),
      width,
      height: round(step + 0.5),
      fill: hex(colourAt(layer.colours, (index + 0.5) / BAR_STEPS)),
    }),
  );
  const scaled = ticks(layer.scale, range, frame.height / 44);
  const at = (value: number) => frame.top + frame.height * (1 - fraction(layer.scale, range, value));
  const labels = scaled.major.map((tick) =>
    label(tick.label, { x: left + width + 4, y: at(tick.value) + 4, size: SMALL_SIZE, colour: ink }),
  );
  const title = withPower(layer.label, scaled.exponent);
  const place = { x: left + width + 52, y: onPaper(title, frame.top + frame.height / 2, frame.paper.height), size: LABEL_SIZE, colour: ink, anchor: "middle", turn: -90 } as const;
  return [...steps, ...labels, label(title, place)];
}
