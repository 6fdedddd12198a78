/** What can be taken along: every chart as SVG, PNG and CSV, and the case file of the view. */

import { useEffect, useRef, useState } from "preact/hooks";
import { chartCsv } from "../chart/csv";
import { chartPng, chartSvg } from "../chart/export";
import { type Exportable, exportable, onExportable } from "../chart/exports";
import { options } from "../state/view";
import { fetchCaseFile } from "../wire/api";
import { type RequestError, asRequestError } from "../wire/request";
import { useApp } from "./app";
import { ErrorNote } from "./ErrorNote";
import { currentCaseFile, download, fileName } from "./files";

async function save(chart: Exportable, kind: "svg" | "png" | "csv"): Promise<void> {
  const { spec, window, size } = chart.shown();
  const name = `${fileName(chart.title)}.${kind}`;
  if (kind === "svg") download(name, await chartSvg(spec, window, size), "image/svg+xml");
  else if (kind === "png") download(name, await chartPng(spec, window, size), "image/png");
  else download(name, chartCsv(spec), "text/csv;charset=utf-8");
}

export function ExportMenu() {
  const { session, store } = useApp();
  const [charts, setCharts] = useState(exportable());
  const [error, setError] = useState<RequestError | null>(null);
  const menu = useRef<HTMLDetailsElement>(null);
  useEffect(() => {
    setCharts(exportable());
    return onExportable(() => setCharts(exportable()));
  }, []);
  useClosing(menu);

  const attempt = (work: () => Promise<void>) => () => {
    setError(null);
    work().catch((failure) => setError(asRequestError(failure)));
  };
  const saveCase = async () => {
    const file = currentCaseFile() ?? { set: options(store.view), analysis: null };
    const text = await fetchCaseFile(file.set, file.analysis, file.model);
    download(`${fileName(session.case?.name ?? "case")}.toml`, text, "application/toml");
  };
  return (
    <details class="menu" ref={menu}>
      <summary>Export</summary>
      <div class="menu-body">
        {charts.map((chart) => (
          <div key={chart.title} role="group" aria-label={chart.title}>
            <span>{chart.title}</span>
            {(["svg", "png", "csv"] as const).map((kind) => (
              <button type="button" key={kind} onClick={attempt(() => save(chart, kind))} aria-label={`${kind.toUpperCase()} of ${chart.title}`}>
                {kind.toUpperCase()}
              </button>
            ))}
          </div>
        ))}
        {session.case && (
          <div role="group" aria-label="Case file">
            <span>This view, for judder run</span>
            <button type="button" onClick={attempt(saveCase)}>
              Case file
            </button>
          </div>
        )}
        <ErrorNote error={error} />
      </div>
    </details>
  );
}

/** Escape and a click elsewhere close a menu. */
function useClosing(menu: { current: HTMLDetailsElement | null }): void {
  useEffect(() => {
    const onKey = (event: KeyboardEvent) => {
      if (event.key !== "Escape" || !menu.current?.open) return;
      menu.current.open = false;
      menu.current.querySelector("summary")?.focus();
    };
    const onPress = (event: Event) => {
      if (menu.current?.open && !menu.current.contains(event.target as Node)) menu.current.open = false;
    };
    document.addEventListener("keydown", onKey);
    document.addEventListener("pointerdown", onPress);
    return () => {
      document.removeEventListener("keydown", onKey);
      document.removeEventListener("pointerdown", onPress);
    };
  }, []);
}
