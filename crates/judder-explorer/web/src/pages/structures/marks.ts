/** Contact points on the bodies: where each lies as these move, what its colour tells, which are open. */

import type { Range } from "../../chart/scale";
import type { Layer } from "../../chart/spec";
import { type Body, type Swing, turned } from "./body";
import type { ContactPoints } from "./contacts";
import { sized } from "./words";

export interface Marks {
  /** What the colours tell, with its unit and from where to where. */
  readonly told: { readonly name: string; readonly unit: string; readonly range: Range };
  /** Where in that range each point lies, from 0 to 1. */
  readonly shares: Float64Array;
  readonly open: readonly boolean[];
  /** Where the points are, in the axes of the body, as `placesAt` has those of the body. */
  readonly placesAt: (swing: Swing, phase: number, factor: number, out?: Float32Array | Float64Array) => Float32Array | Float64Array;
}

/** Contact points that go along with the nodes on which they lie. */
export function marksOf(body: Body, contacts: ContactPoints): Marks {
  const count = contacts.value.length;
  const rest = turned(Float64Array.from({ length: 3 * count }, (_, i) => (contacts.places[i % 3] as Float64Array)[Math.floor(i / 3)] as number), body.planar);
  const nodes = nodesAt(body, rest);
  const [low, high] = contacts.range;
  const placesAt: Marks["placesAt"] = (swing, phase, factor, out = new Float64Array(3 * count)) => {
    const [c, s] = [factor * Math.cos(phase), factor * Math.sin(phase)];
    for (let i = 0; i < out.length; i += 1) {
      const from = 3 * (nodes[Math.floor(i / 3)] as number) + (i % 3);
      const moved = from < 0 ? 0 : c * (swing.real[from] as number) - s * (swing.imaginary[from] as number);
      out[i] = (rest[i] as number) + moved;
    }
    return out;
  };
  return {
    told: { name: contacts.name, unit: contacts.unit, range: contacts.range },
    shares: contacts.value.map((value) => (high > low ? (value - low) / (high - low) : 0)),
    open: contacts.open,
    placesAt,
  };
}

/** The node at each place; below zero where there is none. */
function nodesAt(body: Body, places: Float64Array): Int32Array {
  const key = (from: Float64Array, i: number) => `${from[3 * i]} ${from[3 * i + 1]} ${from[3 * i + 2]}`;
  const found = new Map<string, number>();
  for (let i = body.points.length / 3 - 1; i >= 0; i -= 1) found.set(key(body.points, i), i);
  return Int32Array.from({ length: places.length / 3 }, (_, i) => found.get(key(places, i)) ?? -1);
}

/** Classes of colour where there is no bar. */
const CLASSES = 5;
const SIZE = 9;

/** Contact points that lie at these places of a picture: the closed ones in classes, the open ones hollow. */
export function markLayers({ told: { name, unit, range }, shares, open }: Pick<Marks, "told" | "shares" | "open">, at: { readonly x: ArrayLike<number>; readonly y: ArrayLike<number> }): Layer[] {
  const [low, high] = range;
  const told = sized(unit, range);
  const end = (k: number) => told.text(low + ((high - low) * k) / CLASSES);
  const some = (wanted: (i: number) => boolean) => {
    const kept = Array.from(open.keys()).filter(wanted);
    return { x: kept.map((i) => at.x[i] as number), y: kept.map((i) => at.y[i] as number) };
  };
  const classes = Array.from({ length: CLASSES }, (_, k): Layer => {
    const own = some((i) => !open[i] && Math.min(Math.floor((shares[i] as number) * CLASSES), CLASSES - 1) === k);
    return { kind: "points", label: `${k === 0 ? `${name} ` : ""}${end(k)} … ${end(k + 1)} ${told.unit}`, ...own, role: { graded: k, of: CLASSES }, marker: "circle", size: SIZE };
  });
  const hollow = some((i) => open[i] === true);
  return hollow.x.length > 0 ? [...classes, { kind: "points", label: "open", ...hollow, role: "reference", hollow: true, size: SIZE }] : classes;
}
