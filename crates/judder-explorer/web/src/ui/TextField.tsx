/** A field of text that is taken when it is left, or with Enter; Escape gives it back. */

import { useEffect, useState } from "preact/hooks";

interface TextFieldProps {
  /** Its visible name; where it has none, `spoken` names it. */
  readonly name?: string;
  readonly spoken?: string;
  readonly id?: string;
  readonly class?: string;
  readonly title?: string;
  readonly value: number | string;
  /** Whether what it holds is refused. */
  readonly invalid?: boolean;
  /** What may be entered; anything where left out. */
  readonly accepts?: (text: string) => boolean;
  readonly onChange: (text: string) => void;
}

export function TextField({ name, spoken, title, value, invalid = false, accepts = () => true, onChange, ...rest }: TextFieldProps) {
  const [typed, setTyped] = useState<string | null>(null);
  useEffect(() => setTyped(null), [value]);
  const isWrong = typed !== null && !accepts(typed);
  const enter = () => {
    if (typed !== null && !isWrong && typed.trim() !== String(value)) onChange(typed.trim());
    setTyped(null);
  };
  const field = (
    <input
      {...rest}
      type="text"
      value={typed ?? String(value)}
      spellcheck={false}
      autocomplete="off"
      {...(spoken ? { "aria-label": spoken } : {})}
      aria-invalid={invalid || isWrong}
      onInput={(event) => setTyped(event.currentTarget.value)}
      onBlur={enter}
      onKeyDown={(event) => {
        if (event.key === "Enter") enter();
        if (event.key === "Escape") setTyped(null);
      }}
    />
  );
  if (name === undefined) return field;
  return (
    <label class="choice" {...(title ? { title } : {})}>
      {name} {field}
    </label>
  );
}

export const isFilled = (text: string) => text.trim() !== "";
const isNumber = (text: string) => isFilled(text) && Number.isFinite(Number(text));
export const isPositive = (text: string) => isNumber(text) && Number(text) > 0;
