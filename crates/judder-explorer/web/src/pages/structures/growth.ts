/** Why modes grow, as the study tells it. */

import type { StudyAnalysis } from "./study";

export interface Parent {
  readonly frequency: number;
  /** Of the kinetic energy. */
  readonly share: number;
}

export interface Growing {
  /** Where it stands in the list of the study. */
  readonly index: number;
  /** What each damping and each contact adds to the growth rate, 1/s. */
  readonly shares: readonly (readonly [name: string, growth: number])[];
  readonly parents: readonly Parent[];
}

/** What is told of a mode, by its number; null where the study tells nothing of it. */
export function growthOf({ scalars }: StudyAnalysis, mode: number): Growing | null {
  const all = scalars["growing"];
  if (!Array.isArray(all)) return null;
  const index = (all as readonly { mode?: unknown }[]).findIndex((one) => one.mode === mode);
  if (index < 0) return null;
  const { growth = {}, parents = [] } = all[index] as { growth?: Readonly<Record<string, number>>; parents?: readonly { frequency_hz: number; share: number }[] };
  return { index, shares: Object.entries(growth), parents: parents.map(({ frequency_hz: frequency, share }) => ({ frequency, share })) };
}
