/** Values of keys. */

import type { CaseValue, CaseValues, Key, KeyAxis } from "../../wire/api";
import { numberOnAxis } from "../map/state";

/** The value of a key, where it is known. */
export function valueOf(key: Key, values: CaseValues | null): CaseValue | undefined {
  return values?.values.find((value) => value.path === key.path);
}

/** The value that a key has, in the form of an axis over it. */
export function valueOnAxisOf(key: Key, axis: KeyAxis, values: CaseValues | null): number | null {
  const value = valueOf(key, values);
  return value ? numberOnAxis(axis, key, value) : null;
}
