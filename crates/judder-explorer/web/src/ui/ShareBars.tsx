/** Parts of a sum as bars from the middle, each with its number. */

import type { ComponentChildren } from "preact";
import { Digits } from "./Digits";

interface Share {
  /** The path of the number in the document it comes from. */
  readonly key: string;
  readonly name: ComponentChildren;
  readonly value: number;
}

export function ShareBars({ rows }: { readonly rows: readonly Share[] }) {
  const largest = Math.max(...rows.map((row) => Math.abs(row.value)), 1e-300);
  return (
    <ul class="shares">
      {rows.map(({ key, name, value }) => (
        <li key={key}>
          <span class="share-name">{name}</span>
          <span class="share-bar" aria-hidden="true">
            <span class={value < 0 ? "share-takes" : "share-feeds"} style={barPlace(value / largest)} />
          </span>
          <span class="share-number">
            <Digits dataKey={key} value={value} />
          </span>
        </li>
      ))}
    </ul>
  );
}

/** A bar from the middle to its share of half the width. */
function barPlace(share: number): { left: string; width: string } {
  const width = 50 * Math.abs(share);
  return { left: `${share < 0 ? 50 - width : 50}%`, width: `${width}%` };
}
