/** The oscillator paper's functions fitted to contacts that are computed for the case's substrate. */

import { Digits } from "../../ui/Digits";
import { useMemo } from "preact/hooks";
import { Chart } from "../../chart/Chart";
import { written } from "../../chart/readout";
import type { Range } from "../../chart/scale";
import { QUANTITIES, anyLogRange } from "../../state/fields";
import { withFields } from "../../state/view";
import { useApp } from "../../ui/app";
import { ErrorNote } from "../../ui/ErrorNote";
import { Warnings } from "../../ui/Warnings";
import { Label } from "../../ui/Label";
import { SettingControls } from "../../ui/SettingControls";
import { TextField } from "../../ui/TextField";
import { type Coefficient, coefficientsOf, curvesSpec, fitOf, residualSpec } from "./fit";
import { type Outcome, outcomeOf, scalarAt } from "../../wire/outcome";
import { Checks, QuantityChoice, Results, Run, Scroll, shownError } from "./Parts";
import { type ContactState, type Quantity, fitAnalysis } from "./state";
import { useComputation } from "../../ui/useComputation";
import { type Contact, contactBody } from "./useContact";
import { QUANTITY_NAMES } from "./words";

export function FitPart({ contact }: { readonly contact: Contact }) {
  const { error: refused } = useApp();
  const { state, derived } = contact;
  const { quantity } = state;
  const computation = useComputation("/api/analysis", contactBody(contact, fitAnalysis(state)), "contact-fit", { live: derived });
  const { frame } = computation;
  const fit = useMemo(() => (frame ? fitOf(frame) : null), [frame]);
  const curves = useMemo(() => curvesSpec(fit, quantity), [fit, quantity]);
  const residual = useMemo(() => residualSpec(fit, quantity), [fit, quantity]);
  const outcome = frame && outcomeOf(frame);
  return (
    <>
      <div class="contact-tools">
        <QuantityChoice value={quantity} />
        <SettingControls kind="fit" first={["velocity_scale", "accuracy"]} error={computation.error} />
      </div>
      <Ranges state={state} />
      <Run computation={computation} what="the fit" live={derived} />
      <ErrorNote error={shownError(computation, refused)} />
      {outcome && (
        <Results computation={computation}>
          <Warnings warnings={outcome.warnings} />
          <div class="contact-charts">
            <Chart spec={curves} height={400} />
            <Chart spec={residual} height={400} />
          </div>
          <div class="contact-columns contact-wide">
            <Coefficients outcome={outcome} />
            <Checks checks={outcome.checks} />
          </div>
        </Results>
      )}
      {!outcome && !computation.busy && !computation.error && (
        <p class="contact-note">
          Contacts are computed over speed and depth; then the three functions of the oscillator paper are fitted to them (its Fig. 14).
        </p>
      )}
    </>
  );
}

/** What the contacts are computed over; the address keeps it for the law, too. */
function Ranges({ state }: { readonly state: ContactState }) {
  const { store } = useApp();
  const keep = (change: Readonly<Record<string, string | undefined>>) => store.update((view) => withFields(view, change));
  return (
    <div class="contact-tools">
      <RangeField name="speeds v τ/R" range={state.fitSpeeds} onChange={(speeds) => keep({ speeds })} />
      <RangeField name="depths δ/R" range={state.fitDepths} onChange={(depths) => keep({ depths })} />
      <button type="button" disabled={!state.hasRanges} onClick={() => keep({ speeds: undefined, depths: undefined })}>
        The paper's ranges
      </button>
    </div>
  );
}

interface RangeFieldProps {
  readonly name: string;
  readonly range: Range;
  readonly onChange: (text: string) => void;
}

function RangeField({ name, range: [from, to], onChange }: RangeFieldProps) {
  return (
    <fieldset class="contact-choice contact-range">
      <legend class="visually-hidden">{name}</legend>
      <span aria-hidden="true">{name}</span>
      <TextField spoken={`from, ${name}`} value={written(from)} accepts={(text) => anyLogRange(`${text},${to}`)} onChange={(text) => onChange(`${text},${to}`)} />
      <span aria-hidden="true">…</span>
      <TextField spoken={`to, ${name}`} value={written(to)} accepts={(text) => anyLogRange(`${from},${text}`)} onChange={(text) => onChange(`${from},${text}`)} />
    </fieldset>
  );
}

const FUNCTIONS: Record<Quantity, string> = { force: "eq. (34)", area: "eq. (36)", friction: "eq. (38)" };

function Coefficients({ outcome }: { readonly outcome: Outcome }) {
  const all = QUANTITIES.map((quantity) => ({ quantity, coefficients: coefficientsOf(outcome, quantity) }));
  const paper = all.some(({ coefficients }) => coefficients.some((coefficient) => coefficient.paper !== null));
  return (
    <Scroll name="Coefficients">
      <table class="contact-table">
        <caption>
          Coefficients, from <Scalar outcome={outcome} path="sample_count" /> points and <Scalar outcome={outcome} path="contacts_solved" /> solved contacts
        </caption>
        <thead>
          <tr>
            <th scope="col">name</th>
            <th scope="col">value</th>
            <th scope="col">standard error</th>
            {paper && <th scope="col">the paper's</th>}
          </tr>
        </thead>
        {all.map(({ quantity, coefficients }) => (
          <tbody key={quantity}>
            <tr>
              <th scope="rowgroup" colSpan={paper ? 4 : 3}>
                {QUANTITY_NAMES[quantity]}, {FUNCTIONS[quantity]}: r² = <Scalar outcome={outcome} path={`${quantity}.r2`} />
              </th>
            </tr>
            {coefficients.map((coefficient) => (
              <Row key={coefficient.name} outcome={outcome} coefficient={coefficient} paper={paper} />
            ))}
          </tbody>
        ))}
      </table>
    </Scroll>
  );
}

function Row({ outcome, coefficient, paper }: { readonly outcome: Outcome; readonly coefficient: Coefficient; readonly paper: boolean }) {
  return (
    <tr>
      <th scope="row">
        <Label text={coefficient.name} />
      </th>
      <td>
        <Scalar outcome={outcome} path={coefficient.value} />
      </td>
      <td>
        <Scalar outcome={outcome} path={coefficient.standardError} />
      </td>
      {paper && <td>{coefficient.paper ? <Scalar outcome={outcome} path={coefficient.paper} /> : "—"}</td>}
    </tr>
  );
}

/** A number of the outcome. */
function Scalar({ outcome, path }: { readonly outcome: Outcome; readonly path: string }) {
  const value = scalarAt(outcome.scalars, path);
  return <Digits dataKey={`scalars.${path}`} value={typeof value === "number" ? value : null} />;
}
