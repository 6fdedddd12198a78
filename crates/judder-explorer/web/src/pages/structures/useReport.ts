/** What the report of the study shows of an analysis: its figure and its tables, as the server draws them. */

import { useEffect, useState } from "preact/hooks";
import { type Figure, described } from "../../report/described";
import { useComputation } from "../../ui/useComputation";
import { RequestError, asRequestError } from "../../wire/request";
import type { StudyAnalysis } from "./study";

export interface ReportTable {
  readonly caption: string;
  readonly head: readonly string[];
  readonly rows: readonly (readonly string[])[];
}

export interface Report {
  /** None where the result is no picture, or cannot be drawn. */
  readonly figure: Figure | null;
  /** Why it cannot be drawn. */
  readonly error: RequestError | null;
  readonly tables: readonly ReportTable[];
}

export interface LiveReport {
  readonly report: Report | null;
  readonly error: RequestError | null;
  readonly busy: boolean;
  readonly cancel: () => void;
}

/** Of an analysis that failed there is nothing to ask for. */
export function useReport({ name, status }: StudyAnalysis): LiveReport {
  const request = status === "done" ? { analysis: name } : null;
  const { frame, busy, stopped, error, stop } = useComputation("/api/study/report", request, "study/report");
  const [report, setReport] = useState<Report | null>(null);
  useEffect(() => {
    let wanted = true;
    if (frame) void reportOf(frame.header).then((read) => wanted && setReport(read));
    return () => {
      wanted = false;
    };
  }, [frame]);
  const waits = request !== null && !report && !stopped && !error;
  return { report, error: busy ? null : error, busy: busy || waits, cancel: stop };
}

/** The header of an answer, the arrays of its figure unpacked. */
export async function reportOf(header: Readonly<Record<string, unknown>>): Promise<Report> {
  const { figure, undrawn, tables } = header as { figure: string | null; undrawn: { message: string; help: string | null } | null; tables: readonly ReportTable[] };
  const error = undrawn && new RequestError(undrawn.message, 0, null, undrawn.help);
  try {
    return { figure: figure === null ? null : await described(figure), error, tables };
  } catch (failure) {
    return { figure: null, error: asRequestError(failure), tables };
  }
}
