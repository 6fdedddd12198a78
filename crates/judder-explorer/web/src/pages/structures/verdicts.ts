/** The verdicts that a study stores beside its eigenvalues: growth that is smaller than its error is neither. */

import type { Arrays } from "./useArrays";

/** The verdict of every eigenvalue, in words; empty where none are stored. */
export function verdictsOf(arrays: Arrays): readonly string[] {
  const array = arrays.get("verdict");
  if (!array) return [];
  const { flag_values: values, flag_meanings: meanings } = array.attributes;
  const words = typeof meanings === "string" ? meanings.split(" ").map((word) => word.replaceAll("_", " ")) : [];
  const codes = Array.isArray(values) ? values.map(Number) : words.map((_, code) => code);
  return Array.from(array.data, (code) => words[codes.indexOf(code)] ?? "");
}

/** What is said of an eigenvalue: its verdict, or the sign of its growth rate. */
export function verdictOf(growth: number, stored: string | undefined): string {
  return stored || (growth > 0 ? "unstable" : "stable");
}
