// @vitest-environment happy-dom
import { render } from "preact";
import { act } from "preact/test-utils";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { FitPart } from "../src/pages/contact/FitPart";
import { readContact } from "../src/pages/contact/state";
import { ViewStore } from "../src/state/store";
import { type App, AppContext } from "../src/ui/app";
import type { Session } from "../src/wire/api";
import { PAGE_FIELDS } from "./declared";

let host: HTMLElement;
let store: ViewStore;

function show(): void {
  const app: App = { session: {} as Session, store, keys: new Map(), values: null, base: null, error: null };
  const live = { point: null, set: "", error: null };
  const contact = { state: readContact(store.view, {}), set: [], derived: false, live, operating: null, values: null };
  act(() => render(<AppContext.Provider value={app}><FitPart contact={contact} /></AppContext.Provider>, host));
}

function enter(label: string, text: string): void {
  const field = host.querySelector(`input[aria-label="${label}"]`) as HTMLInputElement;
  act(() => {
    field.value = text;
    field.dispatchEvent(new Event("input", { bubbles: true }));
  });
  act(() => void field.dispatchEvent(new KeyboardEvent("keydown", { key: "Enter", bubbles: true })));
  show();
}

const button = (name: string) => [...host.querySelectorAll("button")].find((one) => one.textContent === name) as HTMLButtonElement;

beforeEach(() => {
  host = document.createElement("div");
  history.replaceState(null, "", "/contact?part=fit");
  store = new ViewStore(window, PAGE_FIELDS, "contact");
});
afterEach(() => vi.unstubAllGlobals());

describe("the ranges of the fit", () => {
  it("are set in fields, kept in the address and asked for", async () => {
    const bodies: { analysis: object }[] = [];
    vi.stubGlobal("fetch", (_: string, { body }: { body: string }) => {
      bodies.push(JSON.parse(body) as { analysis: object });
      return new Promise(() => {});
    });
    show();
    enter("to, depths δ/R", "0.01");
    enter("from, speeds v τ/R", "1e-2");
    expect(location.search).toContain("depths=0.0001,0.01");
    expect(location.search).toContain("speeds=1e-2,10000");
    await act(() => button("Compute the fit").click());
    expect(bodies[0]?.analysis).toMatchObject({ velocity: { from: 0.01, to: 1e4 }, indentation: { from: 1e-4, to: 0.01 } });
    act(() => button("The paper's ranges").click());
    expect(store.view.fields).toEqual({ part: "fit" });
  });

  it("take no range that is empty or not positive", () => {
    show();
    for (const text of ["1e5", "0", "-1", "1,2", "x"]) enter("from, speeds v τ/R", text);
    expect(store.view.fields["speeds"]).toBeUndefined();
    expect(button("The paper's ranges").disabled).toBe(true);
  });
});
