/** Steady sliding: the bodies as it moves them, what the contact points carry, and which of them are open. */

import { useMemo } from "preact/hooks";
import { ErrorNote } from "../../ui/ErrorNote";
import { Busy } from "./Busy";
import { swingOf } from "./body";
import { ContactTable } from "./ContactTable";
import { CONTACT_POINTS, type ContactPoints, contactSums, readContacts } from "./contacts";
import { GenericCharts } from "./GenericView";
import { interfaceSpecs } from "./interfaces";
import { short } from "./locus";
import { marksOf } from "./marks";
import { ShapeView } from "./ShapeView";
import { StudyChart } from "./StudyChart";
import { type StudyAnalysis, variable } from "./study";
import { numbers, useArrays } from "./useArrays";
import { BODY, SHAPE, hasShapes, useBody } from "./useBody";

export function SteadyView({ analysis }: { readonly analysis: StudyAnalysis }) {
  const live = useArrays(analysis.name, CONTACT_POINTS, {}, "contacts");
  const contacts = useMemo(() => (live.arrays ? readContacts(live.arrays) : null), [live.arrays]);
  const sums = contactSums(analysis);
  const charts = useMemo(() => {
    const names = [...new Set(contacts?.contact ?? [])];
    return names.flatMap((name, k) => (contacts ? interfaceSpecs(contacts, name).map((spec, part) => ({ spec, names: axisNames(k, part) })) : []));
  }, [contacts]);
  if (!contacts) return <Busy live={live} words="Reading the contact points…" />;
  return (
    <>
      <Balance analysis={analysis} />
      <ContactTable analysis={analysis.name} contacts={sums} />
      {hasShapes(analysis) ? <Bodies analysis={analysis} contacts={contacts} /> : <p>No shapes are stored: the study does not say where its freedoms lie.</p>}
      <div class="study-grid interfaces">
        {charts.map(({ spec, names }) => (
          <StudyChart key={spec.title} spec={spec} names={names} height={380} />
        ))}
      </div>
      <GenericCharts analysis={analysis} without={[...CONTACT_POINTS, ...BODY, SHAPE, "friction_force"]} />
    </>
  );
}

/** Both charts of an interface along a line move together along it. */
function axisNames(contact: number, part: number): { readonly x: string; readonly y: string } {
  return { x: `place-${contact}`, y: `carried-${contact}-${part}` };
}

/** Whether the answer is one. */
function Balance({ analysis: { name, scalars } }: { readonly analysis: StudyAnalysis }) {
  const { converged, residual } = scalars;
  if (typeof converged !== "boolean") return null;
  const left = typeof residual === "number" ? `: forces are out of balance by ${short(residual)} of all forces` : "";
  return (
    <p class={converged ? "completeness" : "completeness completeness-open"} data-key={`${name}.converged`} data-value={String(converged)}>
      {converged ? "Converged" : "Not converged"}
      {left}.
    </p>
  );
}

/** The bodies, displacements enlarged, with the contact points on them. */
function Bodies({ analysis, contacts }: { readonly analysis: StudyAnalysis; readonly contacts: ContactPoints }) {
  const { body, error } = useBody(analysis);
  const shape = useArrays(analysis.name, [SHAPE], {}, SHAPE);
  const swing = useMemo(() => (body && shape.arrays ? swingOf(body, numbers(shape.arrays, SHAPE), false) : null), [body, shape.arrays]);
  const marks = useMemo(() => (body ? marksOf(body, contacts) : null), [body, contacts]);
  return (
    <>
      <ErrorNote error={error ?? shape.error} />
      {body && swing ? (
        <ShapeView title={`Contact map of ${analysis.name}`} body={body} swing={swing} motion={null} unit={variable(analysis, SHAPE)?.units ?? ""} marks={marks} />
      ) : (
        <p role="status">Reading the shape…</p>
      )}
    </>
  );
}
