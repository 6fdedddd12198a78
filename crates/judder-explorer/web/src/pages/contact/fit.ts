/** The oscillator paper's three functions beside the computed points that they are fitted to. */

import type { ChartSpec, Layer } from "../../chart/spec";
import { type Frame, reals } from "../../wire/frames";
import { type Law, lawOf, rowOf, spread } from "./law";
import { type Outcome, numberAt, scalarAt } from "../../wire/outcome";
import type { Quantity } from "./state";
import { DEPTH_LABEL, QUANTITY_LABELS, QUANTITY_NAMES, SPEED_LABEL, shortNumber } from "./words";

export interface Fit {
  readonly computed: Law;
  readonly fitted: Law;
}

export function fitOf(frame: Frame): Fit {
  const computed = lawOf(frame);
  const values = {
    force: reals(frame, "fitted_force"),
    area: reals(frame, "fitted_area"),
    friction: reals(frame, "fitted_friction"),
  };
  return { computed, fitted: { ...computed, values } };
}

const CURVES = 4;

/** Points over lines, a marker and a shade for each depth. */
export function curvesSpec(fit: Fit | null, quantity: Quantity): ChartSpec {
  const layers: Layer[] = [];
  if (fit) {
    const { computed, fitted } = fit;
    const rows = spread(computed.indentation.length, CURVES);
    const x = computed.velocity;
    const name = (row: number) => `$δ$/$R$ = ${shortNumber(computed.indentation[row] as number)}`;
    const role = (index: number) => ({ graded: index, of: rows.length });
    rows.forEach((row, index) => layers.push({ kind: "line", label: `fit, ${name(row)}`, x, y: rowOf(fitted, quantity, row), role: role(index) }));
    rows.forEach((row, index) =>
      layers.push({ kind: "points", label: `computed, ${name(row)}`, x, y: rowOf(computed, quantity, row), role: role(index), size: 7 }),
    );
  }
  return {
    title: `${QUANTITY_NAMES[quantity]}: computed points and fit`,
    x: { label: SPEED_LABEL, name: "v τ/R", scale: "log" },
    y: { label: QUANTITY_LABELS[quantity], scale: quantity === "friction" ? "linear" : "log" },
    layers,
  };
}

/** Fit less computed, over the largest computed value at each depth. */
export function residuals({ computed, fitted }: Fit, quantity: Quantity): Float64Array {
  const columns = computed.velocity.length;
  const [points, fits] = [computed.values[quantity], fitted.values[quantity]];
  const largest = Array.from(computed.indentation, (_, row) => rowOf(computed, quantity, row).reduce((most, value) => Math.max(most, value), 0));
  return points.map((value, index) => ((fits[index] as number) - value) / (largest[Math.floor(index / columns)] as number));
}

export function residualSpec(fit: Fit | null, quantity: Quantity): ChartSpec {
  const map: Layer[] = fit
    ? [
        {
          kind: "values",
          label: "Fit − computed, over the largest (−)",
          x: fit.computed.velocity,
          y: fit.computed.indentation,
          values: residuals(fit, quantity),
          colours: "diverging",
          scale: "linear",
        },
      ]
    : [];
  return {
    title: `${QUANTITY_NAMES[quantity]}: residuals of the fit`,
    x: { label: SPEED_LABEL, name: "v τ/R", scale: "log" },
    y: { label: DEPTH_LABEL, name: "δ/R", scale: "log" },
    layers: map,
  };
}

export interface Coefficient {
  readonly name: string;
  /** Where its numbers stand in the outcome. */
  readonly value: string;
  readonly standardError: string;
  /** The paper's value; null where the outcome has none to compare with. */
  readonly paper: string | null;
}

const LETTERS: Record<Quantity, string> = { force: "a", area: "b", friction: "c" };

/** The coefficients of one function, as places in the outcome's scalars. */
export function coefficientsOf({ scalars }: Outcome, quantity: Quantity): readonly Coefficient[] {
  const beside = (scalars["beside_the_paper"] as readonly { readonly name: string }[] | undefined) ?? [];
  const found: Coefficient[] = [];
  for (let i = 0; scalarAt(scalars, `${quantity}.coefficients.${i}`) !== null; i += 1) {
    const name = `${LETTERS[quantity]}${i + 1}`;
    const place = beside.findIndex((entry) => entry.name === name);
    found.push({
      name: `$${LETTERS[quantity]}_{${i + 1}}$`,
      value: `${quantity}.coefficients.${i}`,
      standardError: `${quantity}.standard_errors.${i}`,
      paper: place >= 0 && !Number.isNaN(numberAt(scalars, `beside_the_paper.${place}.paper`)) ? `beside_the_paper.${place}.paper` : null,
    });
  }
  return found;
}
