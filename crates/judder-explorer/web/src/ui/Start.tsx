/** The application: asks for the session, then shows the page of the view. */

import { useEffect, useMemo, useState } from "preact/hooks";
import { pageOf } from "../pages";
import { keepKnownAxes } from "../state/axes";
import { pageFields } from "../state/pages";
import { ViewStore, useView } from "../state/store";
import { keepKnownKeys } from "../state/view";
import { type Session, fetchSession } from "../wire/api";
import { type RequestError, asRequestError } from "../wire/request";
import { AppContext, useCaseValues } from "./app";
import { ErrorNote } from "./ErrorNote";
import { Header, pagesOf } from "./Header";

export function Start() {
  const [session, setSession] = useState<Session | null>(null);
  const [error, setError] = useState<RequestError | null>(null);
  useEffect(() => {
    fetchSession().then(setSession, (failure) => setError(asRequestError(failure)));
  }, []);
  if (session) return <Application session={session} />;
  return (
    <main class="starting">
      <ErrorNote error={error} />
      {!error && <p>Opening the case…</p>}
    </main>
  );
}

function Application({ session }: { readonly session: Session }) {
  const store = useMemo(() => openStore(session), [session]);
  const view = useView(store);
  const keys = useMemo(() => new Map(session.keys.map((key) => [key.path, key])), [session]);
  const values = useCaseValues(session, store);
  const app = useMemo(() => ({ session, store, keys, ...values }), [session, store, keys, values.values, values.base, values.error]);
  useEffect(() => {
    document.title = `${view.page} · ${session.title} · judder`;
  }, [view.page, session]);
  return (
    <AppContext.Provider value={app}>
      <a class="skip-link" href="#main" onClick={skip}>
        Skip to the content
      </a>
      <Header />
      <Told key={view.page} told={store.told} />
      <PageOf page={view.page} />
    </AppContext.Provider>
  );
}

/** The address must stay that of the view: no fragment. */
function skip(event: Event): void {
  event.preventDefault();
  document.getElementById("main")?.focus();
}

function openStore(session: Session): ViewStore {
  const pages = pagesOf(session);
  const first = pages[0] ?? "structures";
  const store = new ViewStore(window, pageFields(session), first);
  const known = new Set([...[...session.keys, ...(session.choices ?? [])].map((key) => key.path)]);
  if (!pages.includes(store.view.page)) {
    store.told = [...store.told, `There is nothing to show on the page “${store.view.page}”.`];
    store.update((view) => ({ page: first, set: view.set, fields: {} }), "quiet");
  }
  const kept = keepKnownKeys(store.view, known);
  const axes = keepKnownAxes(kept.view, { keys: new Set(session.keys.map((key) => key.path)), x: session.map?.x.key });
  const told = [...kept.told, ...axes.told];
  store.told = [...store.told, ...told];
  if (told.length > 0) store.update(() => axes.view, "quiet");
  return store;
}

/** What of the address could not be used. */
function Told({ told }: { readonly told: readonly string[] }) {
  const [closed, setClosed] = useState<readonly string[]>([]);
  const open = told.filter((line) => !closed.includes(line));
  if (open.length === 0) return null;
  return (
    <div class="told" role="status">
      <ul>
        {open.map((line) => (
          <li key={line}>{line}</li>
        ))}
      </ul>
      <button type="button" onClick={() => setClosed(told)}>
        Close
      </button>
    </div>
  );
}

/** The component of a page, which comes in a file of its own. */
function PageOf({ page }: { readonly page: keyof typeof pageOf }) {
  const [loaded, setLoaded] = useState<{ page: string; Component: () => preact.JSX.Element } | null>(null);
  const [error, setError] = useState<RequestError | null>(null);
  useEffect(() => {
    let wanted = true;
    pageOf[page]().then(
      (Component) => wanted && setLoaded({ page, Component }),
      (failure) => setError(asRequestError(failure)),
    );
    return () => {
      wanted = false;
    };
  }, [page]);
  const Component = loaded?.page === page ? loaded.Component : null;
  return (
    <div class="page">
      <ErrorNote error={error} />
      {Component && <Component />}
    </div>
  );
}
