// @vitest-environment happy-dom
import { render } from "preact";
import { act } from "preact/test-utils";
import { afterEach, describe, expect, it, vi } from "vitest";
import { MapPage } from "../src/pages/map/MapPage";
import { PAGE_FIELDS } from "../src/state/fields";
import { ViewStore } from "../src/state/store";
import { type App, AppContext } from "../src/ui/app";
import type { Key, Session } from "../src/wire/api";

const key = (path: string): Key => ({
  path, section: "", symbol: path, group: path, unit: "1", doc: "", range: "positive", slider: { from: 0.01, to: 1, scale: "log" }, label: "", label_si: "",
});
const keys = new Map(["operation.velocity", "contact.shear_strength"].map((path) => [path, key(path)]));
const session = { map: null, keys: [...keys.values()], laws: [], case: { model: "oscillator", text: "" } } as unknown as Session;

/** What the panel of the place says with this address, before the server has answered. */
async function panel(address: string): Promise<string> {
  history.replaceState(null, "", address);
  const store = new ViewStore(window, PAGE_FIELDS, "map");
  const app: App = { session, store, keys, values: null, base: null, error: null };
  const host = document.createElement("div");
  await act(() => render(<AppContext.Provider value={app}><MapPage /></AppContext.Provider>, host));
  const text = host.querySelector(".cursor-panel")?.textContent ?? "";
  await act(() => render(null, host));
  return text;
}

afterEach(() => vi.unstubAllGlobals());

describe("the place on the map", () => {
  it("is said to be outside where the map does not reach to it", async () => {
    vi.stubGlobal("fetch", () => new Promise(() => {}));
    const outside = "does not reach to this point";
    expect(await panel("/map?pin=1e9,1e9")).toContain(outside);
    expect(await panel("/map?pin=-1,0.1")).toContain(outside);
    expect(await panel("/map?pin=0.1,0.1")).toContain("Pinned point");
    expect(await panel("/map?pin=0.1,0.1")).not.toContain(outside);
  });
});
