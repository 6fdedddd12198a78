/** The axes of a map in an address, against the keys of the case. */

import { parseAxis } from "./fields";
import { type Parsed, type View, withFields } from "./view";

interface Known {
  readonly keys: ReadonlySet<string>;
  /** The key of the x axis of an address without one. */
  readonly x: string | undefined;
}

/** Drops axes over keys that the case does not have, and a y axis over the key of the x axis. */
export function keepKnownAxes(view: View, { keys, x: home }: Known): Parsed {
  if (view.page !== "map") return { view, told: [] };
  const told: string[] = [];
  const dropped: Record<string, undefined> = {};
  const keyOf = (name: "x" | "y") => {
    const key = parseAxis(view.fields[name])?.key;
    if (key === undefined || keys.has(key)) return key;
    dropped[name] = undefined;
    told.push(`The case has no key “${key}” for its ${name} axis.`);
    return undefined;
  };
  const [x, y] = [keyOf("x") ?? home, keyOf("y")];
  if (y !== undefined && y === x) {
    dropped["y"] = undefined;
    told.push(`“${y}” cannot be on both axes: the y axis of the address is left out.`);
  }
  return { view: withFields(view, dropped), told };
}
