/** The structures page: the analyses of a study folder. */

import { useCallback, useEffect, useState } from "preact/hooks";
import { useView } from "../../state/store";
import { useApp } from "../../ui/app";
import { ErrorNote } from "../../ui/ErrorNote";
import { useCaseFile } from "../../ui/files";
import { Page } from "../../ui/Page";
import type { Session } from "../../wire/api";
import { RequestError, asRequestError, isAbort } from "../../wire/request";
import { Warnings } from "../../ui/Warnings";
import { AnalysisList } from "./AnalysisList";
import { GenericView } from "./GenericView";
import { LocusView } from "./LocusView";
import { MarchView } from "./MarchView";
import { ModesView } from "./ModesView";
import { Scalars } from "./Scalars";
import { SpectrogramView } from "./SpectrogramView";
import { SteadyView } from "./SteadyView";
import { CONTACT_POINTS } from "./contacts";
import { signalsOf } from "./march";
import { SPECTROGRAM } from "./spectrogram";
import { pickedAnalysis } from "./state";
import { type Study, type StudyAnalysis, fetchStudy, fetchStudyCase, hasVariables, variable } from "./study";
import { quoted } from "./words";
import "./structures.css";

export function StructuresPage() {
  const { session, store } = useApp();
  const view = useView(store);
  const { study, error } = useStudy(session.study !== null);
  const picked = study ? pickedAnalysis(view, study) : undefined;
  const missing = study && view.fields["analysis"] !== undefined && picked?.name !== view.fields["analysis"];
  return (
    <Page title="Structures" panel={false}>
      <ErrorNote error={error} />
      {session.study === null && <NoStudy of={session.case} />}
      {session.study !== null && !study && !error && <p role="status">Opening the study…</p>}
      {study && (
        <div class="structures">
          <AnalysisList study={study} picked={picked} />
          <div class="structures-main">
            {missing && <p role="status">The study has no analysis “{view.fields["analysis"]}”.</p>}
            {picked ? <Analysis key={picked.name} study={study} analysis={picked} /> : <p>The study has no analyses.</p>}
          </div>
        </div>
      )}
    </Page>
  );
}

/** How to get a study to look at; cases with pages of their own do not come here. */
function NoStudy({ of }: { readonly of: Session["case"] }) {
  return (
    <>
      <p>No study is open.{of && ` A case of model “${of.model}” is looked at in the results of a run.`}</p>
      <p>
        Run <code>judder run {quoted(of?.file ?? "CASE.toml")}</code>, then <code>judder explore {quoted(of ? `out/${of.name}` : "FOLDER")}</code>.
      </p>
    </>
  );
}

function useStudy(open: boolean): { readonly study: Study | null; readonly error: RequestError | null } {
  const [study, setStudy] = useState<Study | null>(null);
  const [error, setError] = useState<RequestError | null>(null);
  useEffect(() => {
    if (!open) return;
    const abort = new AbortController();
    fetchStudy(abort.signal).then(setStudy, (failure) => !isAbort(failure) && setError(asRequestError(failure)));
    return () => abort.abort();
  }, [open]);
  return { study, error };
}

interface AnalysisProps {
  readonly study: Study;
  readonly analysis: StudyAnalysis;
}

function Analysis({ study, analysis }: AnalysisProps) {
  const { name } = analysis;
  useCaseFile(useCallback(() => ({ name: `${study.name} ${name}`, text: fetchStudyCase(name) }), [study.name, name]));
  const took = analysis.seconds === null ? "" : `, took ${Number(analysis.seconds.toPrecision(3))} s`;
  return (
    <section aria-label={analysis.name} data-analysis={analysis.name} data-kind={analysis.kind}>
      <h2 class="analysis-title">
        {analysis.name}{" "}
        <small>
          {analysis.kind}, {analysis.status}
          {took}
        </small>
      </h2>
      <Warnings of={analysis.name} warnings={analysis.warnings} />
      {analysis.reason && <ErrorNote error={new RequestError(`${analysis.name} failed: ${analysis.reason}`, 0, null, null)} />}
      <Shown study={study} analysis={analysis} />
    </section>
  );
}

/** What an analysis has decides how it is shown, not the word for its kind. */
function Shown({ study, analysis }: AnalysisProps) {
  if (hasVariables(analysis, ...CONTACT_POINTS)) return <Seen analysis={analysis} view={<SteadyView analysis={analysis} />} />;
  const eigenvalue = variable(analysis, "eigenvalue");
  if (eigenvalue?.shape.length === 2) return <Seen analysis={analysis} view={<LocusView analysis={analysis} />} />;
  if (hasVariables(analysis, ...SPECTROGRAM)) return <Seen analysis={analysis} view={<SpectrogramView analysis={analysis} />} />;
  if (analysis.kind === "march" && signalsOf(analysis).length > 0) {
    return <Seen analysis={analysis} view={<MarchView study={study} analysis={analysis} />} without={["bursts", "sound"]} />;
  }
  // what modes grow to has frequencies too
  const isOfModes = hasVariables(analysis, "frequency", "mode") && !variable(analysis, "growth_rate");
  if (eigenvalue?.shape.length === 1 || isOfModes) {
    return <Seen analysis={analysis} view={<ModesView analysis={analysis} />} />;
  }
  return <GenericView analysis={analysis} />;
}

interface SeenProps {
  readonly analysis: StudyAnalysis;
  readonly view: preact.JSX.Element;
  readonly without?: readonly string[];
}

function Seen({ analysis, view, without = [] }: SeenProps) {
  return (
    <>
      {view}
      <Scalars analysis={analysis} without={without} />
    </>
  );
}
