/** Maps of a chart on a canvas, exact to the device pixel. */

import { useLayoutEffect, useRef } from "preact/hooks";
import type { Frame } from "./frame";
import { pixelsOf } from "./raster";
import { type ChartSpec, type RasterLayer, isRaster } from "./spec";

/** What the pixels of a map depend on: the layer around it is made anew for every curve that comes. */
function contents(layer: RasterLayer): readonly unknown[] {
  const data = layer.kind === "classes" ? [layer.codes, layer.hatched] : [layer.values, layer.colours, layer.scale, layer.range];
  return [layer.x, layer.y, ...data];
}

export function RasterView({ spec, frame }: { readonly spec: ChartSpec; readonly frame: Frame }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const rasters = spec.layers.filter(isRaster);
  const detail = globalThis.devicePixelRatio || 1;
  const [width, height] = [Math.max(1, Math.round(frame.width * detail)), Math.max(1, Math.round(frame.height * detail))];
  const { left, top, window } = frame;
  const [xScale, yScale] = [spec.x.scale, spec.y.scale];
  useLayoutEffect(() => {
    const context = canvas.current?.getContext("2d");
    if (!context) return;
    context.clearRect(0, 0, width, height);
    rasters.forEach((layer, index) => {
      const image = new ImageData(pixelsOf(layer, { x: xScale, y: yScale }, window, width, height, detail), width, height);
      if (index === 0) return context.putImageData(image, 0, 0);
      // putImageData would wipe out what lies below
      const over = new OffscreenCanvas(width, height);
      over.getContext("2d")?.putImageData(image, 0, 0);
      context.drawImage(over, 0, 0);
    });
  }, [...rasters.flatMap(contents), rasters.length, width, height, window.x[0], window.x[1], window.y[0], window.y[1], xScale, yScale]);
  const place = { left: `${left}px`, top: `${top}px`, width: `${frame.width}px`, height: `${frame.height}px` };
  return <canvas ref={canvas} class="chart-raster" width={width} height={height} style={place} aria-hidden="true" />;
}
