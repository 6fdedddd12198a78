// @vitest-environment happy-dom
import { render } from "preact";
import { act } from "preact/test-utils";
import { beforeEach, describe, expect, it, vi } from "vitest";
import { Chart } from "../src/chart/Chart";
import { exportable } from "../src/chart/exports";
import type { ChartSpec } from "../src/chart/spec";
import { Results } from "../src/pages/contact/Parts";
import { ofBefore } from "../src/ui/ErrorNote";
import { PointValues } from "../src/ui/PointValues";
import { type Facts, StandingContext, standingOf, useStanding } from "../src/ui/standing";
import { Value } from "../src/ui/Value";
import type { Point } from "../src/wire/api";
import { RequestError, asRequestError } from "../src/wire/request";

const spec: ChartSpec = {
  title: "Growth",
  x: { label: "Time $t$ (s)", scale: "log", range: [1, 100] },
  y: { label: "Growth", scale: "linear", range: [0, 1] },
  layers: [{ kind: "line", label: "mode 1", x: [1, 10, 100], y: [0, 0.5, 1], role: { mode: 0 } }],
};

let host: HTMLElement;
beforeEach(() => {
  host = document.createElement("div");
  document.body.replaceChildren(host);
});

const picture = () => host.querySelector(".chart-over") as SVGSVGElement;
const press = (key: string, shiftKey = false) =>
  act(() => void picture().dispatchEvent(new KeyboardEvent("keydown", { key, shiftKey, bubbles: true, cancelable: true })));

describe("a chart", () => {
  it("has a name, can be reached by Tab and is in the export menu while it is shown", () => {
    act(() => render(<Chart spec={spec} />, host));
    expect(picture().getAttribute("tabindex")).toBe("0");
    expect(picture().getAttribute("aria-label")).toBe("Growth");
    expect(document.getElementById(picture().getAttribute("aria-describedby") ?? "")?.textContent).toContain("Arrow keys");
    expect(host.innerHTML).not.toMatch(/NaN|undefined/);
    expect(exportable().map((chart) => chart.title)).toEqual(["Growth"]);
    act(() => render(null, host));
    expect(exportable()).toEqual([]);
  });

  it("is exported as its data, of the window that is shown, where that is not what is drawn", async () => {
    const dataOf = vi.fn(async () => "time,value\n");
    const window = { x: [2, 5], y: [0, 1] } as const;
    act(() => render(<Chart spec={spec} window={window} onWindow={() => undefined} dataOf={dataOf} />, host));
    expect(await exportable()[0]?.now().csv()).toBe("time,value\n");
    expect(dataOf).toHaveBeenCalledWith(window);
    act(() => render(<Chart spec={spec} />, host));
    expect(await exportable()[0]?.now().csv()).toBe("Time t (s),mode 1\n1,0\n10,0.5\n100,1\n");
    act(() => render(null, host));
  });

  it("is read, zoomed and reset with keys", () => {
    const onPick = vi.fn();
    act(() => render(<Chart spec={spec} onPick={onPick} />, host));
    press("ArrowRight");
    press("ArrowRight", true);
    const readings = () => host.querySelector(".chart-readings")?.textContent;
    expect(readings()).toContain("mode 1");
    press("Enter");
    expect(onPick).toHaveBeenCalledOnce();
    const [picked] = onPick.mock.calls[0] as [{ x: number; y: number }];
    expect(picked.x).toBeCloseTo(100 ** 0.61, 9);
    expect(picked.y).toBeCloseTo(0.5, 12);
    const before = picture().innerHTML;
    press("+");
    expect(picture().innerHTML).not.toBe(before);
    press("0");
    expect(picture().innerHTML).toBe(before);
  });
});

describe("a value", () => {
  it("shows six of its digits, and keeps them all under its key", () => {
    act(() => render(<Value name="growth rate" dataKey="growth_rate" value={0.1 + 0.2} unit="1/s" />, host));
    const shown = host.querySelector<HTMLElement>('[data-key="growth_rate"]');
    expect([shown?.textContent, shown?.dataset["value"]]).toEqual(["0.3", "0.30000000000000004"]);
    act(() => render(<Value name="growth rate" dataKey="growth_rate" value={null} />, host));
    expect(host.querySelector('[data-key="growth_rate"]')?.textContent).toBe("—");
  });
});

describe("the values of a point", () => {
  const shares = [[0.1, 0.2], [0.3, 0.4]];
  const document = { groups: {}, equilibrium: {}, contact: {}, eigenvalues: [[1, 2]], growth_shares: { damping: shares, stiffness: shares }, warnings: [] };
  const point = { point: document, modes: [], dimensional: {} } as unknown as Point;

  it("say what the errors of the law leave of the verdict, and nothing of it for a formula", () => {
    const within = (marginal: boolean | null, error: number | null) => {
      const told = { ...document, verdict: "unstable", marginal_within_law: marginal, equivalent_damping_error: error, growth_rate_within_law: [-1, 2] };
      act(() => render(<PointValues point={{ ...point, point: told } as unknown as Point} />, host));
      const text = (key: string) => host.querySelector(`[data-key="${key}"]`)?.textContent;
      return [text("verdict"), text("marginal_within_law"), text("growth_rate_within_law.0")];
    };
    expect(within(true, 0.5)).toEqual(["unstable", "marginal: its errors decide", "-1"]);
    expect(within(false, 0.5)?.[1]).toBe("the same");
    expect(within(null, null)?.[1]).toBe("not known");
    expect(within(false, 0)).toEqual(["unstable", undefined, undefined]);
  });

  it("leave the shares of the growth rate to a page that shows them itself", () => {
    act(() => render(<PointValues point={point} />, host));
    expect(host.querySelector('[data-key="growth_shares.damping.1.0"]')?.textContent).toBe("0.3");
    act(() => render(<PointValues point={point} shares={false} />, host));
    expect(host.querySelector('[data-key="growth_shares.damping.1.0"]')).toBeNull();
  });
});

