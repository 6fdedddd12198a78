/** The chart of a map. */

import { classOf } from "../../chart/palette";
import type { Window } from "../../chart/scale";
import { BOUNDARIES } from "../../state/fields";
import type { Axis, ChartSpec, Layer } from "../../chart/spec";
import { keyName, signOf } from "../../ui/numbers";
import type { Key, KeyAxis } from "../../wire/api";
import { type BoundaryName, MARGINAL, type MapPicture, drawnClasses, shares } from "./picture";
import { type MapState, isDimensional } from "./state";
import type { Critical } from "./useCritical";

const NAMES: Record<BoundaryName, string> = {
  full: "boundary, full system",
  conservative: "boundary without damping",
  decoupled: "boundary for $η = 0$",
};

/** The header of a column of a key's values. */
export function keyHeading(axis: KeyAxis, key: Key): string {
  return `${key.path} (${isDimensional(axis) || key.group === null ? key.unit : key.group})`;
}

/** What stands at an axis of a key. */
export function keyAxisLabel(key: Key, axis: KeyAxis): string {
  const name = keyName(key);
  return `${name.charAt(0).toUpperCase()}${name.slice(1)}  ${signOf(key, isDimensional(axis))}`;
}

function axisOf(axis: KeyAxis, key: Key, range: Window["x"] | undefined): Axis {
  return { label: keyAxisLabel(key, axis), name: keyHeading(axis, key), scale: axis.scale, ...(range ? { range } : {}) };
}

function shareText(share: number): string {
  return share > 0 && share < 0.0005 ? "< 0.1 %" : `${(100 * share).toFixed(1)} %`;
}

interface Parts {
  readonly state: MapState;
  readonly x: Key;
  readonly y: Key;
  readonly window: Window | null;
  readonly picture: MapPicture | null;
  readonly critical: Critical | null;
}

export function mapSpec({ state, x, y, window, picture, critical }: Parts): ChartSpec {
  const layers: Layer[] = [];
  if (picture) {
    const areas = [...picture.words, MARGINAL].map(classOf);
    const drawn = drawnClasses(picture, picture.words.length);
    const share = shares(drawn, areas.length);
    const classes = areas.map((area, code) => ({ ...area, legend: `${area.name} ${shareText(share[code] ?? 0)}` }));
    layers.push({
      kind: "classes",
      label: "mechanism",
      x: picture.x,
      y: picture.y,
      codes: drawn,
      classes,
      hatched: state.marks.includes("hatch"),
      letters: state.marks.includes("letters"),
    });
    for (const name of BOUNDARIES) {
      const curve = picture.boundaries[name];
      if (curve && state.show.includes(name)) layers.push({ kind: "line", label: NAMES[name], ...curve, role: `${name}-boundary` });
    }
  }
  if (critical) {
    const common = { kind: "points", size: 6 } as const;
    layers.push({ ...common, label: `critical ${keyName(y)}`, ...critical.full, role: { series: 1 } });
    layers.push({ ...common, label: `critical ${keyName(y)} without damping`, ...critical.conservative, role: { series: 0 }, hollow: true });
  }
  return {
    title: `Stability over ${keyName(x)} and ${keyName(y)}`,
    x: axisOf(state.x, x, window?.x),
    y: axisOf(state.y, y, window?.y),
    layers,
  };
}
