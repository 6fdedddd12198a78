/** Eigenvalues in the complex plane, their trail, and their path along a key. */

import { useContext, useEffect, useMemo, useState } from "preact/hooks";
import type { Cursor } from "../../chart/interaction";
import { useView } from "../../state/store";
import { options, withFields, withOption } from "../../state/view";
import { Select, Switch } from "../../ui/choices";
import { useApp } from "../../ui/app";
import { ErrorNote, unlessSaid } from "../../ui/ErrorNote";
import { keyName, significant, keyHead } from "../../ui/numbers";
import { StandingContext, useStanding } from "../../ui/standing";
import type { Key, Pair } from "../../wire/api";
import { homeAxis, isDimensional, valueOnAxis } from "../map/state";
import { keyAxisLabel, keyHeading } from "../map/spec";
import { type Mode, eigenSpec, growthSpec } from "./eigen";
import { valueOnAxisOf } from "./keys";
import { type PointState, pathAnalysis } from "./state";
import { StillChart } from "./StillChart";
import { usePath } from "./usePath";

/** Sets of eigenvalues that a trail keeps. */
const TRAIL = 60;

interface EigenSectionProps {
  readonly state: PointState;
  readonly eigenvalues: readonly Pair[] | null;
  readonly modes: readonly Mode[];
}

export function EigenSection({ state, eigenvalues, modes }: EigenSectionProps) {
  const { session, store, keys, values, error: refused } = useApp();
  const view = useView(store);
  const [trail, clear] = useTrail(eigenvalues, state.hasTrail);
  const { along } = state;
  const analysis = useMemo(() => (along ? pathAnalysis(along, session) : null), [along, session]);
  const { path, isCurrent, error } = usePath(options(view), along?.path ?? "", analysis);
  const axis = along ? homeAxis(along, session) : null;
  const alongName = along && axis ? keyHeading(axis, along) : "";
  const spec = useMemo(
    () => eigenSpec({ modes, trail, path, pathName: along ? `path along ${keyName(along)}` : "", alongName }),
    [modes, trail, path, along, alongName],
  );
  const now = along && axis ? valueOnAxisOf(along, axis, values) : null;
  const growth = useMemo(
    () => (path && along && axis ? growthSpec(path, { label: keyAxisLabel(along, axis), name: alongName, scale: axis.scale }, now) : null),
    [path, along, now, axis?.scale],
  );
  const ofPath = useStanding({ has: path !== null, isCurrent, busy: !isCurrent && !error, what: "the path", error }, path);
  // the eigenvalues themselves come first
  const standing = useContext(StandingContext) ?? ofPath;
  const pick = (cursor: Cursor) => {
    if (along && axis) store.update((view) => withOption(view, along.path, valueOnAxis(axis, along, significant(cursor.x))));
  };
  return (
    <section class="card eigen" aria-labelledby="eigen-title">
      <h2 id="eigen-title">Eigenvalues</h2>
      <div class="run-bar">
        <AlongChoice keys={[...keys.values()]} along={along} />
        <Switch name="trail" on={state.hasTrail} onChange={(on) => store.update((view) => withFields(view, { trail: on ? undefined : "off" }))} />
        <button type="button" onClick={clear} disabled={trail.length === 0}>
          Clear trail
        </button>
      </div>
      <ErrorNote error={unlessSaid(error, refused)} />
      <StandingContext.Provider value={standing}>
        <StillChart spec={spec} height={350} />
        {growth && <StillChart spec={growth} height={210} onPick={pick} />}
      </StandingContext.Provider>
      {growth && along && axis && (
        <p class="note">A click or Enter sets {keyName(along)} to the cursor's value{isDimensional(axis) ? ` in ${along.unit}` : ""}.</p>
      )}
    </section>
  );
}

function AlongChoice({ keys, along }: { readonly keys: readonly Key[]; readonly along: Key | null }) {
  const { store } = useApp();
  const choose = (path: string) => store.update((view) => withFields(view, { along: path === "" ? undefined : path }));
  return (
    <label class="choice">
      path along{" "}
      <Select value={along?.path ?? ""} options={[["", "no key"], ...keys.map((key) => [key.path, keyHead(key)] as const)]} onChange={choose} />
    </label>
  );
}

/** Where the eigenvalues were, from the oldest; without what is there now. */
function useTrail(eigenvalues: readonly Pair[] | null, on: boolean): readonly [readonly (readonly Pair[])[], () => void] {
  const [kept, setKept] = useState<readonly (readonly Pair[])[]>([]);
  useEffect(() => {
    if (!eigenvalues || !on) return setKept([]);
    const text = JSON.stringify(eigenvalues);
    setKept((kept) => (JSON.stringify(kept.at(-1)) === text ? kept : [...kept.slice(-TRAIL), eigenvalues]));
  }, [eigenvalues, on]);
  const before = useMemo(() => kept.slice(0, -1), [kept]);
  return [before, () => setKept((kept) => kept.slice(-1))];
}
