/** The contact page: material, law, fit and one solution; what is not shown is not computed. */

import { useView } from "../../state/store";
import { withFields } from "../../state/view";
import { useApp } from "../../ui/app";
import { ErrorNote, unlessSaid } from "../../ui/ErrorNote";
import { useCaseFile } from "../../ui/files";
import { Link } from "../../ui/Link";
import { Page } from "../../ui/Page";
import { type Analysis, fetchCaseFile, lawOfCase } from "../../wire/api";
import { FitPart } from "./FitPart";
import { LawPart } from "./LawPart";
import { MaterialPart } from "./MaterialPart";
import { SolutionPart, shownSolution } from "./SolutionPart";
import { MODULUS, type Part, fitAnalysis, lawAnalysis } from "./state";
import { type Contact, useContact } from "./useContact";
import "./contact.css";

const PARTS: readonly (readonly [Part, string])[] = [
  ["material", "Material"],
  ["law", "Contact law"],
  ["fit", "Fit"],
  ["solution", "One solution"],
];

const COMPONENTS = { material: MaterialPart, law: LawPart, fit: FitPart, solution: SolutionPart };

export function ContactPage() {
  const { store, error: refused } = useApp();
  const view = useView(store);
  const contact = useContact();
  useContactCaseFile(contact);
  const { part } = contact.state;
  const Shown = COMPONENTS[part];
  return (
    <Page title="Contact">
      <nav class="contact-parts" aria-label="Parts of the contact">
        {PARTS.map(([name, title]) => (
          <Link key={name} to={withFields(view, { part: name })} current={name === part}>
            {title}
          </Link>
        ))}
      </nav>
      {part !== "solution" && <ErrorNote error={unlessSaid(contact.live.error, refused)} />}
      <Shown contact={contact} />
    </Page>
  );
}

/** The analysis that computes what is shown; the fitted laws are no analysis but a key of the case. */
function shownAnalysis(contact: Contact, law: string | null | undefined): Analysis | null {
  switch (contact.state.part) {
    case "material":
      return MODULUS;
    case "fit":
      return fitAnalysis(contact.state);
    case "solution":
      return shownSolution(contact);
    case "law":
      return !contact.derived || law === "bem" ? lawAnalysis(contact.state) : null;
  }
}

function useContactCaseFile(contact: Contact): void {
  const { session, store } = useApp();
  useCaseFile(() => {
    const { set, derived } = contact;
    const analysis = shownAnalysis(contact, store.view.set["contact.law"] ?? lawOfCase(session)?.value);
    return { text: fetchCaseFile(set, analysis, derived && analysis ? "contact" : undefined) };
  });
}
