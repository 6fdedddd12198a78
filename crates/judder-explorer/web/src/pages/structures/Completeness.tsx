/** Whether the modes are all that there are, as the study has found it. */

import { short } from "./locus";
import type { StudyAnalysis } from "./study";

export function Completeness({ analysis }: { readonly analysis: StudyAnalysis }) {
  const words = completeness(analysis);
  if (words === null) return null;
  const isComplete = analysis.scalars["complete"] === true;
  return (
    <p class={isComplete ? "completeness" : "completeness completeness-open"} data-key={`${analysis.name}.complete`} data-value={String(isComplete)}>
      {words}
    </p>
  );
}

/** What is known of modes that are not listed; null where the study does not tell. */
export function completeness({ scalars, attributes }: StudyAnalysis): string | null {
  const { complete } = scalars;
  if (typeof complete !== "boolean") return null;
  const within = regionWords(attributes["region"]);
  return complete ? `Complete: it is proven that ${within} holds no other eigenvalue.` : `Not proven complete: ${within} may hold eigenvalues that are not listed.`;
}

function regionWords(region: unknown): string {
  const { re, im } = (region ?? {}) as { re?: readonly number[]; im?: readonly number[] };
  if (re?.length !== 2 || im?.length !== 2) return "the region that was searched";
  const [low, high] = im.map((omega) => short(omega / (2 * Math.PI)));
  return `the searched region, ${low} to ${high} Hz with growth rates from ${short(re[0] as number)} to ${short(re[1] as number)} 1/s,`;
}
