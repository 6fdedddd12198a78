/** Turns each drawing of a report into an interactive figure when it comes near the screen. */

import { render } from "preact";
import "../chart/chart.css";
import "./report.css";
import { described } from "./described";
import { FigureView } from "./FigureView";

/** Whatever fails, the drawing stays. */
async function open(element: Element): Promise<void> {
  const [still, live, data] = [".still", ".live", "script"].map((part) => element.querySelector<HTMLElement>(part));
  if (!still || !live || !data) return;
  try {
    const figure = await described(data.textContent ?? "");
    live.hidden = false;
    render(<FigureView figure={figure} />, live);
    still.classList.add("replaced");
  } catch (error) {
    live.hidden = true;
    console.error(error);
  }
}

const near = new IntersectionObserver(
  (entries) => {
    for (const { isIntersecting, target } of entries) {
      if (!isIntersecting) continue;
      near.unobserve(target);
      void open(target);
    }
  },
  { rootMargin: "600px" },
);
for (const figure of document.querySelectorAll("[data-plot]")) near.observe(figure);
