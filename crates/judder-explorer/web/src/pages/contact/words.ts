/** Numbers and names of the contact page, in the markup of labels. */

import type { Quantity } from "./state";

export const QUANTITY_NAMES: Record<Quantity, string> = {
  force: "Force",
  area: "Area",
  friction: "Viscoelastic friction",
};

export const QUANTITY_LABELS: Record<Quantity, string> = {
  force: "Force $F$/($E_{0}^{*}$ $R^{2}$) (−)",
  area: "Area $A$/$R^{2}$ (−)",
  friction: "Friction $μ_{visc}$ (−)",
};

export const SPEED_LABEL = "Speed $v τ$/$R$ (−)";
export const DEPTH_LABEL = "Indentation $δ$/$R$ (−)";

/** A number to three digits, with a power of ten where it is long. */
export function shortNumber(value: number): string {
  if (!Number.isFinite(value)) return "—";
  const rounded = Number(value.toPrecision(3));
  if (rounded === 0 || (Math.abs(rounded) >= 1e-3 && Math.abs(rounded) < 1e5)) return String(rounded).replace("-", "−");
  const [mantissa = "", power = ""] = rounded.toExponential().split("e");
  const tens = `10^{${power.replace("+", "").replace("-", "−")}}`;
  return (mantissa === "1" ? tens : `${mantissa}×${tens}`).replace(/^-/, "−");
}
