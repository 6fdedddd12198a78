// @vitest-environment happy-dom
import { render } from "preact";
import { act } from "preact/test-utils";
import { describe, expect, it } from "vitest";
import { accepts, analysisOf, settingsOf, textOf } from "../src/state/settings";
import { ViewStore } from "../src/state/store";
import { AppContext } from "../src/ui/app";
import { SettingControls } from "../src/ui/SettingControls";
import type { Declaration, Session } from "../src/wire/api";
import { RequestError } from "../src/wire/request";
import { PAGE_FIELDS, number, settings, whole } from "./declared";

describe("the settings of an analysis", () => {
  it("are all that is declared, but for what the page moves itself", () => {
    expect(settingsOf(settings, "motion").map(({ path }) => path)).toEqual(["start.disturbance", "start.x", "duration", "points", "tolerance"]);
    expect(settingsOf(settings, "bifurcation").map(({ path }) => path)).toEqual(["sweep.points", "direction", "start.disturbance", "start.x"]);
    expect(settingsOf(settings, "contact").map(({ path }) => path)).toEqual(["accuracy", "cells"]);
    expect(settingsOf(settings, "unheard-of")).toEqual([]);
  });

  it("go into the tables that they stand in; what is not given a case takes by itself", () => {
    expect(analysisOf(settings, "motion", {})).toEqual({ name: "motion", kind: "motion", duration: 500 });
    const fields = { start: "0.5", duration: "5 s", "motion.tolerance": "1e-9", points: "64" };
    expect(analysisOf(settings, "motion", fields, "run")).toEqual({ name: "run", kind: "motion", start: { disturbance: 0.5 }, duration: "5 s", tolerance: 1e-9, points: 64 });
    expect(analysisOf(settings, "bifurcation", { "bifurcation.direction": "forward" })).toMatchObject({ direction: "forward", sweep: { points: 21 } });
  });

  it("say what is asked for at first, or what a case takes by itself where that is known", () => {
    const text = (key: Declaration, fields = {}) => textOf("motion", { ...key, path: key.name, field: `motion.${key.name}` }, fields);
    expect([text(whole("duration", 1, 2000)), text(whole("points", 1, 4096)), text(whole("transient", 1, null))]).toEqual(["500", "4096", ""]);
    expect(text(whole("transient", 1, null), { "motion.transient": "7" })).toBe("7");
  });

  it("take what is declared of them", () => {
    const taken = (key: Declaration, ...texts: readonly string[]) => texts.filter((text) => accepts(key, text));
    expect(taken(number("a", { above: 0, to: 0.2 }, 0), "0", "0.1", "0.2", "0.3", "", "x", "1 m")).toEqual(["0.1", "0.2"]);
    expect(taken(number("a", { from: 0, below: 1 }, 0), "0", "1")).toEqual(["0"]);
    expect(taken(number("a", { above: 0 }, 0, { group: null, unit: "m" }), "1", "1 mm")).toEqual(["1 mm"]);
    expect(taken(whole("a", 16, 0), "15", "16", "16.5", "1e3")).toEqual(["16", "1e3"]);
    expect(taken({ ...whole("a", 1, 0), form: { kind: "choice", words: [{ word: "both", doc: "" }] } }, "both", "none")).toEqual(["both"]);
    expect(taken({ ...whole("a", 1, 0), form: { kind: "flag" } }, "true", "on")).toEqual(["true"]);
  });
});

describe("the controls of settings", () => {
  it("are made from what is declared, show what is taken, and mark all that is refused", () => {
    const host = document.createElement("div");
    history.replaceState(null, "", "/point");
    const store = new ViewStore(window, PAGE_FIELDS, "point");
    const app = { session: { settings } as unknown as Session, store, keys: new Map(), values: null, base: null, error: null };
    const beside = new RequestError("`tolerance` is 2", 422, null, null);
    const show = (error: RequestError | null) => act(() => render(<AppContext.Provider value={app}><SettingControls kind="motion" first={["duration"]} error={error} /></AppContext.Provider>, host));
    const fields = () => [...host.querySelectorAll("input")].map((input) => [input.closest("label")?.textContent?.trim(), input.value, input.ariaInvalid ?? input.getAttribute("aria-invalid")]);
    show(null);
    expect(fields()).toEqual([["duration", "500", "false"], ["start disturbance", "0.2", "false"], ["start x", "", "false"], ["points", "4096", "false"], ["tolerance", "1e-8", "false"]]);
    expect(host.querySelector("label")?.title).toBe("what duration is (a value)");
    expect(host.querySelector("details")?.open).toBe(false);
    show(new RequestError("`points` is 1", 422, null, null, [beside]));
    expect(fields().filter(([, , invalid]) => invalid === "true").map(([name]) => name)).toEqual(["points", "tolerance"]);
    expect(host.querySelector("details")?.open).toBe(true);
  });
});
