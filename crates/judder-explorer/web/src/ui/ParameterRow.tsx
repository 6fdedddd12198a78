/** One key of the case: slider, text with a unit, the other form of its value, reset. */

import { useMemo, useRef, useState } from "preact/hooks";
import type { Keep } from "../state/store";
import { withOption } from "../state/view";
import type { CaseValue, Key } from "../wire/api";
import type { RequestError } from "../wire/request";
import { useApp } from "./app";
import { ErrorNote } from "./ErrorNote";
import { Label } from "./Label";
import { asWritten, readable, withUnit } from "./readable";
import { Slider } from "./Slider";
import { TextField } from "./TextField";
import { SLIDER_STEPS, isPure, keyName, numberIn, otherForm, plainText, plainValue, significant, sliderPlace, sliderRange, sliderValue, symbolMarkup, valueText } from "./numbers";

interface RowProps {
  readonly parameter: Key;
  readonly value: CaseValue | undefined;
  readonly base: CaseValue | undefined;
  readonly error: RequestError | null;
  /** What the view sets the key to. */
  readonly set: string | undefined;
}

/** A drag moves one row: the others are left as they are. */
export function ParameterRow(row: RowProps) {
  return useMemo(() => <Row {...row} />, [row.parameter, row.value, row.base, row.error, row.set]);
}

function Row({ parameter, value, base, error, set }: RowProps) {
  const { store } = useApp();
  const { path } = parameter;
  const id = `key-${path.replace(/[^\w]/g, "-")}`;
  const name = keyName(parameter);
  const differs = set !== undefined && (value === undefined || base === undefined || plainValue(parameter, value) !== plainValue(parameter, base));
  const text = set ?? (value ? shortText(parameter, value) : "");
  const change = (next: string | undefined, keep: Keep) => store.update((view) => withOption(view, path, next), keep);
  return (
    <div class={`parameter${error ? " parameter-refused" : differs ? " parameter-differs" : ""}`} role="group" aria-labelledby={id} data-parameter={path}>
      <div class="parameter-head">
        <span class="parameter-name" id={id} title={parameter.doc}>
          {name} <Label text={symbolMarkup(parameter.symbol)} />
          {differs && <span class="parameter-mark" title="differs from the case">{"\u25CF"}<span class="visually-hidden"> differs from the case</span></span>}
        </span>
        <button type="button" class="parameter-reset" disabled={set === undefined} onClick={() => change(undefined, "push")} aria-label={`Reset ${name} to the case's value`} title="Back to the case's value">
          Reset
        </button>
      </div>
      {value && <KeySlider parameter={parameter} now={numberIn(parameter, text) ?? plainValue(parameter, value)} name={name} onChange={change} />}
      <div class="parameter-values">
        <TextField id={`${id}-text`} class="parameter-text" spoken={`${name}, a number or a text with a unit`} value={text} invalid={error !== null} onChange={(next) => change(next === "" ? undefined : next, "push")} />
        <output class="parameter-other" data-parameter-other={path}>
          <Label text={value ? otherForm(parameter, value) : ""} />
        </output>
      </div>
      {error && <ErrorNote error={error} />}
    </div>
  );
}

/** The case's own value in a unit of its own size, short enough for its field. */
function shortText(parameter: Key, value: CaseValue): string {
  const text = asWritten(valueText(parameter, value));
  if (text.length <= 14) return text;
  return value.form === "si" && value.si !== null && !isPure(parameter) ? withUnit(readable(value.si, parameter.unit)) : String(significant(value.number, 6));
}

interface KeySliderProps {
  readonly parameter: Key;
  /** The value that the view asks for: keys may be pressed again before the server has answered. */
  readonly now: number;
  readonly name: string;
  readonly onChange: (text: string, keep: Keep) => void;
}

function KeySlider({ parameter, now, name, onChange }: KeySliderProps) {
  // while a drag lasts the thumb stays under the pointer, whatever answers come meanwhile
  const [held, setHeld] = useState<number | null>(null);
  const range = useRef(sliderRange(parameter, now));
  if (held === null) range.current = sliderRange(parameter, now);
  const valueAt = (place: number) => sliderValue(parameter, range.current, place);
  return (
    <Slider
      from={0}
      to={SLIDER_STEPS}
      step={1}
      value={held ?? sliderPlace(parameter, now)}
      spoken={name}
      spokenValue={`${significant(held === null ? now : valueAt(held))}`}
      onMove={(place, keep) => {
        setHeld(keep === "drag" ? place : null);
        onChange(plainText(parameter, valueAt(place)), keep);
      }}
    />
  );
}
