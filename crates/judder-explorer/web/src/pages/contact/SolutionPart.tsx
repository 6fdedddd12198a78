/** One contact with its fields: at the operating point, or at a speed and a depth or load. */

import { useMemo } from "preact/hooks";
import { Chart } from "../../chart/Chart";
import { written } from "../../chart/readout";
import { withFields } from "../../state/view";
import { Select } from "../../ui/choices";
import { useApp } from "../../ui/app";
import { ErrorNote } from "../../ui/ErrorNote";
import { Warnings } from "../../ui/Warnings";
import { blames } from "../../ui/meant";
import { SettingControls } from "../../ui/SettingControls";
import { TextField } from "../../ui/TextField";
import { Value } from "../../ui/Value";
import type { Analysis } from "../../wire/api";
import type { RequestError } from "../../wire/request";
import { type Outcome, outcomeOf, scalarAt } from "../../wire/outcome";
import { Checks, Results, Run, shownError } from "./Parts";
import { fieldSpec, pressureCutSpec, solutionOf, surfaceCutSpec } from "./solution";
import { type Loading, solutionAnalysis, withLoading } from "./state";
import { useComputation } from "../../ui/useComputation";
import { CONTACT_HOME, type Contact, contactBody } from "./useContact";

/** The contact that is shown; null while the operating point is not known. */
export function shownSolution({ state, operating, derived }: Contact): Analysis | null {
  const home = derived ? operating : CONTACT_HOME;
  const isPlaced = state.velocity !== null && state.loading !== null;
  return home || isPlaced ? solutionAnalysis(state, home ?? CONTACT_HOME) : null;
}

export function SolutionPart({ contact }: { readonly contact: Contact }) {
  const { error: refused } = useApp();
  const analysis = shownSolution(contact);
  const computation = useComputation("/api/analysis", analysis && contactBody(contact, analysis), "contact-solution");
  const { frame } = computation;
  const solution = useMemo(() => (frame ? solutionOf(frame) : null), [frame]);
  const specs = useMemo(
    () => ({
      pressure: fieldSpec(solution, "pressure"),
      gap: fieldSpec(solution, "gap"),
      pressures: pressureCutSpec(solution),
      surfaces: surfaceCutSpec(solution),
    }),
    [solution],
  );
  const outcome = frame && outcomeOf(frame);
  const isLine = solution !== null && solution.pressure.y.length < 2;
  return (
    <>
      <SolutionTools contact={contact} analysis={analysis} isLine={isLine} error={computation.error} />
      <Run computation={computation} what="the contact" live={analysis !== null} />
      {contact.derived && !analysis && <ErrorNote error={contact.live.error} />}
      <ErrorNote error={shownError(computation, refused)} />
      {outcome && (
        <Results computation={computation}>
          <Warnings warnings={outcome.warnings} />
          <div class="contact-charts">
            {!isLine && <Chart spec={specs.pressure} height={400} />}
            {!isLine && <Chart spec={specs.gap} height={400} />}
            <Chart spec={specs.pressures} height={330} />
            <Chart spec={specs.surfaces} height={330} />
          </div>
          <div class="contact-columns">
            <Numbers outcome={outcome} isLine={isLine} />
            {contact.derived && contact.live.point && isHome(contact) && <LawBeside contact={contact} />}
            <Checks checks={outcome.checks} />
          </div>
        </Results>
      )}
    </>
  );
}

function isHome({ state }: Contact): boolean {
  return state.velocity === null && state.loading === null;
}

interface ToolsProps {
  readonly contact: Contact;
  readonly analysis: Analysis | null;
  readonly isLine: boolean;
  readonly error: RequestError | null;
}

