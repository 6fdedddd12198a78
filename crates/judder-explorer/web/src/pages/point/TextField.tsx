/** A field of text that is taken when it is left, or with Enter. */

import { useEffect, useState } from "preact/hooks";

interface TextFieldProps {
  readonly name: string;
  readonly value: number | string;
  readonly title?: string;
  /** What may be entered; anything where left out. */
  readonly accepts?: (text: string) => boolean;
  readonly onChange: (text: string) => void;
}

export function TextField({ name, value, title, accepts = () => true, onChange }: TextFieldProps) {
  const [typed, setTyped] = useState<string | null>(null);
  useEffect(() => setTyped(null), [value]);
  const isWrong = typed !== null && (typed.trim() === "" || !accepts(typed));
  const enter = () => {
    if (typed !== null && !isWrong && typed !== String(value)) onChange(typed.trim());
    setTyped(null);
  };
  return (
    <label class="choice" {...(title ? { title } : {})}>
      {name}{" "}
      <input
        type="text"
        value={typed ?? String(value)}
        spellcheck={false}
        autocomplete="off"
        aria-invalid={isWrong}
        onInput={(event) => setTyped(event.currentTarget.value)}
        onBlur={enter}
        onKeyDown={(event) => {
          if (event.key === "Enter") enter();
          if (event.key === "Escape") setTyped(null);
        }}
      />
    </label>
  );
}

export const isPositive = (text: string) => Number(text) > 0;
export const isCount = (text: string) => Number.isInteger(Number(text)) && Number(text) > 1;
export const isNumber = (text: string) => Number.isFinite(Number(text));
