/** The head of every page: where one is, undo and redo, theme, export. */

import { useEffect, useState } from "preact/hooks";
import { useView } from "../state/store";
import type { Page, View } from "../state/view";
import type { Session } from "../wire/api";
import { useApp } from "./app";
import { Select } from "./choices";
import { ExportMenu } from "./ExportMenu";
import { Link } from "./Link";
import { CHOICES, type Choice, chooseTheme, themeChoice } from "./theme";

const NAMES: Record<Page, string> = { map: "Map", point: "Point", contact: "Contact", structures: "Structures" };

/** The pages that a session has something to show on. */
export function pagesOf(session: Session): readonly Page[] {
  const model = session.case?.model;
  const pages: Page[] = model === "oscillator" ? ["map", "point", "contact"] : model === "contact" ? ["contact"] : [];
  const structures = session.study !== null || (model !== undefined && model !== "oscillator" && model !== "contact");
  return structures || pages.length === 0 ? [...pages, "structures"] : pages;
}

/** Another page with the same options. */
function onPage(view: View, page: Page): View {
  return view.page === page ? view : { page, set: view.set, fields: {} };
}

export function Header() {
  const { session, store } = useApp();
  const view = useView(store);
  useUndoKeys();
  return (
    <header class="header">
      <p class="header-name">judder</p>
      <nav aria-label="Pages">
        {pagesOf(session).map((page) => (
          <Link key={page} to={onPage(view, page)} current={view.page === page}>
            {NAMES[page]}
          </Link>
        ))}
      </nav>
      <p class="header-title" title={session.title}>
        {session.title}
      </p>
      <div class="header-tools">
        <button type="button" onClick={() => store.undo()} disabled={!store.canUndo} title="Ctrl+Z">
          Undo
        </button>
        <button type="button" onClick={() => store.redo()} disabled={!store.canRedo} title="Ctrl+Shift+Z">
          Redo
        </button>
        <ThemeChoice />
        <ExportMenu />
      </div>
    </header>
  );
}

function ThemeChoice() {
  const [choice, setChoice] = useState<Choice>(themeChoice());
  const choose = (next: Choice) => {
    chooseTheme(next);
    setChoice(next);
  };
  return (
    <label class="header-theme">
      <span class="visually-hidden">Theme</span>
      <Select value={choice} options={CHOICES.map((one) => [one, one.charAt(0).toUpperCase() + one.slice(1)])} onChange={choose} />
    </label>
  );
}

function useUndoKeys(): void {
  const { store } = useApp();
  useEffect(() => {
    const onKey = (event: KeyboardEvent) => {
      if (!(event.ctrlKey || event.metaKey) || event.altKey || event.key.toLowerCase() !== "z") return;
      const target = event.target;
      // in a field of text these keys undo what is being typed
      if (target instanceof HTMLInputElement && target.type === "text") return;
      event.preventDefault();
      if (event.shiftKey) store.redo();
      else store.undo();
    };
    document.addEventListener("keydown", onKey);
    return () => document.removeEventListener("keydown", onKey);
  }, [store]);
}
