/** What a map page shows, read from the view and written to it. */

import { type Range, type Window, usable } from "../../chart/scale";
import { OVERLAYS, numberOrText, parseAxis, parsePair, parseWords, writeAxis } from "../../state/fields";
import { type View, withFields } from "../../state/view";
import type { CaseValue, Key, KeyAxis, Session } from "../../wire/api";
import { isPure, plainValue } from "../../ui/numbers";

export type Overlay = (typeof OVERLAYS)[number];
export type Mark = "hatch" | "letters";

/** A place in the plane of the two keys, in the form of their axes. */
export interface Place {
  readonly x: number;
  readonly y: number;
}

export interface MapState {
  readonly x: KeyAxis;
  readonly y: KeyAxis;
  readonly show: readonly Overlay[];
  readonly marks: readonly Mark[];
  readonly cursor: Place | null;
  readonly pin: Place | null;
}

export type Keys = ReadonlyMap<string, Key>;

/** Two different keys of the case; what the address does not say, or says wrongly, is the session's. */
export function readMap(view: View, session: Session, keys: Keys): MapState {
  const home = homeAxes(session, keys);
  const known = (text: string | undefined) => {
    const axis = parseAxis(text);
    return axis && keys.has(axis.key) ? axis : undefined;
  };
  const x = known(view.fields["x"]) ?? home.x;
  let y = known(view.fields["y"]) ?? home.y;
  if (y.key === x.key) y = [home.y, home.x].find((axis) => axis.key !== x.key) ?? home.y;
  return {
    x,
    y,
    show: parseWords(view.fields["show"], OVERLAYS) ?? ["full"],
    marks: parseWords(view.fields["marks"], ["hatch", "letters"]) ?? [],
    cursor: place(view.fields["cursor"]),
    pin: place(view.fields["pin"]),
  };
}

function place(text: string | undefined): Place | null {
  const pair = parsePair(text);
  return pair ? { x: pair[0], y: pair[1] } : null;
}

function homeAxes(session: Session, keys: Keys): { x: KeyAxis; y: KeyAxis } {
  if (session.map) return session.map;
  const fallback = (path: string) => axisOfKey(keys.get(path) ?? ([...keys.values()][0] as Key));
  return { x: fallback("operation.velocity"), y: fallback("contact.shear_strength") };
}

/** The axis of a key at first: the session's own, or the range of its slider. */
export function homeAxis(key: Key, session: Session): KeyAxis {
  return [session.map?.x, session.map?.y].find((axis) => axis?.key === key.path) ?? axisOfKey(key);
}

function axisOfKey(key: Key): KeyAxis {
  const end = (value: number) => (key.group === null && !isPure(key) ? `${value} ${key.unit}` : value);
  return { key: key.path, from: end(key.slider.from), to: end(key.slider.to), scale: key.slider.scale };
}

/** Whether the values of an axis have a unit or are the group. */
export function isDimensional(axis: KeyAxis): boolean {
  return typeof axis.from === "string";
}

/** The range of an axis where it can be read without the server: plain numbers, or numbers of the key's own unit. */
export function rangeOfAxis(axis: KeyAxis, key: Key): Range | null {
  const [from, to] = [axis.from, axis.to].map((end) => {
    if (typeof end === "number") return end;
    const parts = /^\s*([-+\d.eE]+)\s*(.*?)\s*$/.exec(end);
    return parts && parts[2] === key.unit ? Number(parts[1]) : Number.NaN;
  }) as [number, number];
  return usable(axis.scale, [from, to]) ? [from, to] : null;
}

/** The axis over another range, in the form in which it was. */
export function axisOver(axis: KeyAxis, key: Key, range: Range): KeyAxis {
  const digits = digitsFor(range);
  const end = (value: number) => valueOnAxis(axis, key, Number(value.toPrecision(digits)));
  return { ...axis, from: numberOrText(end(range[0])), to: numberOrText(end(range[1])) };
}

/** The number of a value in the form of an axis, where the value has that form. */
export function numberOnAxis(axis: KeyAxis, key: Key, value: CaseValue): number | null {
  return isDimensional(axis) ? value.si : plainValue(key, value);
}

/** The text that sets the key of an axis to one of its values. */
export function valueOnAxis(axis: KeyAxis, key: Key, value: number): string {
  return isDimensional(axis) && !isPure(key) ? `${value} ${key.unit}` : String(value);
}

/** Four significant digits, and more where so few would not tell places of a narrow range apart. */
export function digitsFor([from, to]: Range): number {
  const share = (to - from) / Math.max(Math.abs(from), Math.abs(to));
  return Math.min(Math.max(3 + Math.ceil(-Math.log10(share)), 4), 15);
}

export function rounded(place: Place, window: Window): Place {
  return {
    x: Number(place.x.toPrecision(digitsFor(window.x))),
    y: Number(place.y.toPrecision(digitsFor(window.y))),
  };
}

export function withAxes(view: View, axes: { readonly x?: KeyAxis; readonly y?: KeyAxis }): View {
  return withFields(view, {
    ...(axes.x ? { x: writeAxis(axes.x) } : {}),
    ...(axes.y ? { y: writeAxis(axes.y) } : {}),
  });
}

export function withPlace(view: View, field: "cursor" | "pin", place: Place | null): View {
  return withFields(view, { [field]: place ? `${place.x},${place.y}` : undefined });
}

/** The options of a point of the map: those of the view with the two keys set to the place. */
export function optionsAt(view: View, state: MapState, keys: Keys, place: Place): Readonly<Record<string, string>> {
  const [x, y] = [keys.get(state.x.key), keys.get(state.y.key)];
  if (!x || !y) return view.set;
  return { ...view.set, [x.path]: valueOnAxis(state.x, x, place.x), [y.path]: valueOnAxis(state.y, y, place.y) };
}
