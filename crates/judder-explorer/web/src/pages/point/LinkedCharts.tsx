/** Charts one above the other over the same x axis: zoomed and moved together along it. */

import { useEffect, useMemo, useState } from "preact/hooks";
import { Chart } from "../../chart/Chart";
import { homeWindow } from "../../chart/frame";
import type { Range, Window } from "../../chart/scale";
import type { ChartSpec } from "../../chart/spec";

interface LinkedChartsProps {
  readonly specs: readonly ChartSpec[];
  readonly height: number;
  /** Where this changes everything is shown again. */
  readonly of: string;
}

export function LinkedCharts({ specs, height, of }: LinkedChartsProps) {
  const [across, setAcross] = useState<Range | null>(null);
  const [up, setUp] = useState<Readonly<Record<string, Range>>>({});
  const reset = () => {
    setAcross(null);
    setUp({});
  };
  useEffect(reset, [of]);
  // while neither pictures nor ranges change nothing is rendered again
  const charts = useMemo(() => {
    const onWindow = (title: string) => (window: Window | null) => {
      if (!window) return reset();
      setAcross(window.x);
      setUp((ranges) => ({ ...ranges, [title]: window.y }));
    };
    return specs.map((spec) => {
      const home = homeWindow(spec);
      const window = { x: across ?? home.x, y: up[spec.title] ?? home.y };
      return <Chart key={spec.title} spec={spec} height={height} window={window} onWindow={onWindow(spec.title)} />;
    });
  }, [specs, across, up, height]);
  return <>{charts}</>;
}
