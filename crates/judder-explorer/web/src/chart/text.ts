/** Labels with their markup, as SVG texts. */

import { drawn, spanRise, spanSize, spans, undrawn } from "./markup";
import { type Shape, round, shape } from "./scene";

/** Families to ask for; the first one is bundled with the page. */
const FAMILIES = "Noto Sans, Open Sans, Segoe UI, DejaVu Sans, Arial, sans-serif";
export const LABEL_SIZE = 13;
export const SMALL_SIZE = 12;

export interface TextPlace {
  readonly x: number;
  readonly y: number;
  readonly size: number;
  readonly colour: string;
  readonly anchor?: "start" | "middle" | "end";
  /** Degrees, clockwise. */
  readonly turn?: number;
  /** A rim in this colour, for texts over areas. */
  readonly rim?: string;
  readonly bold?: boolean;
}

export function label(markup: string, place: TextPlace): Shape {
  let height = 0;
  const children = spans(drawn(markup)).map((span) => {
    const rise = spanRise(span.level) * place.size;
    const move = height - rise;
    height = rise;
    return shape(
      "tspan",
      {
        ...(move === 0 ? {} : { dy: round(move) }),
        ...(span.level === 0 ? {} : { "font-size": round(spanSize(span.level) * place.size) }),
        ...(span.italic ? { "font-style": "italic" } : {}),
      },
      span.text,
    );
  });
  const whole = undrawn(markup);
  const rim = place.rim ? { stroke: place.rim, "stroke-width": 3, "stroke-linejoin": "round", "paint-order": "stroke" } : {};
  return shape(
    "text",
    {
      x: round(place.x),
      y: round(place.y),
      fill: place.colour,
      "font-size": place.size,
      "font-family": FAMILIES,
      "text-anchor": place.anchor ?? "start",
      ...(place.bold ? { "font-weight": "bold" } : {}),
      ...(place.turn ? { transform: `rotate(${place.turn} ${round(place.x)} ${round(place.y)})` } : {}),
      ...rim,
    },
    ...(whole === undefined ? [] : [shape("title", {}, whole)]),
    ...children,
  );
}
