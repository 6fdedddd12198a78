/** Which entry of the matrices feeds the growth: bars with their numbers. */

import { Label } from "../../ui/Label";
import { ShareBars } from "../../ui/ShareBars";
import type { PointDocument } from "../../wire/api";

type Shares = NonNullable<PointDocument["growth_shares"]>;

const MATRICES = ["damping", "stiffness"] as const;
const SIDES = ["x", "y"] as const;

export function GrowthShares({ shares }: { readonly shares: Shares | null }) {
  if (!shares) return null;
  const rows = MATRICES.flatMap((matrix) =>
    SIDES.flatMap((row, i) => SIDES.map((column, j) => ({ key: `growth_shares.${matrix}.${i}.${j}`, name: <Entry matrix={matrix} at={row + column} />, value: shares[matrix][i]?.[j] ?? 0 }))),
  );
  return (
    <div>
      <h3>Shares of the growth rate</h3>
      <p class="note">They add up to it: to the right an entry feeds the growth, to the left it takes from it.</p>
      <ShareBars rows={rows} />
    </div>
  );
}

function Entry({ matrix, at }: { readonly matrix: (typeof MATRICES)[number]; readonly at: string }) {
  return (
    <>
      {matrix} <Label text={`$${matrix === "damping" ? "c" : "k"}_{${at}}$`} />
    </>
  );
}
