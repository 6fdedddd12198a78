/** Any analysis: its scalars, its texts and its arrays as charts. */

import { useMemo } from "preact/hooks";
import { Busy } from "./Busy";
import { type ArraysRequest, drawable, requestsOf, undrawn } from "./generic";
import { genericCharts } from "./genericCharts";
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
  const left = undrawn(analysis, without);
  return (
    <>
      {requestsOf(analysis, drawable(analysis, without)).map((request) => (
        <Requested key={request.names.join()} analysis={analysis} request={request} />
      ))}
      {left.length > 0 && <p class="study-note">Not drawn: {left.map(([name, reason]) => `${name} (${reason})`).join(", ")}. The study folder has the values.</p>}
    </>
  );
}

interface RequestedProps {
  readonly analysis: StudyAnalysis;
  readonly request: ArraysRequest;
}

function Requested({ analysis, request }: RequestedProps) {
  const live = useArrays(analysis.name, request.names, request.part, `generic/${request.names[0]}`);
  const charts = useMemo(() => {
    const { arrays } = live;
    return arrays ? request.drawn.flatMap((one) => genericCharts(analysis, one, arrays, request.part)) : [];
  }, [live.arrays, analysis]);
  if (!live.arrays) return <Busy live={live} words="Reading the arrays…" />;
  return (
    <div class="study-grid">
      {charts.map(({ spec, names, height, note, dataOf }) => (
        <StudyChart key={spec.title} spec={spec} names={names} height={height} note={note} dataOf={dataOf} />
      ))}
    </div>
  );
}
