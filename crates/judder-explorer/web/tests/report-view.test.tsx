// @vitest-environment happy-dom
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { render } from "preact";
import { act } from "preact/test-utils";
import { beforeAll, describe, expect, it } from "vitest";
import { ReportTables } from "../src/pages/structures/ReportTables";
import { reportCharts } from "../src/pages/structures/reportCharts";
import { type Report, reportOf } from "../src/pages/structures/useReport";
import type { Figure } from "../src/report/described";

/** A figure with layers of every kind, as the tests of `judder-report` describe it. */
const FIGURE = readFileSync(join(import.meta.dirname, "figure.json"), "utf8");
let report: Report;

beforeAll(async () => {
  report = await reportOf({ figure: FIGURE, undrawn: null, tables: [] });
});

describe("what the server tells of a report", () => {
  it("is a figure with its arrays", () => {
    expect([report.figure?.panels.length, report.error]).toEqual([4, null]);
  });

  it("may be why there is none, or that it cannot be read, and keeps its tables", async () => {
    const tables = [{ caption: "c", head: ["h"], rows: [["1"]] }];
    const undrawn = await reportOf({ figure: null, undrawn: { message: "too many", help: "fewer" }, tables });
    expect([undrawn.figure, undrawn.error?.message, undrawn.error?.help, undrawn.tables]).toEqual([null, "too many", "fewer", tables]);
    const broken = await reportOf({ figure: "{", undrawn: null, tables });
    expect([broken.figure, broken.error === null, broken.tables]).toEqual([null, false, tables]);
  });
});

describe("the panels of a figure", () => {
  it("are charts with titles of their own and their legends, lettered where there are several", () => {
    const charts = reportCharts(report.figure as Figure);
    const titles = charts.map(({ spec }) => spec.title);
    expect(titles.map((title) => /\(([a-d])\): ./.exec(title)?.[1])).toEqual(["a", "b", "c", "d"]);
    expect(charts.every(({ spec }) => spec.explained === false)).toBe(true);
    const [panel] = (report.figure as Figure).panels;
    const alone = reportCharts({ ...(report.figure as Figure), panels: [panel as Figure["panels"][number]] });
    expect(alone[0]?.spec.title).not.toContain("(a)");
  });

  it("move together over the same axis alone", () => {
    const [panel] = (report.figure as Figure).panels as [Figure["panels"][number]];
    const wider = { ...panel, x: { ...panel.x, range: [panel.x.range[0], 2 * panel.x.range[1]] as const } };
    const charts = reportCharts({ ...(report.figure as Figure), panels: [panel, wider, panel] });
    expect(charts.map(({ names }) => names.x)).toEqual(["figure-x-0", "figure-x-1", "figure-x-0"]);
    expect(new Set(charts.map(({ names }) => names.y)).size).toBe(3);
  });
});

describe("a table of a report", () => {
  it("has its markup, and no head where there is none", () => {
    const host = document.createElement("div");
    const tables = [
      { caption: "Levels of $x$", head: ["point", "rms (m/s^{2})"], rows: [["mass", "1.5"]] },
      { caption: "The cycle", head: ["", ""], rows: [["stable", "yes"]] },
    ];
    act(() => render(<ReportTables tables={tables} />, host));
    const [levels, cycle] = Array.from(host.querySelectorAll("table"));
    expect([levels?.querySelector("thead sup")?.textContent, levels?.querySelector("tbody th")?.textContent]).toEqual(["2", "mass"]);
    expect(host.querySelector("[role=region]")?.getAttribute("aria-label")).toBe("Levels of x");
    expect([cycle?.querySelector("thead"), cycle?.querySelector("td")?.textContent]).toEqual([null, "yes"]);
  });
});
