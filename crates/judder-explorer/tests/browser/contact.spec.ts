/** The contact page: its numbers are those of `judder run` with the case that it exports. */

import { copyFileSync } from "node:fs";
import { join } from "node:path";
import { type Explorer, ROOT, at, downloaded, expect, judder, test } from "./explorer";

const numbers = (explorer: Explorer) =>
  explorer.page.locator("[data-key^='scalars.']").evaluateAll((found) =>
    found.map((one) => [(one as HTMLElement).dataset["key"]?.replace("scalars.", "") ?? "", (one as HTMLElement).dataset["value"] ?? ""] as const),
  );

/** Runs the exported case of the view; the scalars of its one analysis. */
async function run(explorer: Explorer): Promise<unknown> {
  const { page, folder } = explorer;
  await page.locator("summary", { hasText: "Export" }).click();
  const file = await downloaded(page, () => page.getByRole("button", { name: "Case file" }).click());
  copyFileSync(file.path, join(folder, "contact.toml"));
  const results = judder(folder, "run", "contact.toml")["results"] as Record<string, unknown>;
  return Object.values(results)[0];
}

for (const [part, least] of [["material", 4], ["solution", 6]] as const) {
  test(`the numbers of the ${part} are those of a run`, async ({ explorer }) => {
    await explorer.open(`/contact?part=${part}&set=substrate.glassy_modulus=5 MPa`);
    await expect(explorer.page.locator("[data-current=true]").first()).toBeVisible();
    await expect(explorer.page.locator("[aria-busy=true]")).toHaveCount(0);
    const shown = await numbers(explorer);
    const scalars = await run(explorer);
    for (const [key, value] of shown) expect(value, key).toBe(String(at(scalars, key)));
    expect(shown.length).toBeGreaterThanOrEqual(least);
  });
}

test("the law follows a slider", async ({ explorer }) => {
  const { page } = explorer;
  await explorer.open("/contact?part=law");
  const force = page.locator("[data-key='law.force']");
  await expect(force).not.toHaveText("—");
  const before = await force.textContent();
  await page.getByRole("combobox", { name: /contact law/ }).first().selectOption("hertz");
  await expect(page).toHaveURL(/set=contact\.law=hertz/);
  await expect(force).not.toHaveText(before ?? "");
});

test("a fit is cancelled", async ({ explorer }) => {
  const { page } = explorer;
  await explorer.open("/contact?part=fit");
  const cancel = page.getByRole("button", { name: "Cancel" });
  await cancel.click();
  await expect(cancel).toHaveCount(0);
  // the server is free for others
  await explorer.open("/map");
  await expect(page.locator(".map-chart")).toHaveAttribute("data-stage", "exact");
});

test("a contact of parameters before stands pale, with words over it", async ({ explorer }) => {
  const { page } = explorer;
  for (const part of ["material", "law", "solution"]) {
    await explorer.open(`/contact?part=${part}`);
    await expect(page.locator("[data-current=true]").first()).toBeVisible();
    await expect(page.locator(".chart-standing")).toHaveCount(0);
    const radius = page.getByRole("textbox", { name: /^radius/ });
    await radius.fill("3 N");
    await radius.press("Enter");
    const charts = await page.locator("main .chart").all();
    expect(charts.length).toBeGreaterThan(0);
    for (const chart of charts) await expect(chart.locator(".chart-standing")).toContainText("indenter.radius must be a length");
  }
});

test.describe("a contact case", () => {
  test.use({ subject: [join(ROOT, "cases/contact/sliding-sphere.toml")] });

  test("shows no oscillator", async ({ explorer }) => {
    const { page } = explorer;
    for (const part of ["material", "law", "fit", "solution"]) {
      await explorer.open(`/contact?part=${part}`);
      if (part === "material" || part === "solution") await expect(page.locator("[data-current=true]").first()).toBeVisible();
      const parameters = await page.locator("[data-parameter]").evaluateAll((rows) => rows.map((row) => (row as HTMLElement).dataset["parameter"] ?? ""));
      expect(parameters.length).toBeGreaterThan(3);
      expect(parameters.filter((path) => !/^(substrate|indenter)\./.test(path))).toEqual([]);
      const drawn = (await page.locator("main svg").allTextContents()).join(" ");
      expect(drawn).not.toMatch(/oscillator|40 rad/);
      await expect(page.getByRole("combobox", { name: /contact law/ })).toHaveCount(0);
    }
    await explorer.open("/contact?set=oscillator.natural_frequency=40 rad/s");
    await expect(page.locator(".told")).toContainText("oscillator.natural_frequency");
  });
});
