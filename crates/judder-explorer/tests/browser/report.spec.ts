/** Reports in a browser, as files: their figures, without network, without scripts and on paper. */

import { type Locator, type Page, expect, test as base } from "@playwright/test";
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { JUDDER, ROOT } from "./explorer";

/** Reports of small cases: an oscillator with a map, motions and spectra, and a beam with modes. */
interface Reports {
  readonly oscillator: string;
  readonly beam: string;
}

const test = base.extend<{ report: (name: keyof Reports) => Promise<Page> }, { reports: Reports }>({
  reports: [
    async ({}, use) => {
      const folder = mkdtempSync(join(tmpdir(), "judder-report-"));
      const run = (name: keyof Reports) => {
        execFileSync(JUDDER, ["run", join(ROOT, `crates/judder-models/tests/small/${name}.toml`), "-o", join(folder, name), "-q"]);
        return pathToFileURL(join(folder, name, "report.html")).href;
      };
      await use({ oscillator: run("oscillator"), beam: run("beam") });
      rmSync(folder, { recursive: true });
    },
    { scope: "worker", timeout: 240_000 },
  ],
  report: async ({ page, context, reports }, use) => {
    const faults: string[] = [];
    await context.setOffline(true);
    page.on("console", (message) => {
      if (["error", "warning"].includes(message.type()) && !/GPU stall/.test(message.text())) faults.push(message.text());
    });
    page.on("pageerror", (error) => faults.push(`${error.message}\n${error.stack ?? ""}`));
    page.on("request", (request) => {
      if (!/^(data|blob):|report\.html(#|$)/.test(request.url())) faults.push(`a request to ${request.url()}`);
    });
    await use(async (name) => {
      await page.goto(reports[name]);
      return page;
    });
    expect(faults, "nothing on the console, nothing asked for").toEqual([]);
  },
});

/** A figure whose chart has been drawn. */
async function drawn(figure: Locator): Promise<Locator> {
  await figure.scrollIntoViewIfNeeded();
  await expect(figure.locator(".chart-over").first()).toBeVisible();
  return figure;
}

/** The first figure whose description has a layer of this kind, drawn. */
async function figureWith(page: Page, kind: string): Promise<Locator> {
  const descriptions = await page.locator("[data-plot] > script").evaluateAll((all) => all.map((data) => data.textContent ?? ""));
  const index = descriptions.findIndex((text) => text.includes(`"${kind}":{`));
  expect(index, `a figure with ${kind}`).toBeGreaterThanOrEqual(0);
  return drawn(page.locator("[data-plot]").nth(index));
}

/** What stands at the axes of the first chart of a figure. */
const marks = (figure: Locator) => figure.locator(".chart-over").first().locator("text").allTextContents();

async function middle(chart: Locator): Promise<{ x: number; y: number }> {
  const box = (await chart.boundingBox()) as { x: number; y: number; width: number; height: number };
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

test("every drawing becomes a chart, each panel one", async ({ report }) => {
  for (const name of ["oscillator", "beam"] as const) {
    const page = await report(name);
    const figures = await page.locator("[data-plot]").all();
    expect(figures.length).toBeGreaterThan(2);
    for (const figure of figures) {
      await drawn(figure);
      await expect(figure.locator(".still")).toBeHidden();
      const panels = await figure.locator("script").evaluate((data) => (JSON.parse(data.textContent ?? "") as { panels: unknown[] }).panels.length);
      await expect(figure.locator(".chart")).toHaveCount(panels);
    }
  }
});

test("a chart tells the class of a map's cell under the cursor, and the nearest point of a curve", async ({ report }) => {
  const page = await report("oscillator");
  const map = await figureWith(page, "classes");
  const chart = map.locator(".chart-over").first();
  const place = await middle(chart);
  await page.mouse.move(place.x, place.y);
  const named = await map.locator("script").evaluate((data) => data.textContent ?? "");
  const said = (await map.locator(".chart-readings dd").first().textContent()) ?? "";
  expect(said).not.toBe("");
  expect(named).toContain(`"${said}"`);
  const curve = await drawn(page.locator("[data-plot]").first());
  const chartOfCurve = curve.locator(".chart-over").first();
  await chartOfCurve.scrollIntoViewIfNeeded();
  // rules are strokes too, but of two points
  const start = await chartOfCurve.locator("path[stroke-linejoin='round']").evaluateAll((paths) => {
    const longest = (paths as SVGPathElement[]).reduce((one, other) => ((other.getAttribute("d") ?? "").length > (one.getAttribute("d") ?? "").length ? other : one));
    const point = longest.getPointAtLength(0).matrixTransform(longest.getScreenCTM() as DOMMatrix);
    return { x: point.x, y: point.y };
  });
  await page.mouse.move(start.x + 4, start.y + 4);
  await expect(curve.locator(".chart-found")).toHaveCount(1);
  await expect(curve.locator(".chart-readings dd").last()).toHaveText(/\d/);
});

test("a chart zooms by its buttons, by a box, by keys and with Ctrl and the wheel, and a double click shows everything", async ({ report }) => {
  const page = await report("oscillator");
  const figure = await drawn(page.locator("[data-plot]").first());
  const chart = figure.locator(".chart-over").first();
  const home = await marks(figure);
  const isHome = () => expect.poll(() => marks(figure)).toEqual(home);
  const isZoomed = () => expect.poll(() => marks(figure)).not.toEqual(home);
  const reset = figure.getByRole("button", { name: "Reset" }).first();
  await figure.getByRole("button", { name: "Zoom in" }).first().click();
  await isZoomed();
  await reset.click();
  await isHome();
  await chart.focus();
  await page.keyboard.press("+");
  await isZoomed();
  await page.keyboard.press("0");
  await isHome();
  const place = await middle(chart);
  await page.keyboard.down("Shift");
  await page.mouse.move(place.x - 60, place.y - 50);
  await page.mouse.down();
  await page.mouse.move(place.x + 60, place.y + 50, { steps: 4 });
  await page.mouse.up();
  await page.keyboard.up("Shift");
  await isZoomed();
  await page.mouse.dblclick(place.x, place.y);
  await isHome();
  await page.keyboard.down("Control");
  await page.mouse.wheel(0, -300);
  await page.keyboard.up("Control");
  await isZoomed();
  await reset.click();
  await isHome();
});

test("the wheel alone scrolls the page, and dragging moves what is shown", async ({ report }) => {
  const page = await report("oscillator");
  const figure = await drawn(page.locator("[data-plot]").first());
  const home = await marks(figure);
  const before = await page.evaluate(() => window.scrollY);
  const place = await middle(figure.locator(".chart-over").first());
  await page.mouse.move(place.x, place.y);
  await page.mouse.wheel(0, 120);
  await expect.poll(() => page.evaluate(() => window.scrollY)).toBeGreaterThan(before);
  expect(await marks(figure)).toEqual(home);
  const moved = await middle(figure.locator(".chart-over").first());
  await page.mouse.move(moved.x, moved.y);
  await page.mouse.down();
  await page.mouse.move(moved.x + 130, moved.y + 90, { steps: 4 });
  await page.mouse.up();
  await expect.poll(() => marks(figure)).not.toEqual(home);
});

test("modes swing, and stop where they were", async ({ report }) => {
  const page = await report("beam");
  const figure = await figureWith(page, "swing");
  const shapes = () => figure.locator(".chart-over path[stroke-linejoin='round']").evaluateAll((paths) => paths.map((path) => path.getAttribute("d")).join());
  const rest = await shapes();
  await figure.getByRole("button", { name: "Swing" }).click();
  const seen = new Set<string>();
  await expect.poll(async () => seen.add(await shapes()).size).toBeGreaterThan(3);
  await figure.getByRole("button", { name: "Stop" }).click();
  await expect.poll(shapes).toBe(rest);
});

test("the legend hides and shows curves", async ({ report }) => {
  const page = await report("oscillator");
  const figure = await figureWith(page, "classes");
  await expect(figure.locator(".figure-legend button").first()).toBeVisible();
  const curves = () => figure.locator(".chart-over path[stroke-linejoin='round']").count();
  const all = await curves();
  const entry = figure.locator(".figure-legend button").first();
  await entry.click();
  await expect(entry).toHaveAttribute("aria-pressed", "false");
  expect(await curves()).toBeLessThan(all);
  await entry.click();
  expect(await curves()).toBe(all);
});

test("on a small screen panels stand in one column, and nothing is cut off", async ({ report, page: tab }) => {
  await tab.setViewportSize({ width: 390, height: 800 });
  const page = await report("oscillator");
  for (const figure of await page.locator("[data-plot]").all()) {
    await drawn(figure);
    const lefts = await figure.locator(".panel").evaluateAll((panels) => panels.map((panel) => Math.round(panel.getBoundingClientRect().left)));
    expect(new Set(lefts).size).toBe(1);
  }
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
});

test("in the dark figures stay white, as their drawings are", async ({ report, page: tab }) => {
  await tab.emulateMedia({ colorScheme: "dark" });
  const page = await report("oscillator");
  const figure = await drawn(page.locator("[data-plot]").first());
  const colours = await figure.locator(".live").evaluate((live) => [getComputedStyle(live.parentElement as Element).backgroundColor, getComputedStyle(live).color]);
  expect(colours).toEqual(["rgb(255, 255, 255)", "rgb(26, 26, 26)"]);
});

test("on paper the drawings stand in the place of charts", async ({ report }) => {
  const page = await report("oscillator");
  const figure = await drawn(page.locator("[data-plot]").first());
  await page.emulateMedia({ media: "print" });
  await expect(figure.locator(".still svg")).toBeVisible();
  await expect(figure.locator(".live")).toBeHidden();
});

test("without scripts the drawings stand there, and it says so", async ({ browser, reports }) => {
  const context = await browser.newContext({ javaScriptEnabled: false, offline: true });
  const page = await context.newPage();
  await page.goto(reports.oscillator);
  await expect(page.locator("noscript .hint, .hint")).toContainText("Without scripts the figures are drawings");
  for (const figure of await page.locator("[data-plot]").all()) {
    await expect(figure.locator(".still svg")).toBeVisible();
    await expect(figure.locator(".live")).toBeHidden();
  }
  await context.close();
});

test("a figure that cannot be read stays a drawing", async ({ page, reports }) => {
  await page.addInitScript(() => {
    document.addEventListener("readystatechange", () => {
      const data = document.querySelector("[data-plot] script");
      if (data) data.textContent = "{}";
    });
  });
  await page.goto(reports.oscillator);
  const [first, second] = [page.locator("[data-plot]").first(), page.locator("[data-plot]").nth(1)];
  await drawn(second);
  await first.scrollIntoViewIfNeeded();
  await expect(first.locator(".still svg")).toBeVisible();
  await expect(first.locator(".chart")).toHaveCount(0);
});
