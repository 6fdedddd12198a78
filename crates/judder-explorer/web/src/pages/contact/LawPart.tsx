/** The contact law over speed and depth: a map with a cursor, and cuts through it. */

import { useMemo } from "preact/hooks";
import { Chart } from "../../chart/Chart";
import type { Cursor, Phase } from "../../chart/interaction";
import type { Window } from "../../chart/scale";
import { useApp } from "../../ui/app";
import { ErrorNote } from "../../ui/ErrorNote";
import { Warnings } from "../../ui/Warnings";
import { Label } from "../../ui/Label";
import { WordChoice } from "../../ui/ParameterPanel";
import { SettingControls } from "../../ui/SettingControls";
import { Value } from "../../ui/Value";
import { lawOfCase } from "../../wire/api";
import type { Frame } from "../../wire/frames";
import { type Law, type Operating, coloured, depthCutSpec, lawOf, mapSpec, nodeAt, speedCutSpec } from "./law";
import { numberAt, outcomeOf } from "../../wire/outcome";
import { Choice, QuantityChoice, Results, Run, shownError } from "./Parts";
import { type Place, type Quantity, lawAnalysis, lawSpans, withCursor, withWindow } from "./state";
import { useComputation } from "../../ui/useComputation";
import { type Contact, contactBody, siValue } from "./useContact";
import { shortNumber } from "./words";

export function LawPart({ contact }: { readonly contact: Contact }) {
  const { session, store, error: refused } = useApp();
  const { state, derived, operating, values } = contact;
  const computation = useLaw(contact);
  const beside = useBeside(contact);
  const law = useMemo(() => (computation.frame ? lawOf(computation.frame) : null), [computation.frame]);
  const cursor = state.cursor ?? operating ?? middle(state.speeds, state.depths);
  const contrast = contrastOf(contact, computation.frame);
  const map = useMemo(() => mapSpec(law, state, operating), [law, state, operating]);
  const point = useOperating(contact);
  const parts = { law, state, cursor, beside: beside.law, contrast, operating: point };
  const choice = lawOfCase(session);
  const dependencies = [law, state, cursor.velocity, cursor.indentation, beside.law, contrast, point];
  const overSpeed = useMemo(() => speedCutSpec(parts), dependencies);
  const overDepth = useMemo(() => depthCutSpec(parts), dependencies);
  const onCursor = ({ x, y }: Cursor, keep: "push" | "quiet") =>
    store.update((view) => withCursor(view, { velocity: x, indentation: y }), keep);
  const onWindow = (window: Window | null, phase: Phase) => store.update((view) => withWindow(view, window), phase);
  const warnings = (computation.frame?.header["warnings"] as readonly string[] | undefined) ?? [];
  return (
    <>
      <div class="contact-tools">
        <QuantityChoice value={state.quantity} />
        {derived && choice && (
          <>
            <WordChoice choice={choice} />
            <Choice name="compare with" field="compare" value={state.compare ?? ""} options={[["", "nothing"], ...choice.words.map((law) => [law, law] as const)]} />
          </>
        )}
        {!derived && <SettingControls kind="contact-law" first={["accuracy", "method"]} error={computation.error} />}
        {!derived && <p class="contact-note">A case of a contact has no law of its own: this is the one computed for its substrate and shape.</p>}
      </div>
      <Run computation={computation} what="the law" live={derived} />
      <ErrorNote error={shownError(computation, refused)} />
      {law && (
        <Results computation={computation} isWhole={beside.isCurrent && isPointCurrent(contact)}>
          <Warnings warnings={warnings} />
          <div class="contact-law">
            <div class="contact-law-map">
              <Chart
                spec={map}
                height={430}
                window={{ x: state.speeds, y: state.depths }}
                onWindow={onWindow}
                cursor={{ x: cursor.velocity, y: cursor.indentation }}
                onCursor={(next) => next && onCursor(next, "quiet")}
                onPick={(next) => onCursor(next, "push")}
              />
              <Darkest law={law} quantity={state.quantity} />
              <AtCursor law={law} cursor={cursor} contact={contact} name={lawName(computation.frame?.header["law"], values !== null)} />
            </div>
            <div class="contact-law-cuts">
              <Chart spec={overSpeed} height={330} />
              <Chart spec={overDepth} height={330} />
            </div>
          </div>
        </Results>
      )}
    </>
  );
}

/** What the colours leave out. */
function Darkest({ law, quantity }: { readonly law: Law; readonly quantity: Quantity }) {
  const range = coloured(law, quantity);
  if (!range) return <p class="contact-note">This law has no viscoelastic friction: it is zero everywhere.</p>;
  if (law.values[quantity].every((value) => value >= range[0])) return null;
  return (
    <p class="contact-note">
      The darkest colour is <Label text={shortNumber(range[0])} /> and less.
    </p>
  );
}

