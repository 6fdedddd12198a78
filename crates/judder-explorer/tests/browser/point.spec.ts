/** The point page: motion, cycle and branch are those of `judder run` with the case of each. */

import { copyFileSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { type Explorer, ROOT, at, downloaded, expect, held, judder, test } from "./explorer";

test.use({ subject: [join(ROOT, "cases/oscillator-paper/fig-12.toml")] });

/** The card of a heading. */
const card = (explorer: Explorer, heading: string) => explorer.page.locator("section").filter({ has: explorer.page.getByRole("heading", { name: heading, exact: true }) });

async function compared(explorer: Explorer, heading: string, prefix: string, names: readonly string[]): Promise<void> {
  const section = card(explorer, heading);
  const file = await downloaded(explorer.page, () => section.getByRole("button", { name: "Case file" }).click());
  copyFileSync(file.path, join(explorer.folder, "run.toml"));
  const results = Object.values(judder(explorer.folder, "run", "run.toml")["results"] as object)[0];
  for (const name of names) {
    const shown = section.locator(`[data-key="${prefix}.${name}"]`);
    await expect(shown, name).toHaveAttribute("data-value", String(at(results, name)));
  }
}

test("a motion is drawn while it runs, and its numbers are those of a run", async ({ explorer }) => {
  await explorer.open("/point?run=motion&duration=200&set=operation.velocity=1e-3");
  await expect(card(explorer, "Motion from here").locator("[data-key='motion.rms']")).toBeVisible();
  await compared(explorer, "Motion from here", "motion", ["rms", "stick_fraction", "steps"]);
});

test("a limit cycle is that of a run, and can be heard", { tag: "@expensive" }, async ({ explorer }) => {
  const { page } = explorer;
  await explorer.open("/point?run=cycle&set=operation.velocity=1e-3");
  await expect(card(explorer, "Limit cycle").locator("[data-key='cycle.period']")).toBeVisible();
  await compared(explorer, "Limit cycle", "cycle", ["period", "rms", "stick_fraction"]);
  const sound = card(explorer, "Sound");
  await expect(sound).toContainText(/faster than real|slower than real/);
  await sound.getByRole("button", { name: "Play" }).click();
  await expect(sound.getByRole("button", { name: "Stop" })).toBeEnabled();
  await sound.getByRole("button", { name: "Stop" }).click();
  const wav = readFileSync((await downloaded(page, () => sound.getByRole("button", { name: "WAV" }).click())).path);
  expect(wav.subarray(0, 4).toString() + wav.subarray(8, 12).toString()).toBe("RIFFWAVE");
  const samples = new Int16Array(wav.buffer.slice(wav.byteOffset + 44, wav.byteOffset + 44 + 2 * Math.floor((wav.length - 44) / 2)));
  expect(Math.max(...samples.subarray(0, 20_000).map(Math.abs)), "it can be heard").toBeGreaterThan(3000);
});

test("eigenvalues leave a trail, and have a path along a key", async ({ explorer }) => {
  const { page } = explorer;
  await explorer.open("/point?along=contact.shear_strength");
  const eigen = card(explorer, "Eigenvalues");
  await expect(eigen).toContainText("path along shear strength");
  const slider = page.getByRole("slider", { name: "damping x" });
  await slider.focus();
  for (let step = 0; step < 12; step += 1) {
    await slider.press("ArrowRight");
    await page.waitForTimeout(120);
  }
  await expect(eigen).toContainText(/trail/);
  await expect(page).toHaveURL(/set=oscillator\.damping_x/);
});

test("a moving mode is saved as picture and as numbers", async ({ explorer }) => {
  const { page } = explorer;
  await explorer.open("/point");
  await page.getByText("Export", { exact: true }).click();
  const saved = async (kind: string) => readFileSync((await downloaded(page, () => page.getByRole("button", { name: new RegExp(`^${kind} of Orbit of`) }).first().click())).path);
  const svg = (await saved("SVG")).toString();
  const drawn = /viewBox="0 0 (\d+) (\d+)"/.exec(svg);
  const png = await saved("PNG");
  // twice the size of the SVG, four times that of what it is drawn in
  expect([png.readUInt32BE(16), png.readUInt32BE(20)]).toEqual([4 * Number(drawn?.[1]), 4 * Number(drawn?.[2])]);
  const rows = (await saved("CSV")).toString().trim().split("\n").slice(1).map((row) => row.split(",").map(Number));
  const distances = rows.map(([, x, y]) => Math.hypot(x ?? 0, y ?? 0));
  expect(rows.length).toBeGreaterThan(50);
  expect(Math.max(...distances)).toBeGreaterThan(0.99);
  expect(Math.max(...distances)).toBeLessThan(1.001);
});

test("a long motion is cancelled, and the page goes on", async ({ explorer }) => {
  const { page } = explorer;
  await explorer.open("/point?run=motion&duration=1000000&points=4096&set=operation.velocity=1e-3");
  const motion = card(explorer, "Motion from here");
  await motion.getByRole("button", { name: "Cancel" }).click();
  await expect(motion.getByRole("button", { name: "Cancel" })).toBeDisabled();
  await page.getByRole("link", { name: "Map", exact: true }).click();
  await expect(page.locator(".map-chart")).toHaveAttribute("data-stage", "exact");
});

test("a point of values before stands pale, with words over it, and says why it is refused", async ({ explorer }) => {
  const { page } = explorer;
  await explorer.open("/point?along=operation.velocity&run=motion&duration=200");
  await expect(card(explorer, "Motion from here").locator("[data-key='motion.rms']")).toBeVisible();
  const charts = (heading: string) => card(explorer, heading).locator(".chart");
  for (const heading of ["Eigenvalues", "Motion from here"]) await expect(charts(heading).first()).not.toHaveAttribute("data-standing");
  const letGo = await held(page);
  await page.getByRole("combobox", { name: /contact law/ }).selectOption("bem");
  for (const chart of await charts("Eigenvalues").all()) await expect(chart).toHaveAttribute("data-standing", "computing");
  for (const chart of await charts("Motion from here").all()) {
    await expect(chart).toHaveAttribute("data-standing", "before");
    await expect(chart.locator(".chart-standing")).toContainText("Of the values before");
  }
  await letGo();
  const radius = page.getByRole("textbox", { name: /^radius/ });
  await radius.fill("3 N");
  await radius.press("Enter");
  await expect(charts("Eigenvalues").first().locator(".chart-standing")).toContainText("indenter.radius must be a length");
  await expect(page.locator("[data-parameter='indenter.radius']")).toHaveClass(/parameter-refused/);
});

test("a duration that is none is marked, and said where the motion would be", async ({ explorer }) => {
  await explorer.open("/point?run=motion&duration=5 m");
  const motion = card(explorer, "Motion from here");
  await expect(motion).toContainText("must be a time");
  await expect(motion.getByRole("textbox", { name: "duration" })).toHaveAttribute("aria-invalid", "true");
});
