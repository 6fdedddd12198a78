/** The key, range and scale of one axis of the map. */

import { numberOrText } from "../../state/fields";
import { Select } from "../../ui/choices";
import { blames } from "../../ui/meant";
import { keyHead } from "../../ui/numbers";
import { asWritten } from "../../ui/readable";
import { TextField, isFilled } from "../../ui/TextField";
import type { Key, KeyAxis, ScaleName } from "../../wire/api";
import type { RequestError } from "../../wire/request";

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
  const pick = (path: string) => {
    const key = keys.find((key) => key.path === path);
    if (key) onKey(key);
  };
  return (
    <fieldset class="axis-picker">
      <legend class="visually-hidden">{name} axis</legend>
      <b aria-hidden="true">{name}</b>
      <Select spoken={`Key of the ${name} axis`} value={axis.key} options={keys.map((key) => [key.path, keyHead(key)])} taken={taken} onChange={pick} />
      <span class="axis-ends">
        <End label={`From, ${name} axis`} value={axis.from} invalid={blames(error, `${name}.from`)} onChange={(from) => onAxis({ ...axis, from })} />
        <span aria-hidden="true">…</span>
        <End label={`To, ${name} axis`} value={axis.to} invalid={blames(error, `${name}.to`)} onChange={(to) => onAxis({ ...axis, to })} />
      </span>
      <Select<ScaleName> spoken={`Scale of the ${name} axis`} value={axis.scale} options={[["log", "log"], ["linear", "linear"]]} onChange={(scale) => onAxis({ ...axis, scale })} />
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
