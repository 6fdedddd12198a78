/** The analyses of the study, by kind; the picked one is in the address. */

import { Warnings } from "../../ui/Warnings";
import { useView } from "../../state/store";
import { useApp } from "../../ui/app";
import { Link } from "../../ui/Link";
import { withAnalysis } from "./state";
import { type Study, type StudyAnalysis, byKind } from "./study";

const MARKS: Readonly<Record<string, string>> = { done: "✓", failed: "✗", running: "…", warning: "!" };

export function AnalysisList({ study, picked }: { readonly study: Study; readonly picked: StudyAnalysis | undefined }) {
  const { store } = useApp();
  const view = useView(store);
  return (
    <nav class="analysis-list" aria-label="Analyses of the study">
      <h2>{study.name}</h2>
      <p class="analysis-study">
        <span data-key="study.model">{study.model}</span>, judder <span data-key="study.version">{study.version}</span>
      </p>
      <Warnings of="the study" warnings={study.warnings} />
      {byKind(study.analyses).map(({ kind, analyses }) => (
        <section key={kind} aria-label={`Analyses of the kind ${kind}`}>
          <h3>{kind}</h3>
          <ul>
            {analyses.map((analysis) => (
              <li key={analysis.name}>
                <Link to={withAnalysis(view, picked, analysis)} current={analysis === picked}>
                  {analysis.name}
                </Link>
                <span class="analysis-status" title={analysis.status}>
                  <span aria-hidden="true">{MARKS[analysis.status] ?? "•"}</span>
                  <span class={analysis.status === "done" ? "visually-hidden" : ""}>{analysis.status}</span>
                  {analysis.warnings.length > 0 && <span class="analysis-warned">{analysis.warnings.length} ⚠</span>}
                </span>
              </li>
            ))}
          </ul>
        </section>
      ))}
    </nav>
  );
}
