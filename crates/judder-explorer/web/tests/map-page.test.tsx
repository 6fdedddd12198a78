// @vitest-environment happy-dom
import { render } from "preact";
import { act } from "preact/test-utils";
import { afterEach, describe, expect, it, vi } from "vitest";
import { MapPage } from "../src/pages/map/MapPage";
import { ViewStore } from "../src/state/store";
import { type App, AppContext } from "../src/ui/app";
import { withOption } from "../src/state/view";
import type { Key, Session } from "../src/wire/api";
import { encode } from "./encode";
import { PAGE_FIELDS } from "./declared";

const key = (path: string): Key => ({
  path, section: "", symbol: path, group: path, unit: "1", doc: "", range: { above: 0 }, slider: { from: 0.01, to: 1, scale: "log" }, label: "", label_si: "",
});
const keys = new Map(["operation.velocity", "contact.shear_strength"].map((path) => [path, key(path)]));
const session = { map: null, keys: [...keys.values()], case: { model: "oscillator", text: "" } } as unknown as Session;

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
  it("lies between ends that are written as a person does", async () => {
    vi.stubGlobal("fetch", () => new Promise(() => {}));
    const store = new ViewStore(window, PAGE_FIELDS, "map");
    const host = document.createElement("div");
    const axis = { key: "operation.velocity", from: "1e-6 m/s", to: "1e0 m/s", scale: "log" } as const;
    const app: App = { session: { ...session, map: { x: axis, y: { key: "contact.shear_strength", from: 0.001, to: 1e-8, scale: "log" } } }, store, keys, values: null, base: null, error: null };
    await act(() => render(<AppContext.Provider value={app}><MapPage /></AppContext.Provider>, host));
    const ends = [...host.querySelectorAll<HTMLInputElement>(".axis-end")].map(({ value }) => value);
    expect(ends).toEqual(["1 µm/s", "1 m/s", "0.001", "1e-8"]);
    await act(() => render(null, host));
  });

  it("is said to be outside where the map does not reach to it", async () => {
    vi.stubGlobal("fetch", () => new Promise(() => {}));
    const outside = "does not reach to this point";
    expect(await panel("/map?pin=1e9,1e9")).toContain(outside);
    expect(await panel("/map?pin=-1,0.1")).toContain(outside);
    expect(await panel("/map?pin=0.1,0.1")).toContain("Pinned point");
    expect(await panel("/map?pin=0.1,0.1")).not.toContain(outside);
  });
});

/** A server that answers maps when it is told to; everything else it takes its time for. */
function maps(): ((...frames: readonly Uint8Array[]) => void)[] {
  const asked: ((...frames: readonly Uint8Array[]) => void)[] = [];
  vi.stubGlobal("fetch", (path: string) => {
    if (path !== "/api/map") return new Promise(() => {});
    let stream: ReadableStreamDefaultController<Uint8Array>;
    const body = new ReadableStream<Uint8Array>({ start: (controller) => void (stream = controller) });
    asked.push((...frames) => frames.forEach((frame) => stream.enqueue(frame)));
    return Promise.resolve({ ok: true, body });
  });
  return asked;
}

const exact = () => {
  const payload = new Uint8Array(40);
  payload.set(new Uint8Array(Float64Array.of(0.01, 1, 0.01, 1).buffer));
  const side = (name: string, offset: number) => ({ name, dimensions: [name], shape: [2], offset, type: "f64" });
  return encode({ kind: "map", stage: "exact", unresolved: 0, arrays: [side("x", 0), side("y", 16), { name: "classes", dimensions: ["y", "x"], shape: [2, 2], offset: 32, type: "u8" }] }, payload);
};
const rest = (time: number) => act(() => new Promise<void>((resolve) => setTimeout(resolve, time)));
/** Waits until something holds: how long that takes depends on the machine. */
const until = async (holds: () => boolean) => {
  for (let waited = 0; waited < 4000 && !holds(); waited += 25) await rest(25);
};

