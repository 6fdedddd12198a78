/** The keys in the fields of an address, against those of the case. */

import { parseAxis } from "./fields";
import { type Parsed, type View, withFields } from "./view";

interface Known {
  readonly keys: ReadonlySet<string>;
  /** The key of the x axis of an address without one. */
  readonly x: string | undefined;
}

/** Drops fields over keys that the case does not have. */
export function keepKnownAxes(view: View, known: Known): Parsed {
  if (view.page === "map") return keepMapAxes(view, known);
  if (view.page === "point") return keepPointKeys(view, known);
  return { view, told: [] };
}

/** The key of the eigenvalues' path, and that of the branch. */
function keepPointKeys(view: View, { keys }: Known): Parsed {
  const wanted = [
    { field: "along", key: view.fields["along"], use: "the path of the eigenvalues" },
    { field: "branch", key: parseAxis(view.fields["branch"])?.key, use: "the branch" },
  ];
  const unknown = wanted.filter(({ key }) => key !== undefined && !keys.has(key));
  return {
    view: withFields(view, Object.fromEntries(unknown.map(({ field }) => [field, undefined]))),
    told: unknown.map(({ key, use }) => `The case has no key “${key}” for ${use}.`),
  };
}

/** Drops a y axis over the key of the x axis, too. */
function keepMapAxes(view: View, { keys, x: home }: Known): Parsed {
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
