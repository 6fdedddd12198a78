/** What can be taken along: every picture as SVG, PNG and CSV, and the case file of the view. */

import { useEffect, useRef, useState } from "preact/hooks";
import { pngOf } from "../chart/export";
import { type Exportable, exportable, onExportable } from "../chart/exports";
import { options } from "../state/view";
import { fetchCaseFile } from "../wire/api";
import { type RequestError, asRequestError } from "../wire/request";
import { useApp } from "./app";
import { ErrorNote } from "./ErrorNote";
import { currentCaseFile, download, fileName } from "./files";

async function save({ title, now }: Exportable, kind: "svg" | "png" | "csv"): Promise<void> {
  const figure = now();
  const name = `${fileName(title)}.${kind}`;
  if (kind === "svg") download(name, await figure.svg(), "image/svg+xml");
  else if (kind === "png") download(name, await pngOf(figure), "image/png");
  else download(name, await figure.csv(), "text/csv;charset=utf-8");
}

export function ExportMenu() {
  const { session, store } = useApp();
  const [figures, setFigures] = useState(exportable());
  const [error, setError] = useState<RequestError | null>(null);
  const menu = useRef<HTMLDetailsElement>(null);
  useEffect(() => {
    setFigures(exportable());
    return onExportable(() => setFigures(exportable()));
  }, []);
  useClosing(menu);

  const attempt = (work: () => Promise<void>) => () => {
    setError(null);
    work().catch((failure) => setError(asRequestError(failure)));
  };
  const saveCase = async () => {
    const { name = session.case?.name ?? "case", text } = currentCaseFile() ?? { text: fetchCaseFile(options(store.view), null) };
    download(`${fileName(name)}.toml`, await text, "application/toml");
  };
  return (
    <details class="menu" ref={menu}>
      <summary>Export</summary>
      <div class="menu-body">
        {figures.map((figure) => (
          <div key={figure.title} role="group" aria-label={figure.title}>
            <span>{figure.title}</span>
            {(["svg", "png", "csv"] as const).map((kind) => (
              <button type="button" key={kind} onClick={attempt(() => save(figure, kind))} aria-label={`${kind.toUpperCase()} of ${figure.title}`}>
                {kind.toUpperCase()}
              </button>
            ))}
          </div>
        ))}
        {(session.case || session.study) && (
          <div role="group" aria-label="Case file">
            <span>The case of this view</span>
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
