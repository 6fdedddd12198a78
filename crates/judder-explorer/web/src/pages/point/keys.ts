/** Keys as axes of the charts of this page. */

import { signOf } from "../../ui/numbers";
import type { CaseValue, CaseValues, Key, KeyAxis } from "../../wire/api";
import { isDimensional, numberOnAxis } from "../map/state";
import { keyName } from "../map/spec";

export function keyAxisLabel(key: Key, axis: KeyAxis): string {
  const name = keyName(key);
  return `${name.charAt(0).toUpperCase()}${name.slice(1)}  ${signOf(key, isDimensional(axis))}`;
}

/** The value of a key, where it is known. */
export function valueOf(key: Key, values: CaseValues | null): CaseValue | undefined {
  return values?.values.find((value) => value.path === key.path);
}

/** The value that a key has, in the form of an axis over it. */
export function valueOnAxisOf(key: Key, axis: KeyAxis, values: CaseValues | null): number | null {
  const value = valueOf(key, values);
  return value ? numberOnAxis(axis, key, value) : null;
}
