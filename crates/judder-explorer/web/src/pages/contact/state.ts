/** What the contact page shows, read from the view and written to it. */

import { type Range, type Window, usable } from "../../chart/scale";
import { CONTACT_PARTS, QUANTITIES, numberOrText, parsePair } from "../../state/fields";
import { analysisOf } from "../../state/settings";
import { type View, withFields } from "../../state/view";
import type { Analysis, Session } from "../../wire/api";

export type Part = (typeof CONTACT_PARTS)[number];
export type Quantity = (typeof QUANTITIES)[number];

/** A speed v τ/R and a depth δ/R. */
export interface Place {
  readonly velocity: number;
  readonly indentation: number;
}

/** What presses the indenter down in the one solution that is shown. */
export type Loading = { readonly key: "indentation" | "load"; readonly value: string };

export interface ContactState {
  readonly part: Part;
  readonly quantity: Quantity;
  readonly speeds: Range;
  readonly depths: Range;
  /** Null where the address names none. */
  readonly cursor: Place | null;
  /** What the fit is made over: the same ranges where the address names them. */
  readonly fitSpeeds: Range;
  readonly fitDepths: Range;
  readonly hasRanges: boolean;
  /** The law beside that of the case. */
  readonly compare: string | null;
  /** Of the one solution; null is the operating point's. */
  readonly velocity: string | null;
  readonly loading: Loading | null;
  /** What an analysis is asked for with, beside what the page itself says. */
  readonly asked: (kind: string, name: string) => Analysis;
}

const HOME_SPEEDS: Range = [1e-6, 1e4];
const HOME_DEPTHS: Range = [1e-6, 1e-1];
/** The speeds and depths of the oscillator paper's fits (its Fig. 14). */
const [FIT_SPEEDS, FIT_DEPTHS]: readonly [Range, Range] = [[1e-4, 1e4], [1e-4, 1e-1]];

export function readContact(view: View, session: Pick<Session, "settings">): ContactState {
  const { fields } = view;
  const word = <T extends string>(field: string, allowed: readonly T[], home: T) =>
    allowed.find((one) => one === fields[field]) ?? home;
  const cursor = parsePair(fields["cursor"]);
  const loads = (["load", "indentation"] as const).filter((key) => fields[key]?.trim());
  const key = loads[0];
  return {
    part: word("part", CONTACT_PARTS, "material"),
    quantity: word("quantity", QUANTITIES, "friction"),
    speeds: readRange(fields["speeds"], HOME_SPEEDS),
    depths: readRange(fields["depths"], HOME_DEPTHS),
    fitSpeeds: readRange(fields["speeds"], FIT_SPEEDS),
    fitDepths: readRange(fields["depths"], FIT_DEPTHS),
    hasRanges: fields["speeds"] !== undefined || fields["depths"] !== undefined,
    cursor: cursor && cursor.every((value) => value > 0) ? { velocity: cursor[0], indentation: cursor[1] } : null,
    compare: fields["compare"] ?? null,
    velocity: fields["velocity"]?.trim() || null,
    loading: key ? { key, value: (fields[key] as string).trim() } : null,
    asked: (kind, name) => analysisOf(session.settings, kind, fields, name),
  };
}

function readRange(text: string | undefined, home: Range): Range {
  const pair = parsePair(text);
  return pair && usable("log", pair) ? pair : home;
}

export function withWindow(view: View, window: Window | null): View {
  const text = (range: Range) => range.map((end) => Number(end.toPrecision(4))).join();
  return withFields(view, { speeds: window ? text(window.x) : undefined, depths: window ? text(window.y) : undefined });
}

export function withCursor(view: View, cursor: Place | null): View {
  const text = cursor && [cursor.velocity, cursor.indentation].map((value) => Number(value.toPrecision(4))).join();
  return withFields(view, { cursor: text ?? undefined });
}

/** Only one of the two can be given. */
export function withLoading(view: View, loading: Loading | null): View {
  return withFields(view, {
    load: loading?.key === "load" ? loading.value : undefined,
    indentation: loading?.key === "indentation" ? loading.value : undefined,
  });
}

export const MODULUS: Analysis = { name: "modulus", kind: "modulus" };

/** Points of the law's plane: along speed, along depth. */
const LAW_POINTS = { velocity: 121, indentation: 81 };

const span = ([from, to]: Range, points: number) => ({ from, to, points });

export function lawSpans(state: ContactState) {
  return {
    velocity: span(state.speeds, LAW_POINTS.velocity),
    indentation: span(state.depths, LAW_POINTS.indentation),
  };
}

/** The law computed for the substrate itself. */
export function lawAnalysis(state: ContactState): Analysis {
  return { ...state.asked("contact-law", "law"), ...lawSpans(state) };
}

export function fitAnalysis(state: ContactState): Analysis {
  return { ...state.asked("fit", "fit"), velocity: span(state.fitSpeeds, 41), indentation: span(state.fitDepths, 13) };
}

/** The contact at the place that the address names, otherwise at `home`. */
export function solutionAnalysis(state: ContactState, home: Place): Analysis {
  const loading = state.loading ?? { key: "indentation", value: String(home.indentation) };
  return {
    ...state.asked("contact", "contact"),
    velocity: state.velocity === null ? home.velocity : numberOrText(state.velocity),
    [loading.key]: numberOrText(loading.value),
  };
}
