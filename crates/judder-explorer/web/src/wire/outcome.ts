/** The outcome of an analysis beside its arrays. */

import type { Frame } from "./frames";

export interface Check {
  readonly name: string;
  readonly compared: string;
  readonly figure: number;
  readonly limit: number;
  readonly passed: boolean;
  readonly numbers: number | null;
}

export interface Outcome {
  readonly scalars: Readonly<Record<string, unknown>>;
  readonly checks: readonly Check[];
  readonly warnings: readonly string[];
}

export function outcomeOf(frame: Frame): Outcome {
  const { scalars, checks, warnings } = frame.header;
  return {
    scalars: (scalars as Outcome["scalars"] | undefined) ?? {},
    checks: (checks as readonly Check[] | undefined) ?? [],
    warnings: (warnings as readonly string[] | undefined) ?? [],
  };
}

/** The entry at a path such as `force.coefficients.0`; names with points in them stand for themselves. */
export function entryAt(scalars: Outcome["scalars"], path: string): unknown {
  const steps = Object.hasOwn(scalars, path) ? [path] : path.split(".");
  return steps.reduce<unknown>((value, step) => (value as Record<string, unknown> | null | undefined)?.[step], scalars);
}

/** The number or word at a path. */
export function scalarAt(scalars: Outcome["scalars"], path: string): number | string | null {
  const value = entryAt(scalars, path);
  if (typeof value === "boolean") return String(value);
  return typeof value === "number" || typeof value === "string" ? value : null;
}

/** The number at a path; NaN where there is none. */
export function numberAt(scalars: Outcome["scalars"], path: string): number {
  const value = scalarAt(scalars, path);
  return typeof value === "number" ? value : Number.NaN;
}
