/** The chart of the pages: in the theme that is chosen, with the standing of what it shows, and in the export menu. */

import { useContext, useEffect, useRef } from "preact/hooks";
import { StandingContext } from "../ui/standing";
import { useTheme } from "../ui/theme";
import { ChartView, type ChartViewProps, type Shown } from "./ChartView";
import { type DataOf, chartFigure } from "./export";
import { type Figure, registerExport } from "./exports";

export interface ChartProps extends Omit<ChartViewProps, "theme" | "standing" | "shown" | "name" | "nearest" | "scrolls"> {
  /** The data of the CSV; left out, what is drawn. */
  readonly dataOf?: DataOf;
}

export function Chart({ dataOf, ...props }: ChartProps) {
  const { spec } = props;
  const shown = useRef<Shown | null>(null);
  const now = () => {
    const { window, size } = shown.current as Shown;
    return chartFigure(spec, window, size, dataOf);
  };
  const figure = useRef<() => Figure>(now);
  figure.current = now;
  useEffect(() => registerExport(spec.title, () => figure.current()), [spec.title]);
  return <ChartView {...props} theme={useTheme()} standing={useContext(StandingContext)} shown={shown} />;
}
