// @vitest-environment happy-dom
import { render } from "preact";
import { act } from "preact/test-utils";
import { expect, it } from "vitest";
import { SoundSection } from "../src/pages/point/SoundSection";
import { readPoint } from "../src/pages/point/state";
import { ViewStore } from "../src/state/store";
import { type App, AppContext } from "../src/ui/app";
import type { Key, Session } from "../src/wire/api";
import { PAGE_FIELDS } from "./declared";

const key = { path: "contact.shear_strength", slider: { from: 0.01, to: 1, scale: "log" } } as Key;
const session = { map: null, keys: [key] } as unknown as Session;

it("nothing is said of modes while they are computed", () => {
  history.replaceState(null, "", "/point");
  const store = new ViewStore(window, PAGE_FIELDS, "point");
  const app = { session, store, keys: new Map([[key.path, key]]), values: null, base: null, error: null } as App;
  const state = readPoint(store.view, session, app.keys, () => undefined);
  const host = document.createElement("div");
  const said = (hasModes: boolean) => {
    act(() => render(<AppContext.Provider value={app}><SoundSection state={state} sources={[]} hasModes={hasModes} /></AppContext.Provider>, host));
    return host.querySelector(".note")?.textContent ?? "";
  };
  expect(said(false)).not.toContain("no mode");
  expect(said(true)).toContain("Here no mode oscillates");
});
