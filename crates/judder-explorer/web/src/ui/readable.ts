/** Numbers as people read them: six digits, and a unit of their own size. */

import { written } from "../chart/readout";

/** Digits that are shown. */
const DIGITS = 6;

/** Prefixes by their power of ten, in steps of three. */
const PREFIXES: Readonly<Record<number, string>> = {
  [-12]: "p", [-9]: "n", [-6]: "µ", [-3]: "m", 0: "", 3: "k", 6: "M", 9: "G",
};
/** Units that take prefixes; a square takes the square of one. */
const PREFIXED: Readonly<Record<string, number>> = { m: 1, "m/s": 1, N: 1, Pa: 1, s: 1, Hz: 1, W: 1, J: 1, "m²": 2 };

export interface Readable {
  readonly text: string;
  readonly unit: string;
}

/** The number with six digits, in a unit in which it stands between 1 and 1000 where there is one. */
export function readable(value: number, unit = "1"): Readable {
  const power = PREFIXED[unit];
  if (power === undefined || value === 0 || !Number.isFinite(value)) return { text: rounded(value), unit };
  // the squares of prefixes are six powers of ten apart
  const step = Math.floor(Math.log10(Math.abs(value)) / (3 * power)) * 3;
  const exponent = Math.min(9, Math.max(-12, step));
  return { text: rounded(value / 10 ** (exponent * power)), unit: `${PREFIXES[exponent] ?? ""}${unit}` };
}

export function withUnit({ text, unit }: Readable): string {
  return `${text} ${unit}`;
}

/** The number with its unit in a unit of its own size, where that says it exactly; undefined where it does not. */
function exactly(value: number, unit: string): string | undefined {
  const scaled = readable(value, unit);
  return Number(scaled.text) * power(scaled.unit, unit) === value ? withUnit(scaled) : undefined;
}

/** A quantity as a person writes it: `1e-6 m/s` as 1 µm/s; any other text as it is. */
export function asWritten(text: string): string {
  const parts = /^([-+]?[\d.]+(?:e[-+]?\d+)?) (\S+)$/i.exec(text);
  return (parts && exactly(Number(parts[1]), parts[2] as string)) ?? text;
}

/** Rounded to the digits that are shown. */
export function rounded(value: number): string {
  return written(Number(value.toPrecision(DIGITS)));
}

/** What a unit with a prefix is, in the unit without. */
export function power(prefixed: string, unit: string): number {
  const found = Object.entries(PREFIXES).find(([, prefix]) => `${prefix}${unit}` === prefixed);
  return 10 ** (Number(found?.[0] ?? 0) * (PREFIXED[unit] ?? 1));
}
