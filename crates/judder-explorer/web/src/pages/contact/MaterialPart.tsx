/** Storage and loss modulus and loss tangent of the substrate, redrawn as its keys move. */

import { useMemo } from "preact/hooks";
import { Chart } from "../../chart/Chart";
import { useApp } from "../../ui/app";
import { ErrorNote } from "../../ui/ErrorNote";
import { Warnings } from "../../ui/Warnings";
import { Value } from "../../ui/Value";
import { type Mark, modulusSpec, tangentSpec } from "./material";
import { outcomeOf, scalarAt } from "../../wire/outcome";
import { Checks, Results, shownError } from "./Parts";
import { MODULUS } from "./state";
import { useComputation } from "../../ui/useComputation";
import { type Contact, contactBody } from "./useContact";

const VALUES = [
  ["rubbery modulus $E_{0}$", "rubbery_modulus_pascal", "Pa"],
  ["glassy modulus $E_{∞}$", "glassy_modulus_pascal", "Pa"],
  ["contrast $E_{∞}$/$E_{0}$", "contrast", "1"],
  ["retardation times", "terms", "1"],
  ["mean retardation time", "mean_retardation_time_second", "s"],
  ["largest loss tangent", "largest_loss_tangent", "1"],
  ["its frequency", "frequency_of_largest_loss_tangent", "rad/s"],
] as const;

export function MaterialPart({ contact }: { readonly contact: Contact }) {
  const { error: refused } = useApp();
  const computation = useComputation("/api/analysis", contactBody(contact, MODULUS), "contact-modulus");
  const { frame } = computation;
  const marks = useMarks(contact);
  const modulus = useMemo(() => modulusSpec(frame, marks), [frame, marks]);
  const tangent = useMemo(() => tangentSpec(frame, marks), [frame, marks]);
  const outcome = frame && outcomeOf(frame);
  return (
    <>
      <ErrorNote error={shownError(computation, refused)} />
      {outcome && (
        <Results computation={computation}>
          <Warnings warnings={outcome.warnings} />
          <div class="contact-charts">
            <Chart spec={modulus} height={440} />
            <Chart spec={tangent} height={440} />
          </div>
          <div class="contact-columns">
            <section aria-label="Material in numbers">
              <h2>Material</h2>
              <dl class="values">
                {VALUES.map(([name, key, unit]) => (
                  <Value key={key} name={name} dataKey={`scalars.${key}`} value={scalarAt(outcome.scalars, key)} unit={unit} />
                ))}
              </dl>
            </section>
            <Checks checks={outcome.checks} />
          </div>
        </Results>
      )}
    </>
  );
}

/** The frequency at which the operating point's contact is passed, v/a with π a² = A, and that of the oscillator. */
function useMarks({ live, values }: Contact): readonly Mark[] {
  const [speed, area] = [live.point?.dimensional["velocity_m_per_s"], live.point?.dimensional["area_m2"]];
  const natural = values?.scales["natural_frequency"];
  return useMemo(() => {
    const marks: Mark[] = [];
    if (speed && area) marks.push({ name: "contact passed, $v$/$a$", at: speed / Math.sqrt(area / Math.PI), role: { series: 3 } });
    if (natural) marks.push({ name: "oscillator, $ω_{nx}$", at: natural, role: { series: 5 } });
    return marks;
  }, [speed, area, natural]);
}