/** The law of an oscillator at once; that of a contact case, which may take minutes, when it is asked for. */
function useLaw(contact: Contact) {
  const { set, state, derived } = contact;
  const law = useComputation("/api/law", derived ? { set, ...lawSpans(state) } : null, "contact-law", { live: derived });
  const computed = useComputation("/api/analysis", derived ? null : contactBody(contact, lawAnalysis(state)), "contact-law-computed", { live: false });
  return derived ? law : computed;
}

/** Another law in the same plane. */
function useBeside({ set, state, derived }: Contact) {
  const { compare } = state;
  const asked = derived && compare ? { set: [...set.filter((option) => !option.startsWith("contact.law=")), `contact.law=${compare}`], ...lawSpans(state) } : null;
  const { frame, current } = useComputation("/api/law", asked, "contact-law-beside");
  const law = useMemo(() => (asked && frame && compare ? { law: lawOf(frame), name: String(frame.header["law"] ?? compare) } : null), [frame, asked === null]);
  return { law, isCurrent: law === null || current };
}

/** Whether the operating point that is marked is that of the present values. */
function isPointCurrent({ live, set }: Contact): boolean {
  return live.point === null || live.error !== null || live.set === JSON.stringify(set);
}

function useOperating({ live, operating }: Contact): Operating | null {
  return useMemo(() => {
    const said = live.point?.point.contact;
    if (!said || !operating) return null;
    const { force = Number.NaN, area = Number.NaN, viscoelastic_friction: friction = Number.NaN } = said;
    return { place: operating, values: { force, area, friction } };
  }, [live.point, operating]);
}

function lawName(name: unknown, known: boolean): string {
  return known && typeof name === "string" ? name : "computed";
}

/** E∞/E0, as a computed law tells it, or of the case's moduli. */
function contrastOf({ values }: Contact, frame: Frame | null): number | null {
  const told = frame ? numberAt(outcomeOf(frame).scalars, "contrast") : Number.NaN;
  if (told > 0) return told;
  const [rubbery, glassy] = [siValue(values, "substrate.rubbery_modulus"), siValue(values, "substrate.glassy_modulus")];
  return rubbery && glassy ? glassy / rubbery : null;
}

function middle(speeds: readonly [number, number], depths: readonly [number, number]): Place {
  return { velocity: Math.sqrt(speeds[0] * speeds[1]), indentation: Math.sqrt(depths[0] * depths[1]) };
}

interface AtCursorProps {
  readonly law: Law;
  readonly cursor: Place;
  readonly contact: Contact;
  readonly name: string;
}

/** The law at the computed node next to the cursor, and at the operating point. */
function AtCursor({ law, cursor, contact, name }: AtCursorProps) {
  const { store } = useApp();
  const { live, operating, state } = contact;
  const { row, column } = nodeAt(law, cursor);
  const at = (values: Float64Array) => values[row * law.velocity.length + column] ?? null;
  const point = live.point?.point;
  return (
    <div class="contact-columns">
      <section aria-label="At the cursor">
        <h2>At the cursor ({name})</h2>
        <dl class="values">
          <Value name="speed $v τ$/$R$" dataKey="law.velocity" value={law.velocity[column]} />
          <Value name="depth $δ$/$R$" dataKey="law.indentation" value={law.indentation[row]} />
          <Value name="force $F$/($E_{0}$* $R$²)" dataKey="law.force" value={at(law.values.force)} />
          <Value name="area $A$/$R$²" dataKey="law.area" value={at(law.values.area)} />
          <Value name="viscoelastic friction" dataKey="law.friction" value={at(law.values.friction)} />
        </dl>
      </section>
      {point && operating && (
        <section aria-label="Operating point">
          <h2>Operating point</h2>
          <dl class="values">
            <Value name="speed $v τ$/$R$" dataKey="groups.velocity" value={operating.velocity} />
            <Value name="depth $δ$/$R$" dataKey="equilibrium.indentation" value={operating.indentation} />
            <Value name="force $F$/($E_{0}$* $R$²)" dataKey="contact.force" value={point.contact["force"]} />
            <Value name="area $A$/$R$²" dataKey="contact.area" value={point.contact["area"]} />
            <Value name="viscoelastic friction" dataKey="contact.viscoelastic_friction" value={point.contact["viscoelastic_friction"]} />
          </dl>
          {state.cursor && (
            <button type="button" onClick={() => store.update((view) => withCursor(view, null))}>
              Cursor to the operating point
            </button>
          )}
        </section>
      )}
    </div>
  );
}
