/** The charts of the view that is shown, for the export menu. */

import type { Size } from "./frame";
import type { Window } from "./scale";
import type { ChartSpec } from "./spec";

export interface Shown {
  readonly spec: ChartSpec;
  readonly window: Window;
  readonly size: Size;
}

/** A chart as it is now. */
export interface Exportable {
  readonly title: string;
  readonly shown: () => Shown;
}

const charts = new Set<Exportable>();
const listeners = new Set<() => void>();

function tell(): void {
  for (const listener of listeners) listener();
}

/** Adds a chart to the export menu; the result takes it out. */
export function registerExport(title: string, shown: () => Shown): () => void {
  const entry = { title, shown };
  charts.add(entry);
  tell();
  return () => {
    charts.delete(entry);
    tell();
  };
}

export function exportable(): readonly Exportable[] {
  return [...charts];
}

export function onExportable(listener: () => void): () => void {
  listeners.add(listener);
  return () => void listeners.delete(listener);
}