describe("a map of other values", () => {
  const shown = async (work: (store: ViewStore, host: HTMLElement, asked: ReturnType<typeof maps>) => Promise<void>) => {
    history.replaceState(null, "", "/map");
    const asked = maps();
    const store = new ViewStore(window, PAGE_FIELDS, "map");
    const app: App = { session, store, keys, values: null, base: null, error: null };
    const host = document.createElement("div");
    await act(() => render(<AppContext.Provider value={app}><MapPage /></AppContext.Provider>, host));
    await work(store, host, asked);
    await act(() => render(null, host));
  };
  const standing = (host: HTMLElement) => host.querySelector<HTMLElement>(".map-chart .chart")?.dataset["standing"];
  const words = (host: HTMLElement) => host.querySelector(".map-chart .chart-standing")?.textContent ?? "";

  it("says so while the law of the present ones is computed, and why they are refused", async () => {
    await shown(async (store, host, asked) => {
      asked[0]?.(exact(), encode({ kind: "end" }));
      await until(() => host.querySelector(".map-chart .chart") !== null && standing(host) === undefined);
      expect(standing(host)).toBeUndefined();
      // longer than what counts as a drag, in which sketches are asked for as well
      await rest(200);
      await act(() => store.update((view) => withOption(view, "contact.shear_strength", "0.5")));
      await until(() => standing(host) === "computing" && asked.length > 1);
      expect(standing(host)).toBe("computing");
      asked.at(-1)?.(encode({ kind: "progress", done: 3, of: 9 }));
      await until(() => words(host).includes("3 of 9"));
      expect(words(host)).toBe("Computing the contact law… 3 of 9. What is shown is of the values before.");
      asked.at(-1)?.(encode({ kind: "error", error: { message: "the law is not known there", place: null, help: null } }));
      await until(() => standing(host) === "refused");
      expect([standing(host), words(host)]).toEqual(["refused", "The law is not known there. Of the values before: the present ones are refused."]);
    });
  });

  it("is no blank area: where there is none, the message stands in the plot", async () => {
    await shown(async (_, host, asked) => {
      asked[0]?.(encode({ kind: "error", error: { message: "`x.from` must be a speed", place: null, help: null } }));
      await until(() => words(host) !== "");
      expect(words(host)).toBe("x.from must be a speed.");
      const status = host.querySelector(".map-status");
      expect(status?.textContent, "read aloud").toBe("x.from must be a speed.");
      expect(status?.querySelector(".visually-hidden")?.textContent, "and not shown twice").toBe("x.from must be a speed.");
      expect(host.querySelector('[aria-label="From, x axis"]')?.getAttribute("aria-invalid")).toBe("true");
      expect(host.querySelector('[aria-label="To, x axis"]')?.getAttribute("aria-invalid")).toBe("false");
    });
  });
});

/** A server that answers every map at once, and every analysis as `reply` says; what analyses were asked for. */
function analyses(reply: () => Uint8Array): { readonly asked: { readonly set: readonly string[]; readonly analysis: unknown }[] } {
  const asked: { set: readonly string[]; analysis: unknown }[] = [];
  const answer = (...frames: readonly Uint8Array[]) =>
    Promise.resolve({ ok: true, body: new ReadableStream({ start: (stream) => (frames.forEach((frame) => stream.enqueue(frame)), stream.close()) }) });
  vi.stubGlobal("fetch", (path: string, options: { body: string }) => {
    if (path === "/api/map") return answer(exact(), encode({ kind: "end" }));
    if (path !== "/api/analysis") return new Promise(() => {});
    asked.push(JSON.parse(options.body) as (typeof asked)[number]);
    return answer(reply(), encode({ kind: "end" }));
  });
  return { asked };
}

describe("what a map warns of", () => {
  const shown = async (reply: () => Uint8Array, work: (store: ViewStore, note: () => HTMLElement | null, asked: ReturnType<typeof analyses>["asked"]) => Promise<void>) => {
    history.replaceState(null, "", "/map");
    const { asked } = analyses(reply);
    const store = new ViewStore(window, PAGE_FIELDS, "map");
    const host = document.createElement("div");
    const app: App = { session, store, keys, values: null, base: null, error: null };
    await act(() => render(<AppContext.Provider value={app}><MapPage /></AppContext.Provider>, host));
    await work(store, () => host.querySelector<HTMLElement>(".map-warnings"), asked);
    await act(() => render(null, host));
  };

  it("stands over it, in the words of its analysis: that of the whole map, at every change", async () => {
    const warnings = ["eq. (3), the condition of steady-sliding laws in motion, is broken", "outside the law's range"];
    await shown(
      () => encode({ kind: "outcome", warnings, arrays: [] }),
      async (store, note, asked) => {
        await until(() => note()?.textContent !== "");
        expect([...(note()?.querySelectorAll("li") ?? [])].map((line) => line.textContent)).toEqual(warnings);
        const isPale = () => note()?.querySelector(".stale") !== null;
        expect(isPale()).toBe(false);
        const axis = { from: 0.01, to: 1, points: 400, scale: "log" };
        const [x, y] = [{ ...axis, key: "operation.velocity" }, { ...axis, key: "contact.shear_strength" }];
        expect(asked.at(-1)).toMatchObject({ set: [], analysis: { kind: "stability-map", x, y, boundaries: false } });
        await act(() => store.update((view) => withOption(view, "contact.shear_strength", "0.5")));
        expect(isPale(), "of the values before").toBe(true);
        await until(() => !isPale());
        expect(asked.at(-1)?.set).toEqual(["contact.shear_strength=0.5"]);
      },
    );
  });

  it("is said to be unknown where it cannot be computed", async () => {
    await shown(
      () => encode({ kind: "error", error: { message: "the explorer is busy", place: null, help: null } }),
      async (_, note) => {
        await until(() => note()?.textContent !== "");
        expect(note()?.textContent).toBe("It is not known what there is to warn of: the explorer is busy.");
      },
    );
  });
});
