/** Words of the structures page. */

import { brief } from "../../chart/readout";
import type { Range } from "../../chart/scale";
import { power, readable } from "../../ui/readable";

/** A path as a shell takes it. */
export function quoted(path: string): string {
  return /^[\w./\\:-]+$/.test(path) ? path : `'${path.replaceAll("'", "'\\''")}'`;
}

/** Three digits of values of a range, all in one unit in which its larger end is easily read; the unit is empty where there is none. */
export function sized(unit: string, [low, high]: Range): { readonly unit: string; readonly text: (value: number) => string } {
  const own = readable(Math.max(Math.abs(low), Math.abs(high)), unit).unit;
  const scale = power(own, unit);
  return { unit: own === "1" ? "" : own, text: (value) => brief(value / scale, 3) };
}
