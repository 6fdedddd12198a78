/** What every page gets: the session, the store of the view, and the values of the case. */

import { createContext } from "preact";
import { useContext, useEffect, useRef, useState } from "preact/hooks";
import { type ViewStore, useView } from "../state/store";
import { options } from "../state/view";
import { type CaseValues, type Key, type Session, fetchCase } from "../wire/api";
import { Latest } from "../wire/latest";
import { type RequestError, asRequestError, isAbort } from "../wire/request";

export interface App {
  readonly session: Session;
  readonly store: ViewStore;
  readonly keys: ReadonlyMap<string, Key>;
  /** Values of the view's case; those of the last good one while they are asked for or refused. */
  readonly values: CaseValues | null;
  /** Values of the case as it was opened. */
  readonly base: CaseValues | null;
  /** Why the view's options are refused. */
  readonly error: RequestError | null;
}

export const AppContext = createContext<App | null>(null);

export function useApp(): App {
  const app = useContext(AppContext);
  if (!app) throw new Error("a page outside of the application");
  return app;
}

/** Whether the case has keys that sliders move: an oscillator, or the substrate and the indenter of a contact. */
export function hasValues(session: Session): boolean {
  return session.case?.model === "oscillator" || session.case?.model === "contact";
}

/** While a slider is dragged the values of the case are asked for at most so often, in milliseconds. */
const VALUES_EVERY = 250;

/** The values of the case of the view, asked for as it changes. */
export function useCaseValues(session: Session, store: ViewStore): Pick<App, "values" | "base" | "error"> {
  const view = useView(store);
  const [values, setValues] = useState<CaseValues | null>(session.values ?? null);
  const [base, setBase] = useState<CaseValues | null>(session.values ?? null);
  const [error, setError] = useState<RequestError | null>(null);
  const latest = useRef(new Latest());
  const asked = useRef(Number.NEGATIVE_INFINITY);
  const set = JSON.stringify(options(view));
  useEffect(() => {
    if (hasValues(session) && !session.values) fetchCase([]).then(setBase, (failure) => setError(asRequestError(failure)));
  }, [session]);
  useEffect(() => {
    if (!hasValues(session)) return;
    const ask = () => {
      asked.current = performance.now();
      latest.current.submit(async (signal) => {
        try {
          setValues(await fetchCase(JSON.parse(set) as string[], signal));
          setError(null);
        } catch (failure) {
          if (!isAbort(failure)) setError(asRequestError(failure));
        }
      });
    };
    const timer = setTimeout(ask, asked.current + VALUES_EVERY - performance.now());
    return () => clearTimeout(timer);
  }, [session, set]);
  return { values, base, error };
}
