/** What lies under the cursor, or at the pinned point. */

import { useView } from "../../state/store";
import type { View } from "../../state/view";
import type { Key } from "../../wire/api";
import { useApp } from "../../ui/app";
import { keyName, symbolMarkup } from "../../ui/numbers";
import { ErrorNote, unlessSaid } from "../../ui/ErrorNote";
import { Link } from "../../ui/Link";
import { PointValues } from "../../ui/PointValues";
import { StandingNote } from "../../ui/StandingNote";
import { useStanding } from "../../ui/standing";
import type { LivePoint } from "../../ui/usePoint";
import { Value } from "../../ui/Value";
import { type MapState, type Place, isDimensional, withPlace } from "./state";

interface CursorPanelProps {
  readonly state: MapState;
  readonly place: Place | null;
  readonly x: Key;
  readonly y: Key;
  readonly live: LivePoint;
  /** The options of the place. */
  readonly set: View["set"] | null;
  /** Whether the map as it is shown does not reach to the place. */
  readonly isOutside: boolean;
}

export function CursorPanel({ state, place, x, y, live, set, isOutside }: CursorPanelProps) {
  const { store, error: refused } = useApp();
  const view = useView(store);
  const unit = (axis: MapState["x"], key: Key) => (isDimensional(axis) ? key.unit : "");
  const nameOf = (axis: MapState["x"], key: Key) => symbolMarkup(isDimensional(axis) ? key.symbol : (key.group ?? key.symbol));
  const waiting = live.set !== JSON.stringify(set && Object.entries(set).map(([key, text]) => `${key}=${text}`));
  const failure = waiting ? (live.error ?? refused) : null;
  const isAsked = place !== null && set !== null;
  const standing = useStanding({ has: live.point !== null, isCurrent: !waiting, busy: isAsked && !failure, what: "this point", error: isAsked ? failure : null }, live.point);
  if (!place || !set) {
    return (
      <section class="cursor-panel" aria-label="Point">
        <h2>Point</h2>
        <p>Move over the map, or focus it and press the arrow keys. A click or Enter pins the point.</p>
      </section>
    );
  }
  return (
    <section class="cursor-panel" aria-label="Point" aria-busy={waiting && !failure}>
      <h2>{state.pin ? "Pinned point" : "Point under the cursor"}</h2>
      <p class="cursor-actions">
        <Link to={{ page: "point", set, fields: {} }}>Open this point</Link>
        {state.pin ? (
          <button type="button" onClick={() => store.update((view) => withPlace(view, "pin", null))}>
            Unpin
          </button>
        ) : (
          <button type="button" onClick={() => store.update(() => withPlace(view, "pin", place))}>
            Pin
          </button>
        )}
      </p>
      <dl class="values">
        <Value name={`${keyName(x)} ${nameOf(state.x, x)}`} dataKey="cursor.x" value={place.x} unit={unit(state.x, x)} />
        <Value name={`${keyName(y)} ${nameOf(state.y, y)}`} dataKey="cursor.y" value={place.y} unit={unit(state.y, y)} />
      </dl>
      {isOutside && <p>The map that is shown does not reach to this point.</p>}
      <ErrorNote error={unlessSaid(live.error, refused)} />
      <StandingNote standing={standing} spoken />
      {live.point && (
        <div class={waiting ? "stale" : ""} data-set={live.set}>
          <PointValues point={live.point} />
        </div>
      )}
    </section>
  );
}
