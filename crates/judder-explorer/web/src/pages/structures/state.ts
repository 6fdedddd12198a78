/** What the structures page shows, read from the view and written to it. */

import { type Range, type Window, usable } from "../../chart/scale";
import { type ChartSpec } from "../../chart/spec";
import { homeWindow } from "../../chart/frame";
import { parsePair, parseRanges } from "../../state/fields";
import { type View, withFields } from "../../state/view";
import { type Study, type StudyAnalysis, byKind, isOverPosition } from "./study";

/** Angles in degrees from which a body is looked at. */
export interface Look {
  readonly azimuth: number;
  readonly elevation: number;
}

export const FREE: Look = { azimuth: -35, elevation: 25 };
export const LARGEST_SCALE = 5;

/** The analysis of the view; what the address does not say is the first one of the list. */
export function pickedAnalysis(view: View, study: Study): StudyAnalysis | undefined {
  const named = study.analyses.find((analysis) => analysis.name === view.fields["analysis"]);
  return named ?? byKind(study.analyses)[0]?.analyses[0];
}

/** The view of another analysis: a place goes along where it means the same there. */
export function withAnalysis(view: View, from: StudyAnalysis | undefined, to: StudyAnalysis): View {
  const keep = isOverPosition(from) && isOverPosition(to);
  const fields = keep && view.fields["at"] !== undefined ? { at: view.fields["at"] } : {};
  return { ...view, fields: { analysis: to.name, ...fields } };
}

export function numberField(view: View, name: string): number | undefined {
  const text = view.fields[name];
  const value = text === undefined ? Number.NaN : Number(text);
  return Number.isFinite(value) ? value : undefined;
}

/** The number of the picked mode, within those that there are. */
export function pickedMode(view: View, count: number, first = 0): number {
  const wanted = numberField(view, "mode");
  const index = wanted === undefined ? first : Math.round(wanted) - 1;
  return Math.min(Math.max(index, 0), Math.max(count - 1, 0));
}

export function readLook(view: View, planar: boolean): Look {
  const pair = parsePair(view.fields["look"]);
  if (pair) return { azimuth: pair[0], elevation: Math.min(Math.max(pair[1], -90), 90) };
  return planar ? { azimuth: 0, elevation: 0 } : FREE;
}

export function withLook(view: View, look: Look): View {
  const turned = ((((look.azimuth + 180) % 360) + 360) % 360) - 180;
  return withFields(view, { look: `${Math.round(turned)},${Math.round(Math.min(Math.max(look.elevation, -90), 90))}` });
}

/** How much larger than at first shapes are drawn. */
export function readScale(view: View): number {
  return Math.min(Math.max(numberField(view, "scale") ?? 1, 0), LARGEST_SCALE);
}

/** A number in the digits that tell places of a range apart. */
export function placed(value: number, [from, to]: Range): number {
  const size = Math.max(Math.abs(from), Math.abs(to), 1e-300);
  const digits = 4 + Math.ceil(Math.log10(Math.max(size / Math.max(to - from, 1e-12 * size), 1)));
  return Number(value.toPrecision(Math.min(Math.max(digits, 4), 15)));
}

/** The window of a chart with these axes: those of the address, the chart's own elsewhere. */
export function readWindow(view: View, spec: ChartSpec, names: AxisNames): Window {
  const ranges = parseRanges(view.fields["zoom"]) ?? {};
  const home = homeWindow(spec);
  const range = (axis: "x" | "y") => {
    const name = names[axis];
    const kept = name === undefined ? undefined : ranges[name];
    return kept && usable(spec[axis].scale, kept) ? kept : home[axis];
  };
  return { x: range("x"), y: range("y") };
}

/** The names under which the ranges of both axes are kept: charts with the same name move together. */
export interface AxisNames {
  readonly x: string;
  /** Left out where the chart finds the range from what it shows. */
  readonly y?: string;
}

export function withWindow(view: View, window: Window | null, names: AxisNames): View {
  const ranges: Record<string, Range> = { ...(parseRanges(view.fields["zoom"]) ?? {}) };
  for (const axis of ["x", "y"] as const) {
    const name = names[axis];
    if (name === undefined) continue;
    if (window) ranges[name] = window[axis];
    else delete ranges[name];
  }
  return withRanges(view, ranges);
}

/** The view with some ranges set, or, where undefined, back to all. */
export function withRange(view: View, name: string, range: Range | undefined): View {
  const ranges: Record<string, Range> = { ...(parseRanges(view.fields["zoom"]) ?? {}) };
  if (range) ranges[name] = range;
  else delete ranges[name];
  return withRanges(view, ranges);
}

function withRanges(view: View, ranges: Readonly<Record<string, Range>>): View {
  const end = (value: number, range: Range) => String(placed(value, range));
  const parts = Object.entries(ranges).map(([name, range]) => `${name}:${end(range[0], range)}:${end(range[1], range)}`);
  const text = parts.join(",");
  // digits may not tell the ends of a range of no width apart
  return withFields(view, { zoom: text !== "" && parseRanges(text) ? text : undefined });
}
