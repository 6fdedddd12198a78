/** The structures page: what a study folder holds, for a sliding case and for a structure. */

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

test.describe("a case that is only looked at in its results", () => {
  test.use({ subject: [join(ROOT, "cases/benchmarks/belt.toml")] });

  test("says how to get them", async ({ explorer }) => {
    await explorer.open("/");
    const main = explorer.page.locator("main");
    await expect(main).toContainText("A case of model “belt” is looked at in the results of a run.");
    await expect(main).toContainText(/judder run \S*belt\.toml, then judder explore out\/belt\./);
  });
});
