/** The panels of a figure of a report as charts of the page. */

import { legendEntries } from "../../chart/legend";
import { plainText } from "../../chart/markup";
import type { ChartSpec } from "../../chart/spec";
import type { Figure, Panel } from "../../report/described";
import { specOf } from "../../report/specs";
import type { AxisNames } from "./state";

const STILL = { phase: 0, hidden: new Set<string>() };
/** The height of a chart, what every line of its legend adds to it, and a second axis, in pixels. */
const [HEIGHT, ENTRY, SECOND] = [300, 20, 40];

export interface ReportChart {
  readonly spec: ChartSpec;
  readonly names: AxisNames;
  readonly height: number;
}

/** A chart for each panel, lettered as in the report; those over the same axis move together. */
export function reportCharts(figure: Figure): readonly ReportChart[] {
  const { panels } = figure;
  return panels.map((panel, index) => {
    const letter = panels.length > 1 ? ` ${lettered(index)}` : "";
    const spec = { ...specOf(figure, panel, STILL), title: `${figure.title}${letter}: ${plainText(panel.title || panel.y.label)}`, explained: false };
    const height = HEIGHT + ENTRY * legendEntries(spec, "light").length + (panel.second ? SECOND : 0);
    return { spec, names: { x: `figure-x-${panels.findIndex((own) => isAlike(own, panel))}`, y: `figure-y-${index}` }, height };
  });
}

/** (a), (b), …; after (z) again from (a) on, as in the report. */
function lettered(index: number): string {
  return `(${String.fromCharCode(97 + (index % 26))})`;
}

function isAlike({ x: one }: Panel, { x: other }: Panel): boolean {
  return one.label === other.label && one.range[0] === other.range[0] && one.range[1] === other.range[1];
}
