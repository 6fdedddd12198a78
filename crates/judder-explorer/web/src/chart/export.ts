/** Exports of charts: SVG, PNG and CSV, always in light colours. */

import { chartCsv } from "./csv";
import { draw } from "./draw";
import type { Figure } from "./exports";
import type { Size } from "./frame";
import { INK } from "./palette";
import { pixelsOf } from "./raster";
import type { Window } from "./scale";
import { markupOf, round, shape } from "./scene";
import { type ChartSpec, isRaster } from "./spec";

const RASTER_DETAIL = 2;

/** The data of a chart within a window, where it is not what is drawn. */
export type DataOf = (window: Window) => string | Promise<string>;

/** A chart as the export menu takes it. */
export function chartFigure(spec: ChartSpec, window: Window, size: Size, dataOf: DataOf = () => chartCsv(spec)): Figure {
  return { size, svg: () => chartSvg(spec, window, size), csv: () => dataOf(window) };
}

/** The picture as a file of its own; rasters are embedded PNG images (`encode` makes them, tests give their own). */
export async function chartSvg(spec: ChartSpec, window: Window, size: Size, encode = encodePng): Promise<string> {
  const { frame, definitions, under, over } = draw(spec, window, size, "light", "judder");
  const [width, height] = [Math.max(1, Math.round(frame.width * RASTER_DETAIL)), Math.max(1, Math.round(frame.height * RASTER_DETAIL))];
  const images = await Promise.all(
    spec.layers.filter(isRaster).map(async (layer) => {
      const pixels = pixelsOf(layer, { x: spec.x.scale, y: spec.y.scale }, frame.window, width, height, RASTER_DETAIL);
      return shape("image", {
        x: round(frame.left),
        y: round(frame.top),
        width: round(frame.width),
        height: round(frame.height),
        preserveAspectRatio: "none",
        href: await encode(pixels, width, height),
      });
    }),
  );
  const ground = shape("rect", { width: size.width, height: size.height, fill: INK.light.ground });
  const picture = shape(
    "svg",
    {
      xmlns: "http://www.w3.org/2000/svg",
      width: size.width,
      height: size.height,
      viewBox: `0 0 ${size.width} ${size.height}`,
      role: "img",
      "aria-label": spec.title,
    },
    shape("title", {}, spec.title),
    ...definitions,
    ground,
    ...under,
    ...images,
    ...over,
  );
  return `<?xml version="1.0" encoding="UTF-8"?>\n${markupOf(picture)}\n`;
}

/** Pixels as the address of a PNG. */
async function encodePng(pixels: Uint8ClampedArray<ArrayBuffer>, width: number, height: number): Promise<string> {
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [width, height];
  canvas.getContext("2d")?.putImageData(new ImageData(pixels, width, height), 0, 0);
  return canvas.toDataURL("image/png");
}

/** The picture in twice as many pixels. */
export async function pngOf({ svg, size }: Figure): Promise<Blob> {
  const address = URL.createObjectURL(new Blob([await svg()], { type: "image/svg+xml" }));
  try {
    const image = new Image();
    image.src = address;
    await image.decode();
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [2 * size.width, 2 * size.height];
    canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height);
    return await new Promise((resolve, reject) =>
      canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("the picture could not be encoded"))), "image/png"),
    );
  } finally {
    URL.revokeObjectURL(address);
  }
}
