/** Every page in both themes and two sizes: no violation that axe knows, and every control within reach of the keyboard. */

import AxeBuilder from "@axe-core/playwright";
import { type Explorer, expect, studies, test } from "./explorer";

const PAGES = ["/map?cursor=1e-3,0.1&show=full,conservative,decoupled", "/point", "/contact", "/contact?part=law", "/contact?part=solution"];
const [WIDE, NARROW] = [{ width: 1440, height: 900 }, { width: 900, height: 700 }] as const;
// what is readable depends on the colours, what sticks out on the size: each once, and the other pairs where more time is taken
const SCREENS = [
  { tag: [], pairs: [["light", WIDE], ["dark", NARROW]] },
  { tag: ["@expensive"], pairs: [["light", NARROW], ["dark", WIDE]] },
] as const;
type Pairs = (typeof SCREENS)[number]["pairs"];

/** The pairs in words. */
function named(pairs: Pairs): string {
  return pairs.map(([theme, size]) => `, ${theme} ${size.width}`).join("");
}

/** Nothing that axe knows, and nothing that sticks out, with these pairs of theme and size. */
async function isForEverybody(explorer: Explorer, view: string, pairs: Pairs): Promise<void> {
  const { page } = explorer;
  for (const [colorScheme, size] of pairs) {
    await page.emulateMedia({ colorScheme });
    await page.setViewportSize(size);
    await explorer.open(view);
    await expect(page.locator("[aria-busy=true]")).toHaveCount(0);
    await expect(page.getByText(/^(Reading|Computing) .*…/)).toHaveCount(0);
    const { violations } = await new AxeBuilder({ page }).analyze();
    const found = violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html).join(" ").slice(0, 400)}`);
    expect(found, `${colorScheme}, ${size.width} × ${size.height}`).toEqual([]);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
    expect(wide, "nothing sticks out to the side").toBeLessThanOrEqual(0);
  }
}

for (const { tag, pairs } of SCREENS) {
  for (const view of PAGES) test(`${view} is for everybody${named(pairs)}`, { tag: [...tag] }, async ({ explorer }) => isForEverybody(explorer, view, pairs));
}

const STUDIES = { sliding: ["locus", "film"], edge: ["spectrogram"], block: ["modes"], disc: ["steady", "modes"], brake: ["cycle", "damping"], damper: ["response"], belt: ["squeal"] } as const;

for (const name of ["sliding", "edge", "block", "disc", "brake", "damper", "belt"] as const) {
  studies.describe(name, () => {
    studies.use({
      subject: async ({ sliding, edge, block, disc, brake, damper, belt }, use) => use([{ sliding, edge, block, disc, brake, damper, belt }[name].folder]),
    });
    for (const { tag, pairs } of SCREENS) {
      for (const analysis of STUDIES[name]) {
        studies(`/structures?analysis=${analysis} is for everybody${named(pairs)}`, { tag: [...tag] }, async ({ explorer }) => {
          await isForEverybody(explorer, `/structures?analysis=${analysis}`, pairs);
          await expect(explorer.page.locator(".analysis-list a[aria-current]")).toContainText(analysis);
        });
      }
    }
  });
}

test("the keyboard reaches what the pointer reaches", async ({ explorer }) => {
  const { page } = explorer;
  await explorer.open("/map");
  await expect(page.locator(".map-chart")).toHaveAttribute("data-stage", "exact");
  const reached = new Set<string>();
  for (let step = 0; step < 120; step += 1) {
    await page.keyboard.press("Tab");
    const name = await page.evaluate(() => {
      const at = document.activeElement;
      if (!at || at === document.body) return null;
      const { outlineStyle, outlineWidth, boxShadow } = getComputedStyle(at);
      const seen = (outlineStyle !== "none" && outlineWidth !== "0px") || boxShadow !== "none";
      const label = (at as HTMLInputElement).labels?.[0]?.textContent;
      return `${at.getAttribute("aria-label") ?? label ?? at.textContent?.trim() ?? ""}${seen ? "" : " (unseen)"}`;
    });
    if (name === null) break;
    reached.add(name);
  }
  const all = [...reached];
  expect(all.filter((name) => name.includes("(unseen)"))).toEqual([]);
  for (const control of ["Skip to the content", "damping x", "Point", "Contact", "Export", "Reset"]) {
    expect(all.some((name) => name.startsWith(control)), `${control} in ${all.join(" | ")}`).toBe(true);
  }
  await page.locator(".map-chart [tabindex='0']").first().focus();
  for (let step = 0; step < 4; step += 1) await page.keyboard.press("ArrowRight");
  await expect(page).toHaveURL(/cursor=/);
  await page.keyboard.press("Enter");
  await expect(page).toHaveURL(/pin=/);
  await page.keyboard.press("+");
  await expect(page).toHaveURL(/x=operation/);
});
