/** The key, range and scale of one axis of the map. */

import { numberOrText } from "../../state/fields";
import { blames } from "../../ui/meant";
import { symbolText } from "../../ui/numbers";
import { asWritten } from "../../ui/readable";
import { TextField, isFilled } from "../../ui/TextField";
import type { Key, KeyAxis, ScaleName } from "../../wire/api";
import type { RequestError } from "../../wire/request";
import { keyName } from "./spec";

interface AxisPickerProps {
  readonly name: "x" | "y";
  readonly axis: KeyAxis;
  readonly keys: readonly Key[];
  /** The key of the other axis, which cannot be taken. */
  readonly taken: string;
  readonly onKey: (key: Key) => void;
  readonly onAxis: (axis: KeyAxis) => void;
  /** Why there is no newer picture: an end that it speaks of is marked. */
  readonly error?: RequestError | null;
}

export function AxisPicker({ name, axis, keys, taken, onKey, onAxis, error = null }: AxisPickerProps) {
  const pick = (event: Event) => {
    const key = keys.find((key) => key.path === (event.currentTarget as HTMLSelectElement).value);
    if (key) onKey(key);
  };
  const scale = (event: Event) => {
    onAxis({ ...axis, scale: (event.currentTarget as HTMLSelectElement).value as ScaleName });
  };
  return (
    <fieldset class="axis-picker">
      <legend class="visually-hidden">{name} axis</legend>
      <b aria-hidden="true">{name}</b>
      <select aria-label={`Key of the ${name} axis`} value={axis.key} onChange={pick}>
        {keys.map((key) => (
          <option key={key.path} value={key.path} disabled={key.path === taken}>
            {`${keyName(key)} ${symbolText(key.symbol)}`.trim()}
          </option>
        ))}
      </select>
      <span class="axis-ends">
        <End label={`From, ${name} axis`} value={axis.from} invalid={blames(error, `${name}.from`)} onChange={(from) => onAxis({ ...axis, from })} />
        <span aria-hidden="true">…</span>
        <End label={`To, ${name} axis`} value={axis.to} invalid={blames(error, `${name}.to`)} onChange={(to) => onAxis({ ...axis, to })} />
      </span>
      <select aria-label={`Scale of the ${name} axis`} value={axis.scale} onChange={scale}>
        <option value="log">log</option>
        <option value="linear">linear</option>
      </select>
    </fieldset>
  );
}

interface EndProps {
  readonly label: string;
  readonly value: number | string;
  /** Whether it is refused. */
  readonly invalid: boolean;
  readonly onChange: (value: number | string) => void;
}

/** The address separates the parts of an axis by tildes. */
const fitsAddress = (text: string) => isFilled(text) && !text.includes("~");

function End({ label, value, invalid, onChange }: EndProps) {
  return <TextField class="axis-end" spoken={label} value={asWritten(String(value))} invalid={invalid} accepts={fitsAddress} onChange={(text) => onChange(numberOrText(text))} />;
}
