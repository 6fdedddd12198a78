/** One operating point in numbers: groups and units. */

import { useMemo } from "preact/hooks";
import type { Pair, Point, PointDocument } from "../wire/api";
import { Value } from "./Value";
import { Warnings } from "./Warnings";

/** The eigenvalue that grows fastest. */
export function leading(point: PointDocument): Pair {
  return point.eigenvalues.reduce((best, one) => (one[0] > best[0] || (one[0] === best[0] && one[1] > best[1]) ? one : best), [
    Number.NEGATIVE_INFINITY,
    0,
  ] as Pair);
}

/** What the errors of the law leave of the verdict, in words; the verdict beside it is the nominal one. */
function withinLaw({ marginal_within_law }: Pick<PointDocument, "marginal_within_law">): string {
  if (marginal_within_law === null) return "not known";
  return marginal_within_law ? "marginal: its errors decide" : "the same";
}

/** How far the errors of the law leave the numbers of stability. */
function LawErrors({ point }: { readonly point: PointDocument }) {
  const rates = point.growth_rate_within_law;
  return (
    <>
      <Value name="equivalent damping, ±" dataKey="equivalent_damping_error" value={point.equivalent_damping_error} />
      <Value name="growth rate, at least" dataKey="growth_rate_within_law.0" value={rates?.[0]} />
      <Value name="growth rate, at most" dataKey="growth_rate_within_law.1" value={rates?.[1]} />
    </>
  );
}

interface PointValuesProps {
  readonly point: Point;
  /** Whether the shares of the growth rate are listed: not where a page shows them its own way. */
  readonly shares?: boolean;
}

/** Drawn once a point, however often what is around it moves. */
export function PointValues({ point, shares = true }: PointValuesProps) {
  return useMemo(() => <Numbers point={point} shares={shares} />, [point, shares]);
}

function Numbers({ point: { point, dimensional }, shares }: Required<PointValuesProps>) {
  const { equilibrium, contact } = point;
  return (
    <div class="point-values">
      <h3>Stability</h3>
      <dl class="values">
        <Value name="verdict" dataKey="verdict" value={point.verdict} />
        {point.equivalent_damping_error !== 0 && <Value name="within the law" dataKey="marginal_within_law" value={withinLaw(point)} />}
        <Value name="mechanism" dataKey="mechanism" value={point.mechanism} />
        <Value name="growth rate max Re $λ$/$ω_{nx}$" dataKey="growth_rate" value={point.growth_rate} />
        <Value name="growth rate" dataKey="dimensional.growth_rate_per_s" value={dimensional["growth_rate_per_s"]} unit="1/s" />
        <Value name="frequency $ω$/$ω_{nx}$" dataKey="frequency" value={Math.abs(leading(point)[1])} />
        <Value name="frequency" dataKey="dimensional.frequency_hz" value={dimensional["frequency_hz"]} unit="Hz" />
        <Value name="equivalent damping" dataKey="equivalent_damping" value={point.equivalent_damping} />
        {point.equivalent_damping_error !== 0 && <LawErrors point={point} />}
      </dl>
      {shares && point.growth_shares && <Shares shares={point.growth_shares} />}
      <h3>Equilibrium</h3>
      <dl class="values">
        <Value name="$x$/$x_{0}$" dataKey="equilibrium.x" value={equilibrium["x"]} />
        <Value name="$x$" dataKey="dimensional.x_m" value={dimensional["x_m"]} unit="m" />
        <Value name="$y$/$x_{0}$" dataKey="equilibrium.y" value={equilibrium["y"]} />
        <Value name="$y$" dataKey="dimensional.y_m" value={dimensional["y_m"]} unit="m" />
        <Value name="indentation $y$/$R$" dataKey="equilibrium.indentation" value={equilibrium["indentation"]} />
        <Value name="indentation" dataKey="dimensional.indentation_m" value={dimensional["indentation_m"]} unit="m" />
        <Value name="contact force $F$/($E_{0}$* $R$²)" dataKey="contact.force" value={contact["force"]} />
        <Value name="contact force" dataKey="dimensional.force_n" value={dimensional["force_n"]} unit="N" />
        <Value name="contact area $A$/$R$²" dataKey="contact.area" value={contact["area"]} />
        <Value name="contact area" dataKey="dimensional.area_m2" value={dimensional["area_m2"]} unit="m²" />
        <Value name="viscoelastic friction" dataKey="contact.viscoelastic_friction" value={contact["viscoelastic_friction"]} />
      </dl>
      <h3>Operating point</h3>
      <dl class="values">
        {GROUPS.flatMap(([group, name, withUnit, unit]) => [
          <Value key={group} name={name} dataKey={`groups.${group}`} value={point.groups[group]} />,
          <Value key={withUnit} name={group.replace("_", " ")} dataKey={`dimensional.${withUnit}`} value={dimensional[withUnit]} unit={unit} />,
        ])}
      </dl>
      <Warnings warnings={point.warnings} />
    </div>
  );
}

/** Groups of the operating point, and the same with units. */
const GROUPS = [
  ["velocity", "velocity $v_{d}$ $τ$/$R$", "velocity_m_per_s", "m/s"],
  ["normal_load", "normal load $F_{n}$/($E_{0}$* $R$²)", "normal_load_n", "N"],
  ["shear_strength", "shear strength $τ_{0}$/$E_{0}$*", "shear_strength_pa", "Pa"],
] as const;

const SIDES = ["x", "y"] as const;

/** What each entry of the matrices gives to the growth rate. */
function Shares({ shares }: { readonly shares: NonNullable<PointDocument["growth_shares"]> }) {
  return (
    <>
      <h3>Shares of the growth rate</h3>
      <dl class="values">
        {(["damping", "stiffness"] as const).flatMap((matrix) =>
          SIDES.flatMap((row, i) =>
            SIDES.map((column, j) => (
              <Value
                key={`${matrix}${row}${column}`}
                name={`${matrix} $${matrix === "damping" ? "c" : "k"}_{${row}${column}}$`}
                dataKey={`growth_shares.${matrix}.${i}.${j}`}
                value={shares[matrix][i]?.[j]}
              />
            )),
          ),
        )}
      </dl>
    </>
  );
}
