/** A chart whose window stands in the address; charts with a range of the same name move together. */

import type { ComponentChildren } from "preact";
import { Chart } from "../../chart/Chart";
import type { Cursor } from "../../chart/interaction";
import type { ChartSpec } from "../../chart/spec";
import { useView } from "../../state/store";
import { useApp } from "../../ui/app";
import { type AxisNames, readWindow, withWindow } from "./state";

interface StudyChartProps {
  readonly spec: ChartSpec;
  readonly names: AxisNames;
  readonly height: number;
  readonly mark?: number | null;
  readonly onPick?: (cursor: Cursor) => void;
  /** Buttons beside the title. */
  readonly tools?: ComponentChildren;
}

export function StudyChart({ spec, names, height, mark, onPick, tools }: StudyChartProps) {
  const { store } = useApp();
  const view = useView(store);
  return (
    <figure class="study-chart">
      <figcaption>
        <span>{spec.title}</span>
        {tools}
      </figcaption>
      <Chart
        spec={spec}
        window={readWindow(view, spec, names)}
        onWindow={(window, phase) => store.update((view) => withWindow(view, window, names), phase)}
        height={height}
        mark={mark ?? null}
        {...(onPick ? { onPick } : {})}
      />
    </figure>
  );
}
