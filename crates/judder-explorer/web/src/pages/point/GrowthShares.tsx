/** Which entry of the matrices feeds the growth: bars with their numbers. */

import { Digits } from "../../ui/Digits";
import { Label } from "../../ui/Label";
import type { PointDocument } from "../../wire/api";

type Shares = NonNullable<PointDocument["growth_shares"]>;

const MATRICES = ["damping", "stiffness"] as const;
const SIDES = ["x", "y"] as const;

export function GrowthShares({ shares }: { readonly shares: Shares | null }) {
  if (!shares) return null;
  const rows = MATRICES.flatMap((matrix) =>
    SIDES.flatMap((row, i) => SIDES.map((column, j) => ({ matrix, row, column, key: `growth_shares.${matrix}.${i}.${j}`, value: shares[matrix][i]?.[j] ?? 0 }))),
  );
  const largest = Math.max(...rows.map((row) => Math.abs(row.value)), 1e-300);
  return (
    <div class="shares">
      <h3>Shares of the growth rate</h3>
      <p class="note">They add up to it: to the right an entry feeds the growth, to the left it takes from it.</p>
      <ul>
        {rows.map(({ matrix, row, column, key, value }) => (
          <li key={key}>
            <span class="share-name">
              {matrix} <Label text={`$${matrix === "damping" ? "c" : "k"}_{${row}${column}}$`} />
            </span>
            <span class="share-bar" aria-hidden="true">
              <span class={value < 0 ? "share-takes" : "share-feeds"} style={barPlace(value / largest)} />
            </span>
            <span class="share-number">
              <Digits dataKey={key} value={value} />
            </span>
          </li>
        ))}
      </ul>
    </div>
  );
}

/** A bar from the middle to its share of half the width. */
function barPlace(share: number): { left: string; width: string } {
  const width = 50 * Math.abs(share);
  return { left: `${share < 0 ? 50 - width : 50}%`, width: `${width}%` };
}
