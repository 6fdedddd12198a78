/** What the greys of bodies and the marks of contact points mean. */

import { type Theme, INK, bodyGrey, hex, shade } from "../../chart/palette";
import type { Body } from "./body";
import type { Marks } from "./marks";

interface BodyNamesProps {
  readonly body: Body;
  readonly marks: Marks | null;
  readonly theme: Theme;
}

export function BodyNames({ body: { parts }, marks, theme }: BodyNamesProps) {
  if (parts.length === 0 && !marks) return null;
  const ring = { fill: "none", stroke: INK[theme].ink, "stroke-width": 2 };
  return (
    <ul class="body-names" aria-label="What is shown">
      {parts.map((name, k) => (
        <li key={name}>
          <svg width={22} height={12} aria-hidden="true">
            <line x1={0} x2={22} y1={6} y2={6} stroke={hex(bodyGrey(k, parts.length, theme))} stroke-width={3} />
          </svg>
          {name}
        </li>
      ))}
      {marks && (
        <li>
          <svg width={12} height={12} aria-hidden="true">
            <circle cx={6} cy={6} r={5} fill={hex(shade(0.6, theme))} />
          </svg>
          closed contact point
        </li>
      )}
      {marks?.open.includes(true) && (
        <li>
          <svg width={12} height={12} aria-hidden="true">
            <circle cx={6} cy={6} r={4.5} {...ring} />
          </svg>
          open contact point
        </li>
      )}
    </ul>
  );
}
