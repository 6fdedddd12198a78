/** What each page keeps in its address. */

import { type Session, lawOfCase } from "../wire/api";
import { CONTACT_PARTS, OVERLAYS, QUANTITIES, RUNS, anyAxis, anyLogRange, anyNumber, anyPair, anyPositive, anyRanges, anyShare, anyText, oneOf, words } from "./fields";
import { fieldsOf } from "./settings";
import type { PageFields } from "./view";

/** What can be heard: of the modes there are as many as an oscillator has eigenvalues. */
const SOUNDS = ["motion", "cycle", "mode-1", "mode-2", "mode-3", "mode-4"] as const;

/** Every page's fields: those of what it shows, which stand here, and those of the settings of what it computes. */
export const pageFields = (session: Pick<Session, "settings" | "choices">): PageFields => ({
  map: {
    x: anyAxis,
    y: anyAxis,
    show: words(OVERLAYS),
    cursor: anyPair,
    pin: anyPair,
    marks: words(["hatch", "letters"]),
  },
  point: {
    along: anyText,
    trail: words(["off"]),
    still: words(["on"]),
    run: words(RUNS),
    live: words(["on"]),
    branch: anyAxis,
    simulated: words(["on"]),
    sound: oneOf(SOUNDS),
    factor: anyPositive,
    volume: anyShare,
    ...fieldsOf(session.settings, ["motion", "limit-cycle", "bifurcation"]),
  },
  contact: {
    part: oneOf(CONTACT_PARTS),
    quantity: oneOf(QUANTITIES),
    speeds: anyLogRange,
    depths: anyLogRange,
    cursor: anyPair,
    compare: oneOf(lawOfCase(session)?.words ?? []),
    velocity: anyText,
    indentation: anyText,
    load: anyText,
    ...fieldsOf(session.settings, ["contact", "contact-law", "fit"]),
  },
  structures: {
    analysis: anyText,
    at: anyNumber,
    mode: anyNumber,
    look: anyPair,
    scale: anyNumber,
    phase: anyNumber,
    zoom: anyRanges,
    signals: anyText,
    over: words(["time", "position"]),
  },
});
