/** What the map shows on top of the mechanisms, and how it is read without colour. */

import { Switch } from "../../ui/choices";
import type { MapState, Mark, Overlay } from "./state";

interface MapSwitchesProps {
  readonly state: MapState;
  /** Whether the y key has critical curves. */
  readonly hasCritical: boolean;
  readonly onShow: (show: readonly Overlay[]) => void;
  readonly onMarks: (marks: readonly Mark[]) => void;
}

const OVERLAY_NAMES: readonly (readonly [Overlay, string])[] = [
  ["full", "full (solid)"],
  ["conservative", "without damping (dashed)"],
  ["decoupled", "η = 0 (red)"],
  ["critical", "critical curves"],
];
const MARK_NAMES: readonly (readonly [Mark, string])[] = [
  ["hatch", "hatching"],
  ["letters", "letters"],
];

export function MapSwitches({ state, hasCritical, onShow, onMarks }: MapSwitchesProps) {
  return (
    <>
      <fieldset class="switches">
        <legend>Boundaries</legend>
        {OVERLAY_NAMES.map(([overlay, name]) => (
          <Switch
            key={overlay}
            name={name}
            on={state.show.includes(overlay)}
            disabled={overlay === "critical" && !hasCritical}
            {...(overlay === "critical" && !hasCritical ? { title: "for shear strength or normal load on the y axis" } : {})}
            onChange={(on) => onShow(toggled(state.show, overlay, on))}
          />
        ))}
      </fieldset>
      <fieldset class="switches">
        <legend>Without colour</legend>
        {MARK_NAMES.map(([mark, name]) => (
          <Switch key={mark} name={name} on={state.marks.includes(mark)} onChange={(on) => onMarks(toggled(state.marks, mark, on))} />
        ))}
      </fieldset>
    </>
  );
}

function toggled<T>(list: readonly T[], item: T, on: boolean): readonly T[] {
  return on ? [...list, item] : list.filter((other) => other !== item);
}
