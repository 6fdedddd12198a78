/** The contact points of steady sliding: what each carries, and what is told of each contact. */

import type { Range } from "../../chart/scale";
import type { StudyAnalysis } from "./study";
import { type Arrays, numbers } from "./useArrays";

/** What contact points are known by. */
export const CONTACT_POINTS: readonly string[] = ["contact", "x", "y", "z", "gap", "normal_force", "pressure"];

export interface ContactPoints {
  /** The contact to which each belongs. */
  readonly contact: readonly string[];
  /** Along x, y and z, m. */
  readonly places: readonly [Float64Array, Float64Array, Float64Array];
  readonly gap: Float64Array;
  readonly open: readonly boolean[];
  /** What colours tell: the pressure, or the normal force where a point has no area. */
  readonly value: Float64Array;
  readonly name: string;
  readonly unit: string;
  /** From zero, or the lowest below it, to the largest. */
  readonly range: Range;
}

export function readContacts(arrays: Arrays): ContactPoints {
  const [force, pressure] = [numbers(arrays, "normal_force"), numbers(arrays, "pressure")];
  const hasArea = pressure.length === force.length && !pressure.some(Number.isNaN);
  const value = hasArea ? pressure : force;
  const [name, unit] = hasArea ? ["Pressure", "Pa"] : ["Normal force", "N"];
  return {
    contact: arrays.get("contact")?.texts ?? [],
    places: [numbers(arrays, "x"), numbers(arrays, "y"), numbers(arrays, "z")],
    gap: numbers(arrays, "gap"),
    // a point that is closed carries something
    open: Array.from(force, (own) => own === 0),
    value,
    name,
    unit,
    range: [value.reduce((least, own) => Math.min(least, own), 0), value.reduce((most, own) => Math.max(most, own), 0)],
  };
}

/** What is told of one contact. */
export interface ContactSums {
  readonly name: string;
  readonly points: number;
  readonly closed: number;
  readonly open: number;
  readonly normalForce: number;
  /** The magnitude of the friction forces together. */
  readonly frictionForce: number;
  readonly pressure: number | null;
}

export function contactSums({ scalars }: StudyAnalysis): readonly ContactSums[] {
  const contacts = (scalars["contacts"] ?? {}) as Readonly<Record<string, Readonly<Record<string, unknown>>>>;
  return Object.entries(contacts).map(([name, own]) => ({
    name,
    points: Number(own["points"]),
    closed: Number(own["closed"]),
    open: Number(own["open"]),
    normalForce: Number(own["normal_force"]),
    frictionForce: Math.hypot(...((own["tangential_force"] as readonly number[] | undefined) ?? [])),
    pressure: typeof own["pressure_max"] === "number" ? own["pressure_max"] : null,
  }));
}
