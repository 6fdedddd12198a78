/** What a report of the map warns of, such as eq. (3): its analysis as `judder run` computes it, without its boundaries. */

import { Warnings, warningsOf } from "../../ui/Warnings";
import { mapAnalysis } from "./picture";
import type { MapState } from "./state";
import { type LiveOutcome, useOutcome } from "./useOutcome";

/** `hasMap` says whether the map of the present values has come: what takes long, such as a law, is known then. */
export function useMapWarnings(set: readonly string[], state: MapState, hasMap: boolean): LiveOutcome {
  return useOutcome("warnings", set, hasMap ? { ...mapAnalysis(state, false), boundaries: false } : null);
}

export function MapWarnings({ told: { outcome, isCurrent, error } }: { readonly told: LiveOutcome }) {
  const warnings = outcome ? warningsOf(outcome) : [];
  return (
    <div class="map-warnings" role="note" aria-label="Warnings of the map">
      {error && <p class="point-warning">It is not known what there is to warn of: {error.message}.</p>}
      <div class={isCurrent ? "" : "stale"}>
        <Warnings warnings={warnings} />
      </div>
    </div>
  );
}
