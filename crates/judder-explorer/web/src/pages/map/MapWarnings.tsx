/** What a report of the map warns of, such as eq. (3): its analysis as `judder run` computes it, without its boundaries. */

import type { Computation } from "../../ui/useComputation";
import { Warnings } from "../../ui/Warnings";
import { outcomeOf } from "../../wire/outcome";
import { mapAnalysis } from "./picture";
import type { MapState } from "./state";
import { useBeside } from "./useCritical";

/** `hasMap` says whether the map of the present values has come: what takes long, such as a law, is known then. */
export function useMapWarnings(set: readonly string[], state: MapState, hasMap: boolean): Computation {
  return useBeside("warnings", set, hasMap ? { ...mapAnalysis(state, false), boundaries: false } : null);
}

export function MapWarnings({ told: { frame, current, error } }: { readonly told: Computation }) {
  const warnings = frame ? outcomeOf(frame).warnings : [];
  return (
    <div class="map-warnings" role="note" aria-label="Warnings of the map">
      {error && <p class="point-warning">It is not known what there is to warn of: {error.message}.</p>}
      <div class={current ? "" : "stale"}>
        <Warnings warnings={warnings} />
      </div>
    </div>
  );
}
