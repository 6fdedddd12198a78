/** What the point page keeps, read from the view, and the analyses that it asks for. */

import { RUNS, numberOrText, parseAxis, parseWords } from "../../state/fields";
import { analysisOf } from "../../state/settings";
import { type View, withFields } from "../../state/view";
import { plainValue } from "../../ui/numbers";
import type { Analysis, CaseValue, Key, KeyAxis, Session } from "../../wire/api";
import { homeAxis, numberOnAxis, valueOnAxis } from "../map/state";

export type RunKind = (typeof RUNS)[number];

export interface PointState {
  /** The key along which the path of the eigenvalues is shown. */
  readonly along: Key | null;
  readonly hasTrail: boolean;
  /** Whether mode shapes stand still. */
  readonly still: boolean;
  /** What is computed without being asked again. */
  readonly run: readonly RunKind[];
  /** Whether a motion follows the parameters. */
  readonly live: boolean;
  readonly motion: Analysis;
  readonly cycle: Analysis;
  readonly branch: KeyAxis;
  /** Of a diagram the simulated points come first: branches may take minutes. */
  readonly diagrams: readonly Analysis[];
  /** Whether the diagram is only simulated, without following branches. */
  readonly simulated: boolean;
  /** What is heard: `motion`, `cycle`, or `mode-1` and so on. */
  readonly sound: string;
  /** How many times faster than real; left out, what makes it audible. */
  readonly factor: number | null;
  readonly volume: number;
}

export const VOLUME = 0.5;
const FIRST_BRANCH_KEY = "contact.shear_strength";

/** `valueOf` gives the value of each key, where it is known: the branch starts about it. */
export function readPoint(view: View, session: Session, keys: ReadonlyMap<string, Key>, valueOf: (key: Key) => CaseValue | undefined): PointState {
  const { fields } = view;
  const axis = parseAxis(fields["branch"]);
  const first = keys.get(FIRST_BRANCH_KEY) ?? [...keys.values()][0];
  const branch = axis && keys.has(axis.key) ? axis : branchAxis(first as Key, session, valueOf(first as Key));
  const asked = (kind: string, name: string) => analysisOf(session.settings, kind, fields, name);
  const diagram = asked("bifurcation", "branch");
  const simulated = { ...diagram, sweep: { ...branch, ...(diagram["sweep"] as object | undefined) } };
  return {
    along: keys.get(fields["along"] ?? "") ?? null,
    hasTrail: fields["trail"] !== "off",
    still: fields["still"] === "on",
    run: parseWords(fields["run"], RUNS) ?? [],
    live: fields["live"] === "on",
    motion: asked("motion", "motion"),
    cycle: asked("limit-cycle", "cycle"),
    branch,
    diagrams: fields["simulated"] === "on" ? [simulated] : [simulated, { ...simulated, branches: true }],
    simulated: fields["simulated"] === "on",
    sound: fields["sound"] ?? "motion",
    factor: fields["factor"] === undefined ? null : Number(fields["factor"]),
    volume: Number(fields["volume"] ?? VOLUME),
  };
}

/** The half to the double of the value that a key has, within its slider and in the form of its axis; all of the slider where it has none. */
export function branchAxis(key: Key, session: Session, value: CaseValue | undefined): KeyAxis {
  const home = homeAxis(key, session);
  const middle = value ? numberOnAxis(home, key, value) : null;
  if (!value || middle === null || !(middle > 0)) return home;
  // sliders run over plain numbers
  const each = middle / plainValue(key, value);
  const [low, high] = [Math.max(middle / 2, each * key.slider.from), Math.min(2 * middle, each * key.slider.to)];
  if (!(low < high)) return home;
  const end = (value: number) => numberOrText(valueOnAxis(home, key, Number(value.toPrecision(3))));
  return { ...home, from: end(low), to: end(high) };
}

/** The path of the eigenvalues over the range of a key's slider. */
export function pathAnalysis(key: Key, session: Session): Analysis {
  return { name: "path", kind: "spectrum", sweep: { ...homeAxis(key, session), points: PATH_POINTS } };
}

const PATH_POINTS = 801;

/** The view with one thing more, or one less, that is computed without being asked again. */
export function withRun(view: View, kind: RunKind, on: boolean): View {
  const now = parseWords(view.fields["run"], RUNS) ?? [];
  const next = on ? [...new Set([...now, kind])] : now.filter((other) => other !== kind);
  return withFields(view, { run: next.length > 0 ? next.join() : undefined });
}

/** What the exported case file asks for: the analysis that was last switched on, or the path of the eigenvalues. */
export function caseAnalysis(state: PointState, session: Session): Analysis | null {
  const last = state.run.at(-1);
  if (last === "motion" || last === "cycle") return state[last];
  if (last === "branch") return state.diagrams.at(-1) ?? null;
  return state.along ? pathAnalysis(state.along, session) : null;
}
