/** What the user's moves on the map change in the view. */

import type { Cursor, Phase } from "../../chart/interaction";
import type { Window } from "../../chart/scale";
import type { ViewStore } from "../../state/store";
import { withFields } from "../../state/view";
import type { Key, KeyAxis, Session } from "../../wire/api";
import { type MapState, axisOver, homeAxis, rounded, withAxes, withPlace } from "./state";

interface Shown {
  readonly store: ViewStore;
  readonly session: Session;
  readonly state: MapState;
  readonly x: Key;
  readonly y: Key;
  readonly window: Window | null;
}

export function moves({ store, session, state, x, y, window }: Shown) {
  const place = (cursor: Cursor) => rounded(cursor, window ?? { x: [cursor.x, 2 * cursor.x], y: [cursor.y, 2 * cursor.y] });
  return {
    onWindow: (next: Window | null, phase: Phase) => {
      // before the first map, ends with units of their own are not known here
      if (next && !window) return;
      const axes = next
        ? { x: axisOver(state.x, x, next.x), y: axisOver(state.y, y, next.y) }
        : { x: homeAxis(x, session), y: homeAxis(y, session) };
      store.update((view) => withAxes(view, axes), phase);
    },
    onCursor: (cursor: Cursor | null) => store.update((view) => withPlace(view, "cursor", cursor && place(cursor)), "quiet"),
    onPick: (cursor: Cursor) => store.update((view) => withPlace(view, "pin", place(cursor))),
    onKey: (name: "x" | "y") => (key: Key) =>
      // places in another plane mean nothing
      store.update((view) => withFields(withAxes(view, { [name]: homeAxis(key, session) }), { cursor: undefined, pin: undefined })),
    onAxis: (name: "x" | "y") => (axis: KeyAxis) => store.update((view) => withAxes(view, { [name]: axis })),
    onShow: (show: readonly string[]) => store.update((view) => withFields(view, { show: show.join() })),
    onMarks: (marks: readonly string[]) => store.update((view) => withFields(view, { marks: marks.length > 0 ? marks.join() : undefined })),
  };
}
