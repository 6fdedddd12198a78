/** What the parts of the contact page share. */

import type { ComponentChildren } from "preact";
import { withFields } from "../../state/view";
import type { QUANTITIES } from "../../state/fields";
import { type Option, Select } from "../../ui/choices";
import { useApp } from "../../ui/app";
import { ofBefore, unlessSaid } from "../../ui/ErrorNote";
import { Label } from "../../ui/Label";
import { StandingContext, useStanding } from "../../ui/standing";
import { type RequestError, isPassing } from "../../wire/request";
import type { Outcome } from "../../wire/outcome";
import type { Computation } from "../../ui/useComputation";
import { QUANTITY_NAMES, shortNumber } from "./words";

interface RunProps {
  readonly computation: Computation;
  /** What is computed, in a sentence. */
  readonly what: string;
  /** Whether it waits to be started. */
  readonly live: boolean;
}

/** A mistake that the parameters tell already is told again only where there is nothing else to see. */
export function shownError({ frame, error }: Computation, refused: RequestError | null): RequestError | null {
  return frame ? unlessSaid(error, refused) : error;
}

/** Progress of what takes long, with a way to stop it and to start it again. */
export function Run({ computation, what, live }: RunProps) {
  const { busy, progress, stopped, current, error, start, stop } = computation;
  const starts = live && !stopped && !(error && isPassing(error));
  const waits = !busy && !current && !starts;
  return (
    <div class={`contact-run${busy ? " contact-busy" : ""}`}>
      <p role="status">{busy ? `Computing ${what}…${progress ? ` ${progress.done} of ${progress.of}` : ""}` : stopped ? "Stopped." : ""}</p>
      {busy && <progress aria-label={`Computing ${what}`} {...(progress ? { value: progress.done, max: progress.of } : {})} />}
      {busy && (
        <button type="button" onClick={stop}>
          Cancel
        </button>
      )}
      {waits && (
        <button type="button" onClick={start}>
          Compute {what}
        </button>
      )}
    </div>
  );
}

interface ResultsProps {
  readonly computation: Computation;
  /** Whether what is shown beside it is of the present parameters, too. */
  readonly isWhole?: boolean;
  readonly children: ComponentChildren;
}

/** What was computed; paler where it belongs to parameters before, which is said over every chart. */
export function Results({ computation: { frame, current, busy, progress, error }, isWhole = true, children }: ResultsProps) {
  const isCurrent = current && isWhole;
  const standing = useStanding({ has: true, isCurrent, busy: busy || (current && !isWhole), progress, error }, frame);
  return (
    <div class={standing ? "stale" : ""} aria-busy={busy} data-current={current}>
      {!current && !busy && <p class="contact-note">{error ? ofBefore(error) : "These are results of parameters before."}</p>}
      <StandingContext.Provider value={standing}>{children}</StandingContext.Provider>
    </div>
  );
}

interface ChoiceProps<T extends string> {
  readonly name: string;
  readonly field: string;
  readonly value: T;
  readonly options: readonly Option<T>[];
}

/** A choice that the address keeps. */
export function Choice<T extends string>({ name, field, value, options }: ChoiceProps<T>) {
  const { store } = useApp();
  const choose = (next: T) => store.update((view) => withFields(view, { [field]: next === "" ? undefined : next }));
  return (
    <label class="contact-choice">
      {name}
      <Select value={value} options={options} onChange={choose} />
    </label>
  );
}

/** Force, area or friction: the same choice for the law and for the fit. */
export function QuantityChoice({ value }: { readonly value: (typeof QUANTITIES)[number] }) {
  const options = (["friction", "force", "area"] as const).map((quantity) => [quantity, QUANTITY_NAMES[quantity]] as const);
  return <Choice name="quantity" field="quantity" value={value} options={options} />;
}

/** What the computation says of its own trustworthiness. */
export function Checks({ checks }: Pick<Outcome, "checks">) {
  if (checks.length === 0) return null;
  return (
    <Scroll name="Checks">
      <table class="contact-table">
        <caption>Checks</caption>
        <thead>
          <tr>
            <th scope="col">check</th>
            <th scope="col">figure</th>
            <th scope="col">limit</th>
            <th scope="col">passed</th>
          </tr>
        </thead>
        <tbody>
          {checks.map(({ name, compared, figure, limit, passed, numbers }) => (
            <tr key={name} class={passed ? "" : "contact-failed"}>
              <th scope="row" title={compared}>
                {name}
              </th>
              <td>
                <Label text={numbers === 0 ? "compared nothing" : shortNumber(figure)} />
              </td>
              <td>
                <Label text={shortNumber(limit)} />
              </td>
              <td>{passed ? "✓ yes" : "✗ no"}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </Scroll>
  );
}

/** A table that may be wider than its place, and is reached by keys. */
export function Scroll({ name, children }: { readonly name: string; readonly children: ComponentChildren }) {
  return (
    <div class="contact-scroll" role="region" aria-label={name} tabIndex={0}>
      {children}
    </div>
  );
}
