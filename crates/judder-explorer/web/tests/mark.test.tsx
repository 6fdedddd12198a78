// @vitest-environment happy-dom
import { render } from "preact";
import { act } from "preact/test-utils";
import { describe, expect, it } from "vitest";
import { Chart } from "../src/chart/Chart";
import type { ChartSpec } from "../src/chart/spec";

const spec: ChartSpec = {
  title: "A line",
  x: { label: "x", scale: "linear" },
  y: { label: "y", scale: "linear" },
  layers: [{ kind: "line", label: "", x: [0, 10], y: [0, 1], role: { series: 0 } }],
};

async function markAt(mark: number | null): Promise<number | undefined> {
  const host = document.createElement("div");
  await act(() => render(<Chart spec={spec} mark={mark} height={200} />, host));
  const path = host.querySelector(".chart-mark")?.getAttribute("d");
  return path ? Number(/^M([\d.]+) /.exec(path)?.[1]) : undefined;
}

describe("the mark of a chart", () => {
  it("stands at its value of x", async () => {
    const [first, middle, last] = [await markAt(0), await markAt(5), await markAt(10)];
    expect(middle).toBeCloseTo(((first as number) + (last as number)) / 2, 6);
    expect(last).toBeGreaterThan(first as number);
  });

  it("is left out beyond the plot, and where there is none", async () => {
    expect(await markAt(11)).toBeUndefined();
    expect(await markAt(null)).toBeUndefined();
  });
});
