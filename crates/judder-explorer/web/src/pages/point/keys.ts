/** Keys as axes of the charts of this page. */

import { signOf } from "../../ui/numbers";
import type { CaseValues, Key, KeyAxis } from "../../wire/api";
import { isDimensional } from "../map/state";
import { keyName } from "../map/spec";

export function keyAxisLabel(key: Key, axis: KeyAxis): string {
  const name = keyName(key);
  return `${name.charAt(0).toUpperCase()}${name.slice(1)}  ${signOf(key, isDimensional(axis))}`;
}

/** The value that a key has, in the form of an axis over it. */
export function valueOnAxisOf(key: Key, axis: KeyAxis, values: CaseValues | null): number | null {
  const value = values?.values.find((value) => value.path === key.path);
  if (!value) return null;
  return (isDimensional(axis) ? value.si : value.group) ?? value.number;
}
