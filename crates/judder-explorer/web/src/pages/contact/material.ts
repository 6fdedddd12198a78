/** Moduli and loss tangent over frequency. */

import { drawable, rangeOf } from "../../chart/scale";
import type { ChartSpec, Layer } from "../../chart/spec";
import { type Frame, reals } from "../../wire/frames";
import { numberAt, outcomeOf } from "../../wire/outcome";
import { shortNumber } from "./words";

/** A frequency in rad/s that is marked, with its name in markup. */
export interface Mark {
  readonly name: string;
  readonly at: number;
  readonly role: { readonly series: number };
}

const FREQUENCY = "Angular frequency $ω$ (rad s^{−1})";

export function modulusSpec(frame: Frame | null, marks: readonly Mark[]): ChartSpec {
  const layers: Layer[] = [];
  if (frame) {
    const { scalars } = outcomeOf(frame);
    const x = reals(frame, "frequency");
    layers.push({ kind: "line", label: "storage modulus $E$′", x, y: reals(frame, "storage_modulus"), role: { series: 0 } });
    layers.push({ kind: "line", label: "loss modulus $E$″", x, y: reals(frame, "loss_modulus"), role: { series: 1 } });
    layers.push(...measured(frame, "storage_modulus", "measured $E$′", 0), ...measured(frame, "loss_modulus", "measured $E$″", 1));
    const plateaus = [
      ["rubbery $E_{0}$", "rubbery_modulus_pascal"],
      ["glassy $E_{∞}$", "glassy_modulus_pascal"],
    ] as const;
    for (const [name, key] of plateaus) {
      const at = numberAt(scalars, key);
      if (drawable("log", at)) layers.push({ kind: "rule", across: "y", label: name, at, role: "reference" });
    }
    layers.push(...rules(marks));
  }
  return { title: "Storage and loss modulus over frequency", x: frequencies(frame, marks), y: { label: "Modulus $E$ (Pa)", scale: "log" }, layers };
}

export function tangentSpec(frame: Frame | null, marks: readonly Mark[]): ChartSpec {
  const layers: Layer[] = [];
  if (frame) {
    const x = reals(frame, "frequency");
    layers.push({ kind: "line", label: "loss tangent $E$″/$E$′", x, y: reals(frame, "loss_tangent"), role: { series: 2 }, dash: "solid" });
    const [storage, loss] = [reals(frame, "measured_storage_modulus"), reals(frame, "measured_loss_modulus")];
    if (storage.length > 0) {
      const y = loss.map((value, i) => value / (storage[i] as number));
      layers.push({ kind: "points", label: "measured", x: reals(frame, "measured_frequency"), y, role: { series: 2 }, size: 6, hollow: true });
    }
    layers.push(...rules(marks));
  }
  return { title: "Loss tangent over frequency", x: frequencies(frame, marks), y: { label: "Loss tangent $E$″/$E$′ (−)", scale: "log" }, layers };
}

/** What was measured, beside the series that was fitted to it; nothing where the case names no data. */
function measured(frame: Frame, name: string, label: string, series: number): Layer[] {
  const [x, y] = [reals(frame, "measured_frequency"), reals(frame, `measured_${name}`)];
  return x.length > 0 && x.length === y.length ? [{ kind: "points", label, x, y, role: { series }, size: 6, hollow: true }] : [];
}

function rules(marks: readonly Mark[]): Layer[] {
  return marks
    .filter(({ at }) => drawable("log", at))
    .map(({ name, at, role }) => ({ kind: "rule", across: "x", label: `${name} = ${shortNumber(at)} rad/s`, at, role }));
}

/** The frequencies of the curve and of the marks. */
function frequencies(frame: Frame | null, marks: readonly Mark[]): ChartSpec["x"] {
  const range = rangeOf("log", [frame ? reals(frame, "frequency") : [], marks.map(({ at }) => at)]);
  return { label: FREQUENCY, name: "angular frequency (rad/s)", scale: "log", ...(frame ? { range } : {}) };
}
