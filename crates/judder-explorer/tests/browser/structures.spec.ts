/** The structures page: what a study folder holds, for a sliding case, a structure and an assembly. */

import { copyFileSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { ROOT, at, downloaded, expect, judder, studies as test } from "./explorer";

test.describe("a sliding case", () => {
  test.use({ subject: async ({ sliding }, use) => use([sliding.folder]) });

  test("shows its locus, its zones and its shapes", async ({ explorer, sliding }) => {
    const { page } = explorer;
    await explorer.open("/structures?analysis=locus&at=0.05");
    const zones = at(sliding.results, "locus.unstable") as Record<string, number>[];
    const first = page.locator("[data-key='locus.zone_frequency.0']");
    if (zones[0]) await expect(first).toHaveAttribute("data-value", String(zones[0]["frequency_hz"]));
    else await expect(page.locator("main")).toContainText(/no unstable zone/i);
    // the shapes of the coupled pair at this position
    await expect(page.locator("main")).toContainText("Eigenvalues at 0.05");
    await expect(page.locator("[data-key='shape.largest']")).toBeVisible();
    await page.getByRole("slider").first().press("ArrowRight");
    await expect(page).not.toHaveURL(/at=0\.05(&|$)/);
  });

  test("gives the case of one analysis, which runs to the same numbers", async ({ explorer, sliding }) => {
    const { page } = explorer;
    await explorer.open("/structures?analysis=velocity");
    await expect(page.getByRole("heading", { name: /^velocity/ })).toBeVisible();
    await page.getByText("Export", { exact: true }).click();
    const file = await downloaded(page, () => page.getByRole("button", { name: "Case file" }).click());
    expect(file.name).toMatch(/^falling-friction-velocity\.toml$/);
    expect(readFileSync(file.path, "utf8").match(/^\[\[analysis\]\]/gm)).toHaveLength(1);
    copyFileSync(file.path, join(explorer.folder, "velocity.toml"));
    const results = judder(explorer.folder, "run", "velocity.toml")["results"] as Record<string, unknown>;
    expect(results).toEqual({ velocity: at(sliding.results, "velocity") });
  });

  test("shows and plays its march", async ({ explorer, sliding }) => {
    const { page } = explorer;
    await explorer.open("/structures?analysis=film");
    await expect(page.locator("main")).toContainText(String(at(sliding.results, "film.slip_steps")));
    await page.getByRole("button", { name: "Play", exact: true }).click();
    await expect(page.getByRole("button", { name: "Stop" })).toBeVisible();
  });
});

test.describe("a structure", () => {
  test.use({ subject: async ({ block }, use) => use([block.folder]) });

  test("shows its modes in three dimensions", async ({ explorer, block }) => {
    const { page } = explorer;
    await explorer.open("/structures?analysis=modes");
    const frequencies = at(block.results, "modes.frequencies_hz") as number[];
    for (const index of [0, 5]) {
      await expect(page.locator(`[data-key$='frequency.${index}']`).first()).toHaveAttribute("data-value", String(frequencies[index]));
    }
    await expect(page.locator("canvas").first()).toBeVisible();
    await page.getByRole("button", { name: "Top" }).click();
    await expect(page).toHaveURL(/look=/);
    // keys that follow one another are undone at once
    const around = page.getByRole("slider", { name: "Around" });
    await around.focus();
    for (let step = 0; step < 3; step += 1) await around.press("ArrowRight");
    await expect(around).toHaveValue("15");
    await page.getByRole("button", { name: "Undo" }).click();
    await expect(around).toHaveValue("0");
  });
});

test.describe("an assembly", () => {
  test.use({ subject: async ({ disc }, use) => use([disc.folder]) });

  test("shows its contact map: what is closed and open, the pressure, the bodies by name", async ({ explorer, disc }) => {
    const { page } = explorer;
    await explorer.open("/structures");
    await expect(page.getByRole("heading", { name: /^steady steady-sliding/ })).toBeVisible();
    const sums = at(disc.results, "steady.contacts.pad") as Record<string, number>;
    for (const name of ["closed", "open", "normal_force", "pressure_max"]) {
      await expect(page.locator(`[data-key='steady.contacts.pad.${name}']`).first()).toHaveAttribute("data-value", String(sums[name]));
    }
    await expect(page.locator("canvas").first()).toBeVisible();
    await expect(page.locator("[data-key='contacts.largest']")).toHaveAttribute("data-value", String(sums["pressure_max"]));
    await expect(page.getByRole("list", { name: "What is shown" })).toContainText(/disc.*pad.*closed contact point.*open contact point/);
    await expect(page.locator("main")).toContainText(/Displacements are drawn \d+ times as large as they are; the largest is .* µm\./);
    await expect(page.locator("[data-key='steady.converged']")).toHaveAttribute("data-value", "true");
    // nothing swings
    await expect(page.getByRole("button", { name: "Play" })).toHaveCount(0);
    await expect(page.getByRole("slider", { name: "Phase" })).toHaveCount(0);
    await page.getByRole("slider", { name: "Scale" }).press("ArrowRight");
    await expect(page).toHaveURL(/scale=1\.05/);
  });

  test("shows complex modes, and what makes one grow", async ({ explorer, disc }) => {
    const { page } = explorer;
    const growing = at(disc.results, "modes.growing") as { mode: number; growth: Record<string, number>; parents: { frequency_hz: number }[] }[];
    const first = growing[0] as (typeof growing)[number];
    await explorer.open(`/structures?analysis=modes&mode=${first.mode}`);
    const eigenvalue = at(disc.results, `modes.eigenvalues.${first.mode - 1}`) as { damping_ratio: number };
    await expect(page.locator(`[data-key='modes.damping_ratio.${first.mode - 1}']`)).toHaveAttribute("data-value", String(eigenvalue.damping_ratio));
    for (const [name, growth] of Object.entries(first.growth)) {
      await expect(page.locator(`[data-key='modes.growing.0.growth.${name}']`)).toHaveAttribute("data-value", String(growth));
    }
    await expect(page.locator("[data-key='modes.growing.0.parents.0.frequency_hz']")).toHaveAttribute("data-value", String(first.parents[0]?.frequency_hz));
    await expect(page.locator("[data-key='modes.complete']")).toHaveAttribute("data-value", String(at(disc.results, "modes.complete")));
    await expect(page.locator("canvas").first()).toBeVisible();
    // a mode that decays has no such shares
    const stable = [1, 2, 3, 4, 5].find((mode) => growing.every((one) => one.mode !== mode)) as number;
    await page.getByRole("button", { name: String(stable), exact: true }).click();
    await expect(page.getByRole("region", { name: /^Why mode/ })).toHaveCount(0);
  });
});

test.describe("a brake that squeals", () => {
  test.use({ subject: async ({ brake }, use) => use([brake.folder]) });

  test("shows its limit cycle: portrait, states over one period, levels", async ({ explorer, brake }) => {
    const { page } = explorer;
    await explorer.open("/structures?analysis=cycle");
    const main = page.locator("main");
    for (const title of ["stiffening: states of the points", "linear: states of the points", "contact point 1"]) {
      await expect(main.locator("figure").filter({ hasText: `: ${title}` }).locator(".chart svg").first()).toBeVisible();
    }
    const levels = page.getByRole("region", { name: "Accelerations of the observed points" });
    const mass = at(brake.results, "cycle.levels") as Record<string, { level_db: number }>;
    for (const [name, { level_db: level }] of Object.entries(mass)) {
      await expect(levels.getByRole("row", { name: new RegExp(`^${name} .* ${Number(level.toPrecision(6))}$`) })).toBeVisible();
    }
    // what the figure is made of comes when it is asked for
    const drawn = await main.locator("figure").count();
    await page.getByText("All arrays of cycle").click();
    await expect.poll(() => main.locator("figure").count()).toBeGreaterThan(drawn);
  });

  test("shows how its cycle grows along a key, whose panels move together", async ({ explorer }) => {
    const { page } = explorer;
    await explorer.open("/structures?analysis=damping");
    const charts = page.locator("main figure .chart");
    await expect(charts).toHaveCount(2);
    await expect(page.locator("main")).toContainText("stable ones solid, unstable ones dashed");
    await expect(charts.first()).toContainText("stable cycles");
    await charts.first().hover();
    await page.mouse.wheel(0, -300);
    await expect(page).toHaveURL(/zoom=figure-x-0(:|%3A)/);
  });
});

test.describe("a belt that may be knocked", () => {
  test.use({ subject: async ({ belt }, use) => use([belt.folder]) });

  test("shows its ranking, its margin and its knocks", async ({ explorer, belt }) => {
    const { page } = explorer;
    await explorer.open("/structures?analysis=squeal");
    await expect(page.locator("main figure").filter({ hasText: "what is left of the energy of knocks" }).locator(".chart svg").first()).toBeVisible();
    await expect(page.getByRole("region", { name: "Modes that grow" })).toContainText("knocks suffice");
    const [onset] = at(belt.results, "squeal.margin.onsets") as { margin: number }[];
    const margins = page.getByRole("region", { name: /^How far before its onset/ });
    await expect(margins.getByRole("cell", { name: String(Number(onset?.margin.toPrecision(6))), exact: true })).toBeVisible();
  });
});

test.describe("a damper under a force that swings", () => {
  test.use({ subject: async ({ damper }, use) => use([damper.folder]) });

  test("shows its response, and gives its numbers", async ({ explorer }) => {
    const { page } = explorer;
    await explorer.open("/structures?analysis=response");
    await expect(page.locator("main figure .chart")).toHaveCount(3);
    await page.getByText("Export", { exact: true }).click();
    const file = await downloaded(page, () => page.getByRole("button", { name: "CSV" }).first().click());
    expect(readFileSync(file.path, "utf8").split("\n").length).toBeGreaterThan(100);
  });
});

test.describe("a case that is only looked at in its results", () => {
  test.use({ subject: [join(ROOT, "cases/benchmarks/belt.toml")] });

  test("says how to get them", async ({ explorer }) => {
    await explorer.open("/");
    const main = explorer.page.locator("main");
    await expect(main).toContainText("A case of model “belt” is looked at in the results of a run.");
    await expect(main).toContainText(/judder run \S*belt\.toml, then judder explore out\/belt\./);
  });
});
