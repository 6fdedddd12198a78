/** Choices of one of a few, and marks that are set or not. */

import type { JSX } from "preact";

/** What may be chosen: how it is called by program, its words, and what is said of it. */
export type Option<T extends string> = readonly [value: T, text: string, title?: string];

interface SelectProps<T extends string> {
  readonly value: T;
  readonly options: readonly Option<T>[];
  readonly onChange: (value: T) => void;
  /** One that cannot be chosen. */
  readonly taken?: string;
  readonly invalid?: boolean;
  /** Its name, where it has no visible one. */
  readonly spoken?: string;
}

export function Select<T extends string>({ value, options, onChange, taken, invalid, spoken }: SelectProps<T>) {
  return (
    <select value={value} {...(spoken ? { "aria-label": spoken } : {})} {...(invalid === undefined ? {} : { "aria-invalid": invalid })} onChange={(event) => onChange(event.currentTarget.value as T)}>
      {options.map(([option, text, title]) => (
        <option key={option} value={option} disabled={option === taken} {...(title ? { title } : {})}>
          {text}
        </option>
      ))}
    </select>
  );
}

interface SwitchProps {
  readonly name: JSX.Element | string;
  readonly on: boolean;
  readonly disabled?: boolean;
  readonly title?: string;
  readonly onChange: (on: boolean) => void;
}

export function Switch({ name, on, disabled = false, onChange, ...rest }: SwitchProps) {
  return (
    <label {...rest}>
      <input type="checkbox" checked={on} disabled={disabled} onChange={(event) => onChange(event.currentTarget.checked)} /> {name}
    </label>
  );
}
