/** Any analysis: what its report shows, its scalars, and its arrays as charts. */

import { useMemo, useState } from "preact/hooks";
import { ErrorNote } from "../../ui/ErrorNote";
import { Label } from "../../ui/Label";
import { Busy } from "./Busy";
import { type ArraysRequest, drawable, requestsOf, undrawn } from "./generic";
import { genericCharts } from "./genericCharts";
import { ReportTables } from "./ReportTables";
import { reportCharts } from "./reportCharts";
import { Scalars } from "./Scalars";
import { StudyChart } from "./StudyChart";
import type { StudyAnalysis } from "./study";
import { useArrays } from "./useArrays";
import { type Report, useReport } from "./useReport";

export function GenericView({ analysis }: { readonly analysis: StudyAnalysis }) {
  const live = useReport(analysis);
  if (live.busy && !live.report) return <Busy live={live} words="Drawing the figure…" />;
  const isDrawn = live.report?.figure != null;
  return (
    <>
      <ErrorNote error={live.error ?? live.report?.error ?? null} />
      {live.report && <Reported report={live.report} />}
      <Scalars analysis={analysis} open={!isDrawn} />
      {isDrawn ? <FoldedCharts analysis={analysis} /> : <GenericCharts analysis={analysis} without={[]} />}
    </>
  );
}

/** The figure of the report, its caption and its tables. */
function Reported({ report: { figure, tables } }: { readonly report: Report }) {
  const charts = useMemo(() => (figure ? reportCharts(figure) : []), [figure]);
  return (
    <>
      {figure && (
        <>
          <div class="study-grid">
            {charts.map(({ spec, names, height }) => (
              <StudyChart key={spec.title} spec={spec} names={names} height={height} />
            ))}
          </div>
          {figure.caption && (
            <p class="study-note">
              <Label text={figure.caption} />
            </p>
          )}
        </>
      )}
      <ReportTables tables={tables} />
    </>
  );
}

/** The arrays beside a figure that is made of them: read when they are asked for. */
function FoldedCharts({ analysis }: { readonly analysis: StudyAnalysis }) {
  const [open, setOpen] = useState(false);
  if (drawable(analysis, []).length + undrawn(analysis, []).length === 0) return null;
  return (
    <details class="scalars" onToggle={({ currentTarget }) => setOpen(currentTarget.open)}>
      <summary>All arrays of {analysis.name}</summary>
      {open && <GenericCharts analysis={analysis} without={[]} />}
    </details>
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
