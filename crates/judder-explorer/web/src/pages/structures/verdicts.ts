/** The verdicts that a study stores beside its eigenvalues: growth that is smaller than its error is neither. */

import { meanings } from "../../wire/frames";
import type { Arrays } from "./useArrays";

/** The verdict of every eigenvalue, in words; empty where none are stored. */
export function verdictsOf(arrays: Arrays): readonly string[] {
  const array = arrays.get("verdict");
  return array ? meanings(array) : [];
}

/** What is said of an eigenvalue: its verdict, or the sign of its growth rate. */
export function verdictOf(growth: number, stored: string | undefined): string {
  return stored || (growth > 0 ? "unstable" : "stable");
}
