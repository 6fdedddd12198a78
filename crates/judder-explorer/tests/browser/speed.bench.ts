/** How fast the page is: its start, the map after a slider has moved, the frames of a drag. Prints; nothing here passes or fails by time. */

import { type Explorer, expect, test } from "./explorer";

declare global {
  interface Window {
    /** The maps that were put on their canvas: when, of which stage, and of which options. */
    painted: { readonly time: number; readonly stage: string; readonly set: string }[];
  }
}

const median = (values: readonly number[]) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)] ?? Number.NaN;
const say = (what: string, values: readonly number[], unit: string) => {
  const range = `${Math.min(...values).toFixed(1)} to ${Math.max(...values).toFixed(1)}`;
  console.log(`${what.padEnd(62)} median ${median(values).toFixed(1)} ${unit} (${range}, ${values.length} times)`);
};

async function watched(explorer: Explorer): Promise<void> {
  await explorer.page.addInitScript(() => {
    window.painted = [];
    const put = CanvasRenderingContext2D.prototype.putImageData;
    CanvasRenderingContext2D.prototype.putImageData = function (this: CanvasRenderingContext2D, ...what: unknown[]) {
      const { stage = "", set = "" } = this.canvas.closest<HTMLElement>(".map-chart")?.dataset ?? {};
      window.painted.push({ time: performance.now(), stage, set });
      return (put as (...what: unknown[]) => void).apply(this, what);
    } as typeof put;
  });
}

test("start", async ({ explorer }) => {
  await watched(explorer);
  const [load, picture]: [number[], number[]] = [[], []];
  for (let turn = 0; turn < 7; turn += 1) {
    await explorer.page.goto(`${explorer.origin}/map`);
    await expect(explorer.page.locator(".map-chart")).toHaveAttribute("data-stage", "exact");
    const [loaded, first] = await explorer.page.evaluate(() => {
      const entry = performance.getEntriesByType("navigation")[0] as PerformanceNavigationTiming;
      return [entry.loadEventEnd, window.painted[0]?.time ?? Number.NaN] as const;
    });
    load.push(loaded);
    picture.push(first);
  }
  say("the page is loaded", load, "ms");
  say("the first picture of its map (400 × 400) is on the canvas", picture, "ms");
});

test("a slider moves", async ({ explorer }) => {
  await watched(explorer);
  await explorer.open("/map");
  await expect(explorer.page.locator(".map-chart")).toHaveAttribute("data-stage", "exact");
  const [coarse, exact]: [number[], number[]] = [[], []];
  for (let turn = 0; turn < 25; turn += 1) {
    await explorer.page.waitForTimeout(700);
    const times = await explorer.page.evaluate(async (place) => {
      const slider = document.querySelector<HTMLInputElement>("input[type=range][aria-label='damping x']");
      if (!slider) throw new Error("no slider");
      window.painted = [];
      const start = performance.now();
      slider.value = String(place);
      slider.dispatchEvent(new InputEvent("input", { bubbles: true }));
      slider.dispatchEvent(new Event("change", { bubbles: true }));
      while (window.painted.length < 2 && performance.now() - start < 3000) await new Promise(requestAnimationFrame);
      return window.painted.map(({ time }) => time - start);
    }, 100 + 7 * turn);
    coarse.push(times[0] ?? Number.NaN);
    exact.push(times[1] ?? Number.NaN);
  }
  say("a slider moves: the first picture of a 400 × 400 map", coarse, "ms");
  say("a slider moves: the exact map", exact, "ms");
});

test("a slider is dragged", async ({ explorer }) => {
  await watched(explorer);
  await explorer.open("/map");
  await expect(explorer.page.locator(".map-chart")).toHaveAttribute("data-stage", "exact");
  const [coarse, exact]: [number[], number[]] = [[], []];
  for (const name of ["damping x", "coupling", "radius"]) {
    const drawn = await explorer.page.evaluate(async (name) => {
      const slider = document.querySelector<HTMLInputElement>(`input[type=range][aria-label='${name}']`);
      if (!slider) throw new Error("no slider");
      window.painted = [];
      const start = performance.now();
      for (let step = 0; performance.now() - start < 3000; step += 1) {
        slider.value = String(Math.round(Number(slider.max) * (0.5 + 0.4 * Math.sin(step / 30))));
        slider.dispatchEvent(new InputEvent("input", { bubbles: true }));
        await new Promise(requestAnimationFrame);
      }
      const seconds = (performance.now() - start) / 1000;
      const pictures = window.painted.map(({ stage, set }) => ({ stage, set }));
      slider.dispatchEvent(new Event("change", { bubbles: true }));
      return { seconds, pictures };
    }, name);
    // a picture of the value that is shown already is no new one
    const rate = (stage: string) => {
      const sets = drawn.pictures.filter((picture) => picture.stage === stage).map(({ set }) => set);
      return sets.filter((set, index) => set !== sets[index - 1]).length / drawn.seconds;
    };
    coarse.push(rate("coarse"));
    exact.push(rate("exact"));
    await explorer.page.waitForTimeout(1000);
  }
  say("a slider is dragged: coarse maps of different values", coarse, "a second");
  say("a slider is dragged: exact maps of different values", exact, "a second");
});
