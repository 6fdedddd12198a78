/** A chart whose window stands in the address; charts with a range of the same name move together. */

import type { ComponentChildren } from "preact";
import { Chart } from "../../chart/Chart";
import type { DataOf } from "../../chart/export";
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
  /** The data of the CSV, where it is not what is drawn. */
  readonly dataOf?: DataOf | undefined;
  /** What the picture leaves out, or how it is read. */
  readonly note?: string | undefined;
  /** Buttons beside the title. */
  readonly tools?: ComponentChildren;
}

export function StudyChart({ spec, names, height, mark, onPick, dataOf, note, tools }: StudyChartProps) {
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
        {...(dataOf ? { dataOf } : {})}
      />
      {note && <p class="study-note">{note}</p>}
    </figure>
  );
}
