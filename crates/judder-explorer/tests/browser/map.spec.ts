/** The map page: what it shows is what the command computes. */

import { execFileSync } from "node:child_process";
import { copyFileSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { type Explorer, JUDDER, ROOT, at, downloaded, expect, held, judder, test } from "./explorer";

const exact = (explorer: Explorer) => expect(explorer.page.locator(".map-chart")).toHaveAttribute("data-stage", "exact");
const settled = async (explorer: Explorer) => {
  // a drag, or keys on a slider, reach the address a moment later
  const options = () => JSON.stringify(new URL(explorer.page.url()).searchParams.getAll("set"));
  await expect.poll(async () => (await explorer.page.locator(".map-chart").getAttribute("data-set")) === options()).toBe(true);
  await exact(explorer);
  await expect(explorer.page.locator(".map-chart")).toHaveAttribute("data-busy", "false");
  await expect(explorer.page.locator(".cursor-panel[aria-busy=true]")).toHaveCount(0);
};

/** Every number of the panel, by its path in the document of the point: as it is shown, and with all its digits. */
async function shown(explorer: Explorer): Promise<[string, string, string][]> {
  const values = explorer.page.locator(".cursor-panel [data-key]");
  return values.evaluateAll((found) =>
    found.map((one) => [(one as HTMLElement).dataset["key"] ?? "", one.textContent ?? "", (one as HTMLElement).dataset["value"] ?? ""]),
  );
}

test("shows the map, and the numbers under the cursor to their last digit", async ({ explorer }) => {
  const { page, folder } = explorer;
  await explorer.open("/map?cursor=1e-3,0.1");
  await settled(explorer);
  const slider = page.getByRole("slider", { name: "damping x" });
  const legend = page.locator(".map-chart");
  const before = await legend.textContent();
  await slider.focus();
  for (let step = 0; step < 5; step += 1) await slider.press("ArrowRight");
  await expect(page).toHaveURL(/set=oscillator\.damping_x=/);
  await settled(explorer);
  expect(await legend.textContent(), "the shares of the map have moved with the slider").not.toBe(before);
  const set = new URL(page.url()).searchParams.getAll("set").flatMap((option) => ["--set", option]);
  const case_ = ["--set", "operation.velocity=0.001", "--set", "contact.shear_strength=0.1", ...set];
  writeTemplate(folder);
  const point = judder(folder, "point", "case.toml", ...case_);
  let compared = 0;
  for (const [key, text, whole] of await shown(explorer)) {
    const value = at(point, key);
    if (value === undefined) continue;
    expect(whole, key).toBe(String(value));
    expect(typeof value === "number" ? Number(text) : text, key).toBe(typeof value === "number" ? Number(value.toPrecision(6)) : value);
    compared += 1;
  }
  expect(compared, "most of the panel is of the document").toBeGreaterThan(8);
});

test("zooms, and computes at the new scale", async ({ explorer }) => {
  const { page } = explorer;
  await explorer.open("/map");
  await settled(explorer);
  const box = (await page.locator(".map-chart svg").first().boundingBox()) ?? { x: 0, y: 0, width: 0, height: 0 };
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.wheel(0, -600);
  await expect(page).toHaveURL(/x=operation\.velocity~/);
  await settled(explorer);
  const [from, to] = new URL(page.url()).searchParams.get("x")?.split("~").slice(1, 3).map(Number) ?? [];
  expect(from).toBeGreaterThan(1e-8);
  expect(to).toBeLessThan(1e2);
  await page.getByRole("button", { name: "Undo" }).click();
  await expect(page).not.toHaveURL(/x=operation\.velocity~/);
  await page.getByRole("button", { name: "Redo" }).click();
  await expect(page).toHaveURL(/x=operation\.velocity~/);
});

test("opens the point under the cursor", async ({ explorer }) => {
  const { page } = explorer;
  await explorer.open("/map?cursor=2e-4,0.02");
  await settled(explorer);
  await page.getByRole("link", { name: "Open this point" }).click();
  await expect(page).toHaveURL(/\/point\?/);
  const set = new URL(page.url()).searchParams.getAll("set");
  expect(set.sort()).toEqual(["contact.shear_strength=0.02", "operation.velocity=0.0002"]);
});

test("exports a case that the command runs to the same map", async ({ explorer }) => {
  const { page, folder } = explorer;
  await explorer.open("/map?set=oscillator.damping_y=0.03&show=full");
  await settled(explorer);
  const legend = await page.locator(".map-chart").textContent();
  await page.locator("summary", { hasText: "Export" }).click();
  const file = await downloaded(page, () => page.getByRole("button", { name: "Case file" }).click());
  expect(file.name).toMatch(/\.toml$/);
  copyFileSync(file.path, join(folder, "exported.toml"));
  const summary = judder(folder, "run", "exported.toml");
  const results = at(summary, "results.map") as Record<string, number>;
  const stable = 100 * (1 - (results["unstable_fraction"] ?? 0));
  expect(legend, "the shares of the legend are those of the run").toContain(`${stable.toFixed(1)} %`);
});

test("says over the map what a run of it warns of", async ({ explorer }) => {
  const { page, folder } = explorer;
  await explorer.open("/map?set=substrate.retardation_time=1 s");
  await settled(explorer);
  const note = page.getByRole("note", { name: "Warnings of the map" });
  await expect(note).toContainText("eq. (3)");
  await expect(note).toBeInViewport();
  await page.locator("summary", { hasText: "Export" }).click();
  const file = await downloaded(page, () => page.getByRole("button", { name: "Case file" }).click());
  copyFileSync(file.path, join(folder, "exported.toml"));
  const warnings = at(judder(folder, "run", "exported.toml"), "analyses.map.warnings") as string[];
  const shown = await note.locator("li").allTextContents();
  // the run follows boundaries too
  expect(warnings.filter((warning) => !/^[a-z ]*boundary/.test(warning))).toEqual(shown);
});

test("exports pictures and numbers", async ({ explorer }) => {
  const { page } = explorer;
  await explorer.open("/map");
  await settled(explorer);
  const take = async (kind: string) => {
    await page.locator("details.menu:not([open]) summary").click({ timeout: 1000 }).catch(() => undefined);
    return downloaded(page, () => page.getByRole("button", { name: new RegExp(`^${kind} of`) }).first().click());
  };
  const svg = readFileSync((await take("SVG")).path, "utf8");
  expect(svg).toMatch(/^<(\?xml|svg)/);
  expect(svg).toContain("data:image/png;base64,");
  expect(svg).not.toMatch(/https?:\/\/(?!www\.w3\.org)/);
  const png = readFileSync((await take("PNG")).path);
  expect(png.subarray(1, 4).toString()).toBe("PNG");
  const csv = readFileSync((await take("CSV")).path, "utf8");
  expect(csv.split("\n").length).toBeGreaterThan(1000);
});

test("keeps the last good picture beside an error", async ({ explorer }) => {
  const { page } = explorer;
  await explorer.open("/map");
  await settled(explorer);
  const field = page.getByRole("textbox", { name: /^radius/ });
  await field.fill("3 N");
  await field.press("Enter");
  const told = page.locator(".content").getByText("must be a length").or(page.locator(".parameter").getByText("must be a length"));
  await expect(told.first()).toBeVisible();
  await exact(explorer);
  const [chart, status] = [page.locator(".map-chart"), page.locator(".map-status")];
  await expect(chart).toHaveAttribute("data-refused", "true");
  await expect(chart.locator(".chart-picture")).toHaveCSS("opacity", "0.45");
  await expect(status).toHaveText("Of the values before: the present ones are refused.");
  await page.getByRole("button", { name: "Undo" }).click();
  await expect(told).toHaveCount(0);
  await expect(chart).toHaveAttribute("data-refused", "false");
  await expect(status).toContainText("400 × 400 points");
});

test("says in the plot what is refused where there is no map before, and marks the control", async ({ explorer }) => {
  const { page } = explorer;
  for (const viewport of [{ width: 1440, height: 900 }, { width: 420, height: 800 }]) {
    await page.setViewportSize(viewport);
    await explorer.open("/map?set=indenter.radius=3 N");
    const message = page.locator(".map-chart .chart-standing");
    await expect(message).toContainText("indenter.radius must be a length");
    await page.locator(".map-chart").scrollIntoViewIfNeeded();
    await expect(message).toBeInViewport();
    const [plot, words] = [await page.locator(".map-chart .chart-picture").boundingBox(), await message.boundingBox()];
    expect((words?.y ?? 0) - (plot?.y ?? 0), "within the picture").toBeGreaterThan(0);
    await expect(page.locator(".panel-head .panel-refused")).toHaveText("radius is refused");
    await expect(page.locator("[data-parameter='indenter.radius']")).toHaveClass(/parameter-refused/);
  }
  await page.setViewportSize({ width: 1440, height: 900 });
  await explorer.open("/map?x=operation.velocity~3 N~1~log");
  await expect(page.getByRole("textbox", { name: "From, x axis" })).toHaveAttribute("aria-invalid", "true");
  await expect(page.locator(".map-chart .chart-standing")).toContainText("must be a speed");
});

test("a map of values before stands pale, with words over it, until the new one comes", async ({ explorer }) => {
  const { page } = explorer;
  // the law is chosen beside the shear strength, which must be no axis
  await explorer.open("/map?y=operation.normal_load~1e-8~1e-4~log");
  await settled(explorer);
  const chart = page.locator(".map-chart .chart");
  await expect(chart).not.toHaveAttribute("data-standing");
  const law = page.getByRole("combobox", { name: /contact law/ });
  const letGo = await held(page);
  await law.selectOption("bem");
  await expect(chart).toHaveAttribute("data-standing", "computing");
  await expect(chart.locator(".chart-picture")).toHaveCSS("opacity", "0.45");
  await expect(chart.locator(".chart-standing")).toContainText("What is shown is of the values before.");
  await law.selectOption("hertz");
  await letGo();
  await settled(explorer);
  await expect(chart).not.toHaveAttribute("data-standing");
  await expect(chart.locator(".chart-picture")).toHaveCSS("opacity", "1");
});

test("an address is the view", async ({ explorer }) => {
  const { page } = explorer;
  const address = "/map?set=oscillator.coupling=0.5&cursor=0.0001,0.03&show=conservative&x=operation.velocity~1e-6~1~log&y=operation.normal_load~1e-8~1e-4~log";
  await explorer.open(address);
  await settled(explorer);
  const first = await shown(explorer);
  await page.reload();
  await settled(explorer);
  expect(await shown(explorer)).toEqual(first);
  expect(first.length).toBeGreaterThan(8);
  await explorer.open("/map?set=operation.sped=1&x=nothing&cursor=a,b&foo=bar");
  await settled(explorer);
  await expect(page.locator(".told")).toContainText("operation.sped");
});

/** The case that `judder explore` takes by itself. */
function writeTemplate(folder: string): void {
  writeFileSync(join(folder, "case.toml"), execFileSync(JUDDER, ["new", "oscillator"]));
}

test("exports the case of the book from the book's address", async ({ explorer }) => {
  const chapter = readFileSync(join(ROOT, "docs/src/explorer.md"), "utf8");
  const address = /^\/map\?.*$/m.exec(chapter)?.[0] ?? "";
  await explorer.open(address);
  await settled(explorer);
  await explorer.page.locator("summary", { hasText: "Export" }).click();
  const file = await downloaded(explorer.page, () => explorer.page.getByRole("button", { name: "Case file" }).click());
  expect(readFileSync(file.path, "utf8")).toBe(readFileSync(join(ROOT, "cases/explorer/found-by-hand.toml"), "utf8"));
});