function SolutionTools({ contact, analysis, isLine, error }: ToolsProps) {
  const { store } = useApp();
  const { state, derived } = contact;
  const key: Loading["key"] = state.loading?.key ?? "indentation";
  const shown = (name: string) => {
    const value = analysis?.[name] ?? "";
    return typeof value === "number" ? written(value) : String(value);
  };
  const press = (loading: Loading | null) => store.update((view) => withLoading(view, loading));
  const changeKey = (next: Loading["key"]) => {
    // a depth is no load: the operating point's own, or a small load
    const load = contact.live.point?.point.contact["force"] ?? 1e-3;
    press(next === "load" ? { key: "load", value: String(load) } : null);
  };
  return (
    <div class="contact-tools">
      <label class="contact-choice">
        speed v τ/R
        <TextField id="contact-velocity" class="parameter-text" spoken="speed, a number or a text with a unit" value={shown("velocity")} invalid={blames(error, "velocity")} onChange={(text) => store.update((view) => withFields(view, { velocity: text === "" ? undefined : text }))} />
      </label>
      <span class="contact-choice">
        <Select
          spoken="What presses the indenter down"
          value={key}
          options={[["indentation", "depth δ/R"], ["load", `load ${isLine ? "F/(E₀* R)" : "F/(E₀* R²)"}`]]}
          onChange={changeKey}
        />
        <TextField id="contact-loading" class="parameter-text" spoken={`${key === "load" ? "load" : "depth"}, a number or a text with a unit`} value={shown(key)} invalid={blames(error, key)} onChange={(text) => press(text === "" ? null : { key, value: text })} />
      </span>
      <SettingControls kind="contact" first={["accuracy"]} error={error} />
      <button type="button" disabled={isHome(contact)} onClick={() => store.update((view) => withFields(withLoading(view, null), { velocity: undefined }))}>
        {derived ? "At the operating point" : "Reset"}
      </button>
    </div>
  );
}

/** A line contact's force and area are per length. */
const LINE_NAMES: Readonly<Record<string, string>> = { force: "force $F$/($E_{0}$* $R$)", area: "width over $R$" };

const VALUES = [
  ["force $F$/($E_{0}$* $R$²)", "force", "1"],
  ["force", "force_newton", "N"],
  ["relative error of the force", "force_error", "1"],
  ["area $A$/$R$²", "area", "1"],
  ["area", "area_square_metre", "m²"],
  ["relative error of the area", "area_error", "1"],
  ["viscoelastic friction", "friction", "1"],
  ["from the dissipation", "friction_from_dissipation", "1"],
  ["relative error of the friction", "friction_error", "1"],
  ["depth $δ$/$R$", "indentation", "1"],
  ["depth", "indentation_metre", "m"],
  ["largest pressure $p$/$E_{0}$*", "peak_pressure", "1"],
  ["largest pressure", "peak_pressure_pascal", "Pa"],
  ["speed", "velocity_metre_per_second", "m/s"],
  ["cells a side", "cells", "1"],
  ["iterations", "iterations", "1"],
  ["residual", "residual", "1"],
  ["converged", "converged", "1"],
] as const;

function Numbers({ outcome: { scalars }, isLine }: { readonly outcome: Outcome; readonly isLine: boolean }) {
  return (
    <section aria-label="The contact in numbers">
      <h2>Contact</h2>
      <dl class="values">
        {VALUES.filter(([, key]) => scalarAt(scalars, key) !== null).map(([name, key, unit]) => (
          <Value key={key} name={(isLine && LINE_NAMES[key]) || name} dataKey={`scalars.${key}`} value={scalarAt(scalars, key)} unit={unit} />
        ))}
      </dl>
    </section>
  );
}

/** What the case's law says at the same speed and depth. */
function LawBeside({ contact }: { readonly contact: Contact }) {
  const point = contact.live.point?.point;
  return (
    <section aria-label="The law there">
      <h2>The case's law there</h2>
      <dl class="values">
        <Value name="force $F$/($E_{0}$* $R$²)" dataKey="contact.force" value={point?.contact["force"]} />
        <Value name="area $A$/$R$²" dataKey="contact.area" value={point?.contact["area"]} />
        <Value name="viscoelastic friction" dataKey="contact.viscoelastic_friction" value={point?.contact["viscoelastic_friction"]} />
      </dl>
    </section>
  );
}
