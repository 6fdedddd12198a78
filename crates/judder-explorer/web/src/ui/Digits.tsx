/** A number with six of its digits; all of them on hovering, and for whoever reads the page by program. */

import { rounded } from "./readable";

interface DigitsProps {
  /** The path of the number in the document it comes from. */
  readonly dataKey: string;
  readonly value: number | null | undefined;
}

export function Digits({ dataKey, value }: DigitsProps) {
  const known = value !== null && value !== undefined;
  return (
    <span data-key={dataKey} data-value={known ? value : ""} title={known ? String(value) : undefined}>
      {known ? rounded(value) : "—"}
    </span>
  );
}