describe("results of values before", () => {
  const refused = new RequestError("the load is negative", 400, null, null);

  it("say whether the present values are refused or the server is gone", () => {
    expect(ofBefore(refused)).toContain("refused");
    expect(ofBefore(asRequestError(new TypeError("fetch failed")))).toBe("Of the values before: the server does not answer.");
    for (const status of [429, 500, 503]) expect(ofBefore(new RequestError("busy", status, null, null))).not.toMatch(/refused|server/);
  });

  it("say so beside what a part of a page has computed", () => {
    const idle = { frame: null, asked: null, current: false, busy: false, progress: null, stopped: false, start: () => {}, stop: () => {} };
    const note = (error: RequestError | null) => {
      act(() => render(<Results computation={{ ...idle, error }}>numbers</Results>, host));
      return host.querySelector(".contact-note")?.textContent;
    };
    expect(note(refused)).toBe(ofBefore(refused));
    expect(note(asRequestError(new TypeError("fetch failed")))).toContain("does not answer");
    expect(note(null)).toBe("These are results of parameters before.");
  });
});

describe("how results stand", () => {
  const refused = new RequestError("`indenter.radius` must be a length, but this is a force", 422, null, "write a length");
  const facts: Facts = { has: true, isCurrent: false, busy: false };

  it("is said of old ones alone, the reason first", () => {
    expect(standingOf({ ...facts, isCurrent: true, busy: true, error: refused })).toBeNull();
    expect(standingOf({ ...facts, has: false })).toBeNull();
    expect(standingOf(facts)).toMatchObject({ kind: "before" });
    expect(standingOf({ ...facts, busy: true, what: "the contact law", progress: { done: 3, of: 9 }, error: refused })).toEqual({
      kind: "computing", words: "Computing the contact law… 3 of 9. What is shown is of the values before.",
    });
    expect(standingOf({ ...facts, error: refused })?.words).toBe("indenter.radius must be a length, but this is a force. Write a length. Of the values before: the present ones are refused.");
    // where there is nothing before, the message stands in the empty plot
    expect(standingOf({ ...facts, has: false, error: refused })?.words).toBe("indenter.radius must be a length, but this is a force. Write a length.");
  });

  it("begins with a large letter where it begins with a word: names of files and symbols stay as they are", () => {
    const said = (message: string) => standingOf({ ...facts, has: false, error: new RequestError(message, 422, null, null) })?.words;
    expect(said("rubber-dma.csv: line 3 has two columns")).toBe("rubber-dma.csv: line 3 has two columns.");
    const kept = ["data/rubber.csv has no lines", "law.json: missing field", "τ must be a time", "k_x is negative", "v is no speed", "ω_nx τ = 40 is large"];
    for (const message of kept) expect(said(message)).toBe(`${message}.`);
    expect(["the load is negative", "a sweep has 2 points", "glass, rubber", "steady-sliding laws hold"].map(said)).toEqual([
      "The load is negative.", "A sweep has 2 points.", "Glass, rubber.", "Steady-sliding laws hold.",
    ]);
  });

  it("is drawn over the plot, which is paler", () => {
    act(() => render(<StandingContext.Provider value={standingOf({ ...facts, error: refused })}><Chart spec={spec} /></StandingContext.Provider>, host));
    expect(host.querySelector<HTMLElement>(".chart")?.dataset["standing"]).toBe("refused");
    expect(host.querySelector(".chart-standing")?.textContent).toContain("must be a length");
    act(() => render(<Chart spec={spec} />, host));
    expect(host.querySelector(".chart-standing")).toBeNull();
    expect(host.querySelector<HTMLElement>(".chart")?.dataset["standing"]).toBeUndefined();
  });

  it("waits a moment with what only takes its time, and starts anew with every newer picture", () => {
    vi.useFakeTimers();
    let told: string | undefined;
    const Probe = ({ given, result }: { readonly given: Facts; readonly result: number }) => {
      told = useStanding(given, result)?.kind;
      return null;
    };
    const show = (given: Facts, result: number) => act(() => render(<Probe given={given} result={result} />, host));
    const wait = (time: number) => act(() => void vi.advanceTimersByTime(time));
    show({ ...facts, busy: true }, 1);
    wait(300);
    show({ ...facts, busy: true }, 2);
    wait(300);
    expect(told).toBeUndefined();
    wait(200);
    expect(told).toBe("computing");
    show({ ...facts, isCurrent: true }, 3);
    expect(told).toBeUndefined();
    show({ ...facts, error: refused }, 3);
    expect(told).toBe("refused");
    vi.useRealTimers();
  });
});
