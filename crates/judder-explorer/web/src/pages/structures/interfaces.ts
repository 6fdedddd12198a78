/** How the contact points of an interface are drawn by themselves. */

import type { ChartSpec, PointsLayer } from "../../chart/spec";
import type { ContactPoints } from "./contacts";
import { markLayers } from "./marks";

/** An interface that is narrower than this share of its length is a line. */
const LINE = 1e-6;

interface Axis {
  readonly name: string;
  readonly values: Float64Array;
  readonly length: number;
}

/** An interface: along a line what its points carry and their gaps, over a surface a map of what they carry. */
export function interfaceSpecs(points: ContactPoints, contact: string): readonly ChartSpec[] {
  const own = Array.from(points.contact.keys()).filter((i) => points.contact[i] === contact);
  const picked = (values: Float64Array) => Float64Array.from(own, (i) => values[i] as number);
  const open = own.map((i) => points.open[i] === true);
  const axes = points.places.map((values, k): Axis => {
    const places = picked(values);
    const [low, high] = [places.reduce((a, b) => Math.min(a, b), Number.POSITIVE_INFINITY), places.reduce((a, b) => Math.max(a, b), Number.NEGATIVE_INFINITY)];
    return { name: "xyz".charAt(k), values: places, length: high - low };
  });
  // of equally long ones in the order x, y, z
  const [long, wide] = axes.toSorted((a, b) => b.length - a.length) as [Axis, Axis];
  const value = picked(points.value);
  const what = points.name.toLowerCase();
  if (wide.length > LINE * long.length) {
    const [low, high] = points.range;
    const told = { told: points, open, shares: value.map((one) => (high > low ? (one - low) / (high - low) : 0)) };
    const [across, up] = [long, wide].toSorted((a, b) => a.name.localeCompare(b.name)) as [Axis, Axis];
    return [{ title: `${contact}: ${what}`, x: placeAxis(across), y: placeAxis(up), layers: markLayers(told, { x: across.values, y: up.values }), equal: true }];
  }
  const chart = (title: string, label: string, values: Float64Array, series: number): ChartSpec => ({
    title: `${contact}: ${title}`, x: placeAxis(long), y: { label, scale: "linear" }, layers: alongLine(long.values, values, open, series),
  });
  return [chart(what, `${points.name} (${points.unit})`, value, 0), chart("gap", "Gap $g$ (m)", picked(points.gap), 1)];
}

const placeAxis = ({ name }: Axis) => ({ label: `Place $${name}$ (m)`, scale: "linear" }) as const;

/** Values of points along a line: those of open ones are hollow. */
function alongLine(x: Float64Array, y: Float64Array, open: readonly boolean[], series: number): PointsLayer[] {
  const some = (wanted: boolean) => {
    const kept = Array.from(open.keys()).filter((i) => open[i] === wanted);
    return { x: kept.map((i) => x[i] as number), y: kept.map((i) => y[i] as number) };
  };
  const isAnyOpen = open.includes(true);
  const closed: PointsLayer = { kind: "points", label: isAnyOpen ? "closed" : "", name: "closed", ...some(false), role: { series }, marker: "circle" };
  return isAnyOpen ? [closed, { kind: "points", label: "open", ...some(true), role: { series }, marker: "circle", hollow: true }] : [closed];
}
