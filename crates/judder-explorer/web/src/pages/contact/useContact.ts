/** The case behind the contact page: its model, its operating point, its contrast. */

import { useMemo } from "preact/hooks";
import { useView } from "../../state/store";
import { options } from "../../state/view";
import { useApp } from "../../ui/app";
import { type LivePoint, usePoint } from "../../ui/usePoint";
import type { CaseValues } from "../../wire/api";
import { type ContactState, type Place, readContact } from "./state";

export interface Contact {
  readonly state: ContactState;
  readonly set: readonly string[];
  /** Whether the case is an oscillator, whose contact the server derives. */
  readonly derived: boolean;
  readonly live: LivePoint;
  /** Speed and depth of the oscillator's equilibrium. */
  readonly operating: Place | null;
  readonly values: CaseValues | null;
}

/** Where a case of one contact starts: in the transition, as deep as its neighbours in the book. */
export const CONTACT_HOME: Place = { velocity: 0.1, indentation: 0.01 };

export function useContact(): Contact {
  const { session, store, values } = useApp();
  const view = useView(store);
  const derived = session.case?.model === "oscillator";
  const state = useMemo(() => readContact(view, session), [view, session]);
  const set = options(view);
  // a fit has no operating point, and computed laws take seconds to find one
  const live = usePoint(derived && state.part !== "fit" ? set : null);
  const operating = useMemo(() => {
    const [velocity, indentation] = [live.point?.point.groups["velocity"], live.point?.point.equilibrium["indentation"]];
    return velocity && indentation && indentation > 0 ? { velocity, indentation } : null;
  }, [live.point]);
  return { state, set, derived, live, operating, values };
}

/** What an analysis of the contact is asked with. */
export function contactBody({ set, derived }: Pick<Contact, "set" | "derived">, analysis: object): object {
  return { set, analysis, ...(derived ? { model: "contact" } : {}) };
}

/** A value of the case in its unit. */
export function siValue(values: CaseValues | null, path: string): number | null {
  return values?.values.find((value) => value.path === path)?.si ?? null;
}
