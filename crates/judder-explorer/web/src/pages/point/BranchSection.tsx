/** The branch of limit cycles along a key. */

import { useMemo } from "preact/hooks";
import type { Cursor } from "../../chart/interaction";
import { useView } from "../../state/store";
import { withFields, withOption } from "../../state/view";
import { writeAxis } from "../../state/fields";
import { Switch } from "../../ui/choices";
import { useApp } from "../../ui/app";
import { StandingContext } from "../../ui/standing";
import { significant } from "../../ui/numbers";
import { SettingControls } from "../../ui/SettingControls";
import type { Key } from "../../wire/api";
import { RequestError } from "../../wire/request";
import { AxisPicker } from "../map/AxisPicker";
import { keyAxisLabel } from "../map/spec";
import { valueOnAxis } from "../map/state";
import { type Branch, branchSpec, rangeOfBranch } from "./branch";
import { valueOf, valueOnAxisOf } from "./keys";
import { RunBar } from "./RunBar";
import { Summary } from "./Summary";
import { type PointState, branchAxis } from "./state";
import { StillChart } from "./StillChart";
import { type Run, useRunStanding } from "./useRun";

export function BranchSection({ state, run }: { readonly state: PointState; readonly run: Run<Branch> }) {
  const { session, store, keys, values } = useApp();
  useView(store);
  const { branch: axis } = state;
  const key = keys.get(axis.key) as Key;
  const result = run.result?.key === axis.key ? run.result : null;
  const standing = useRunStanding(run);
  const now = valueOnAxisOf(key, axis, values);
  const spec = useMemo(
    () => (result ? branchSpec(result, { label: keyAxisLabel(key, axis), scale: axis.scale, range: rangeOfBranch(result, axis.scale) }, now) : null),
    [result, key, axis.scale, typeof axis.from, now],
  );
  const onKey = (key: Key) => {
    const next = branchAxis(key, session, valueOf(key, values));
    store.update((view) => withFields(view, { branch: writeAxis(next) }));
  };
  const pick = (cursor: Cursor) => store.update((view) => withOption(view, key.path, valueOnAxis(axis, key, significant(cursor.x))));
  return (
    <section class="card card-wide" aria-labelledby="branch-title">
      <h2 id="branch-title">Branch of limit cycles</h2>
      <AxisPicker name="x" error={fieldError(run.error)} axis={axis} keys={[...keys.values()]} taken="" onKey={onKey} onAxis={(axis) => store.update((view) => withFields(view, { branch: writeAxis(axis) }))} />
      <RunBar kind="branch" name="Follow the branch" run={run} analysis={state.diagrams.at(-1) ?? { name: "branch", kind: "bifurcation" }} keep={{ branch: writeAxis(axis) }}>
        <SettingControls kind="bifurcation" first={["sweep.points"]} error={run.error} />
        <Switch name="simulated points only" title="without the branches, which may take minutes" on={state.simulated} onChange={(on) => store.update((view) => withFields(view, { simulated: on ? "on" : undefined }))} />
      </RunBar>
      {!spec && <p class="note">Simulated upwards and downwards, then followed through its folds, stable and unstable. Branches may take minutes where cycles stick and lift off.</p>}
      {spec && result && (
        <div class={standing ? "stale" : ""}>
          <StandingContext.Provider value={standing}>
            <StillChart spec={spec} height={360} onPick={pick} />
          </StandingContext.Provider>
          <p class="note">A click or Enter sets the key to the cursor's value.{spec.x.range && now !== null && (now < spec.x.range[0] || now > spec.x.range[1]) && " The present value lies outside."}</p>
          <Summary outcome={result.outcome} prefix="branch" entries={[]} />
        </div>
      )}
    </section>
  );
}

/** The analysis of a branch calls its axis a sweep. */
function fieldError(error: RequestError | null): RequestError | null {
  return error && new RequestError(error.message.replace("`sweep.", "`x."), error.status, error.place, error.help, error.others.flatMap((other) => fieldError(other) ?? []));
}
