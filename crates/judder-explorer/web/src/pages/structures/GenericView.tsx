/** Any analysis: its scalars, its texts and its arrays as charts. */

import { useMemo } from "preact/hooks";
import { Busy } from "./Busy";
import { MOST, coordinates, drawable, genericSpecs } from "./generic";
import { Scalars } from "./Scalars";
import { StudyChart } from "./StudyChart";
import type { StudyAnalysis } from "./study";
import { useArrays } from "./useArrays";

export function GenericView({ analysis }: { readonly analysis: StudyAnalysis }) {
  return (
    <>
      <Scalars analysis={analysis} open />
      <GenericCharts analysis={analysis} without={[]} />
    </>
  );
}

interface GenericChartsProps {
  readonly analysis: StudyAnalysis;
  /** What is shown elsewhere. */
  readonly without: readonly string[];
}

export function GenericCharts({ analysis, without }: GenericChartsProps) {
  const drawn = drawable(analysis, without);
  const wanted = [...new Set([...drawn.map((one) => one.name), ...coordinates(analysis, drawn)])];
  const live = useArrays(analysis.name, drawn.length > 0 ? wanted : [], { most: MOST }, "generic");
  const specs = useMemo(
    () => (live.arrays ? drawn.flatMap((one) => genericSpecs(analysis, one, live.arrays ?? new Map()).map((spec) => ({ one, spec }))) : []),
    [live.arrays, analysis],
  );
  if (drawn.length === 0) return null;
  if (!live.arrays) return <Busy live={live} words="Reading the arrays…" />;
  return (
    <div class="study-grid">
      {specs.map(({ one, spec }, index) => (
        <StudyChart key={spec.title} spec={spec} names={{ x: `${one.dimensions[0] ?? "x"}${spec.equal ? "-map" : ""}`, y: `${one.name}-${index}` }} height={300} />
      ))}
    </div>
  );
}
