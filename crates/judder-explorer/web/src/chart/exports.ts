/** The pictures of the view that is shown, for the export menu. */

import type { Size } from "./frame";

/** A picture as it is now, and its data. */
export interface Figure {
  readonly size: Size;
  readonly svg: () => Promise<string>;
  /** Fetched first where what is drawn is less than the data. */
  readonly csv: () => string | Promise<string>;
}

export interface Exportable {
  readonly title: string;
  readonly now: () => Figure;
}

const figures = new Set<Exportable>();
const listeners = new Set<() => void>();

function tell(): void {
  for (const listener of listeners) listener();
}

/** Adds a picture to the export menu; the result takes it out. */
export function registerExport(title: string, now: () => Figure): () => void {
  const entry = { title, now };
  figures.add(entry);
  tell();
  return () => {
    figures.delete(entry);
    tell();
  };
}

export function exportable(): readonly Exportable[] {
  return [...figures];
}

export function onExportable(listener: () => void): () => void {
  listeners.add(listener);
  return () => void listeners.delete(listener);
}
