/** One store of the view, tied to the address and the history of the browser. */

import { useEffect, useState } from "preact/hooks";
import { type PageFields, type View, parseView, writeView } from "./view";

/**
 * How a change is kept: `push` makes an entry of the history; `drag` shows it without one, until a `push` ends the drag
 * (one entry for all of it); `step` is a push that becomes part of the entry of the step before where it changes the same within a
 * second (presses of keys on a slider); `quiet` changes the entry in place (a cursor).
 */
export type Keep = "push" | "drag" | "step" | "quiet";

/** What the store needs of a window; tests give their own. */
export interface Browser {
  readonly location: { readonly pathname: string; readonly search: string };
  readonly history: Pick<History, "state" | "pushState" | "replaceState" | "back" | "forward">;
  readonly sessionStorage: Pick<Storage, "getItem" | "setItem">;
  addEventListener(kind: "popstate", listener: () => void): void;
}

const TOP = "judder-history-top";
/** Browsers refuse hundreds of changes of the address within some seconds. */
const ADDRESS_EVERY = 200;
/** Steps that follow one another within this time, in milliseconds, are one. */
const STEPS_WITHIN = 1000;

/** The options and fields in which two views differ. */
function difference(a: View, b: View): string {
  const texts = (view: View): Record<string, string> => ({ ...view.set, ...Object.fromEntries(Object.entries(view.fields).map(([field, text]) => [`/${field}`, text])) });
  const [before, after] = [texts(a), texts(b)];
  return Object.keys({ ...before, ...after }).filter((name) => before[name] !== after[name]).sort().join();
}

export class ViewStore {
  private current: View;
  /** The view of the history entry, from which a drag started. */
  private entry: View;
  private index: number;
  private top: number;
  private readonly listeners = new Set<() => void>();
  private timer: ReturnType<typeof setTimeout> | undefined;
  /** The newest step: when it was, and what it changed. */
  private step: { readonly time: number; readonly what: string } | undefined;
  /** What was dropped from the address. */
  told: readonly string[];

  constructor(
    private readonly browser: Browser,
    private readonly known: PageFields,
    start: View["page"],
  ) {
    const parsed = parseView(browser.location.pathname, browser.location.search, known, start);
    this.current = this.entry = parsed.view;
    this.told = parsed.told;
    const index = (browser.history.state as { index?: unknown } | null)?.index;
    this.index = typeof index === "number" ? index : 0;
    const top = Number(browser.sessionStorage.getItem(TOP) ?? 0);
    this.top = typeof index === "number" && top >= index ? top : this.index;
    this.writeEntry(this.current);
    browser.addEventListener("popstate", () => this.arrive(start));
  }

  get view(): View {
    return this.current;
  }

  get canUndo(): boolean {
    return this.index > 0;
  }

  get canRedo(): boolean {
    return this.index < this.top;
  }

  update(change: (view: View) => View, keep: Keep = "push"): void {
    const next = change(this.current);
    const address = writeView(next);
    if (keep === "step") this.goOn(next, address);
    else if (keep === "push") this.push(next, address);
    else if (address !== writeView(this.current)) {
      this.current = next;
      // a cursor that moves during a drag must not make the drag's steps part of the entry
      if (keep === "quiet") this.entry = change(this.entry);
      this.timer ??= setTimeout(() => this.writeEntry(this.current), ADDRESS_EVERY);
    } else return;
    this.tell();
  }

  undo(): void {
    if (this.canUndo) this.browser.history.back();
  }

  redo(): void {
    if (this.canRedo) this.browser.history.forward();
  }

  subscribe(listener: () => void): () => void {
    this.listeners.add(listener);
    return () => void this.listeners.delete(listener);
  }

  private goOn(next: View, address: string): void {
    const [what, time, last] = [difference(this.entry, next), Date.now(), this.step];
    if (last?.what === what && time - last.time < STEPS_WITHIN) {
      this.current = this.entry = next;
      this.timer ??= setTimeout(() => this.writeEntry(this.current), ADDRESS_EVERY);
    } else this.push(next, address);
    this.step = { time, what };
  }

  private push(next: View, address: string): void {
    this.step = undefined;
    // a drag may have left its steps in the entry: it gets back the view from which the drag started
    this.writeEntry(this.entry);
    const moved = address !== writeView(this.entry);
    this.current = this.entry = next;
    if (!moved) return;
    this.index += 1;
    this.top = this.index;
    this.browser.history.pushState({ index: this.index }, "", address);
    this.browser.sessionStorage.setItem(TOP, String(this.top));
  }

  private writeEntry(view: View): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.browser.history.replaceState({ index: this.index }, "", writeView(view));
  }

  /** The browser went to another entry. */
  private arrive(start: View["page"]): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    const { location, history } = this.browser;
    const parsed = parseView(location.pathname, location.search, this.known, start);
    this.current = this.entry = parsed.view;
    this.step = undefined;
    this.told = parsed.told;
    const index = (history.state as { index?: unknown } | null)?.index;
    this.index = typeof index === "number" ? index : 0;
    this.top = Math.max(this.top, this.index);
    this.tell();
  }

  private tell(): void {
    for (const listener of this.listeners) listener();
  }
}

/** The view of a store, in a component. */
export function useView(store: ViewStore): View {
  const [view, setView] = useState(store.view);
  useEffect(() => {
    setView(store.view);
    return store.subscribe(() => setView(store.view));
  }, [store]);
  return view;
}
