import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { type Browser, ViewStore } from "../src/state/store";
import { withFields, withOption, writeView } from "../src/state/view";
import { PAGE_FIELDS } from "./declared";

/** A window with a history of its own. */
function browser(address = "/map"): Browser & { readonly addresses: () => string[] } {
  const entries = [{ address, state: null as unknown }];
  let at = 0;
  let arrive = () => {};
  const kept = new Map<string, string>();
  const go = (step: number) => {
    at += step;
    arrive();
  };
  return {
    get location() {
      const url = new URL(entries[at]?.address ?? "", "http://localhost");
      return { pathname: url.pathname, search: url.search };
    },
    history: {
      get state() {
        return entries[at]?.state;
      },
      pushState: (state, _title, url) => {
        entries.splice(at + 1, entries.length, { state, address: String(url) });
        at += 1;
      },
      replaceState: (state, _title, url) => {
        entries[at] = { state, address: String(url) };
      },
      back: () => go(-1),
      forward: () => go(1),
    },
    sessionStorage: { getItem: (key) => kept.get(key) ?? null, setItem: (key, text) => void kept.set(key, text) },
    addEventListener: (_kind, listener) => {
      arrive = listener;
    },
    addresses: () => entries.map((entry) => entry.address),
  };
}

const open = (browser: Browser) => new ViewStore(browser, PAGE_FIELDS, "map");
const velocity = (text: string) => (view: ViewStore["view"]) => withOption(view, "operation.velocity", text);

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

describe("the store", () => {
  it("makes one entry of steps of one option within a second", () => {
    const window = browser();
    const store = open(window);
    for (const text of ["1", "2", "3"]) {
      store.update(velocity(text), "drag");
      store.update(velocity(text), "step");
      vi.advanceTimersByTime(600);
    }
    expect(window.addresses()).toEqual(["/map", "/map?set=operation.velocity=3"]);
    store.update((view) => withOption(view, "contact.shear_strength", "5"), "step");
    vi.advanceTimersByTime(1100);
    store.update((view) => withOption(view, "contact.shear_strength", "6"), "step");
    expect(window.addresses()).toHaveLength(4);
    store.undo();
    store.undo();
    store.undo();
    expect(writeView(store.view)).toBe("/map");
    store.redo();
    expect(writeView(store.view)).toBe("/map?set=operation.velocity=3");
  });

  it("makes one entry of a drag, and undo goes to where it started", () => {
    const window = browser();
    const store = open(window);
    for (const text of ["1", "2", "3"]) {
      store.update(velocity(text), "drag");
      vi.advanceTimersByTime(500);
    }
    expect(window.addresses()).toEqual(["/map?set=operation.velocity=3"]);
    expect(store.canUndo).toBe(false);
    store.update(velocity("3"));
    expect(window.addresses()).toEqual(["/map", "/map?set=operation.velocity=3"]);
    expect([store.canUndo, store.canRedo]).toEqual([true, false]);
    store.undo();
    expect(writeView(store.view)).toBe("/map");
    expect([store.canUndo, store.canRedo]).toEqual([false, true]);
    store.redo();
    expect(store.view.set).toEqual({ "operation.velocity": "3" });
  });

  it("makes no entry of what changes nothing", () => {
    const window = browser();
    const store = open(window);
    store.update(velocity("1"));
    store.update(velocity("1"));
    expect(window.addresses()).toHaveLength(2);
    store.update(velocity("2"), "drag");
    store.update(velocity("1"));
    expect(window.addresses()).toEqual(["/map", "/map?set=operation.velocity=1"]);
  });

  it("keeps a cursor in the entry, and a drag's steps out of it", () => {
    const window = browser();
    const store = open(window);
    store.update(velocity("1"), "drag");
    store.update((view) => withFields(view, { cursor: "1,2" }), "quiet");
    store.update(velocity("2"));
    expect(window.addresses()).toEqual(["/map?cursor=1,2", "/map?set=operation.velocity=2&cursor=1,2"]);
  });

  it("forgets what was undone when something else is done", () => {
    const window = browser();
    const store = open(window);
    store.update(velocity("1"));
    store.update(velocity("2"));
    store.undo();
    store.update(velocity("3"));
    expect(store.canRedo).toBe(false);
    store.undo();
    store.undo();
    expect(writeView(store.view)).toBe("/map");
    store.undo();
    expect(writeView(store.view)).toBe("/map");
  });

  it("knows its place in the history after a reload", () => {
    const window = browser();
    const store = open(window);
    store.update(velocity("1"));
    store.update(velocity("2"));
    store.undo();
    const reloaded = open(window);
    expect(reloaded.view.set).toEqual({ "operation.velocity": "1" });
    expect([reloaded.canUndo, reloaded.canRedo]).toEqual([true, true]);
  });

  it("does not write the address at every step", () => {
    const window = browser();
    const replace = vi.spyOn(window.history, "replaceState");
    const store = open(window);
    for (let step = 0; step < 100; step += 1) {
      store.update(velocity(String(step)), "drag");
      vi.advanceTimersByTime(10);
    }
    expect(replace.mock.calls.length).toBeLessThan(10);
    const told = vi.fn();
    store.subscribe(told);
    store.update(velocity("x"), "drag");
    expect(told).toHaveBeenCalledOnce();
  });
});
