/** A chart that is looked at anew only when its picture changes: the page around it changes at every step of a drag. */

import { useMemo, useRef } from "preact/hooks";
import { Chart } from "../../chart/Chart";
import type { Cursor } from "../../chart/interaction";
import type { ChartSpec } from "../../chart/spec";

interface StillChartProps {
  readonly spec: ChartSpec;
  readonly height: number;
  readonly onPick?: (cursor: Cursor) => void;
}

export function StillChart({ spec, height, onPick }: StillChartProps) {
  const newest = useRef(onPick);
  newest.current = onPick;
  const picks = onPick !== undefined;
  // the same element as before is not rendered again
  return useMemo(
    () => <Chart spec={spec} height={height} {...(picks ? { onPick: (cursor: Cursor) => newest.current?.(cursor) } : {})} />,
    [spec, height, picks],
  );
}
