/** Numbers of parameters: what a slider gives, and how values are written. */

import { written } from "../chart/readout";
import { shrink, stretch } from "../chart/scale";
import type { CaseValue, Key } from "../wire/api";
import { readable, withUnit } from "./readable";

/** A number of so many significant digits: the address and the exported case hold exactly what is shown. */
export function significant(value: number, digits = 4): number {
  return Number(value.toPrecision(digits));
}

/** What a key is called: the last part of its path, in words. */
export function keyName({ path }: Pick<Key, "path">): string {
  return (path.split(".").at(-1) ?? path).replaceAll("_", " ");
}

/** A symbol of a key as markup: what follows an underscore is lowered, and so is 0 or ∞ after a letter. */
export function symbolMarkup(symbol: string): string {
  return `$${symbol.replace(/_([A-Za-z0-9]+)/g, "_{$1}").replace(/(\p{L})([0∞])/gu, "$1_{$2}")}$`;
}

const LOWERED = { from: "0123456789aehijklmnoprstuvx", to: "₀₁₂₃₄₅₆₇₈₉ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ" } as const;

/** A symbol where there is no markup, with lowered letters where there are such; nothing where one of them has none. */
export function symbolText(symbol: string): string {
  let whole = true;
  const lower = (letters: string) =>
    [...letters].map((letter) => {
      const at = LOWERED.from.indexOf(letter);
      whole &&= at >= 0;
      return LOWERED.to[at] ?? "";
    }).join("");
  const text = symbol.replace(/_([A-Za-z0-9]+)/g, (_, letters: string) => lower(letters)).replace(/(\p{L})0/gu, "$1₀");
  return whole ? text : "";
}

/** What stands at an axis of a key: its group, or its symbol with the unit. */
export function signOf(key: Key, dimensional: boolean): string {
  if (key.group !== null && !dimensional) return symbolMarkup(key.group);
  return symbolMarkup(key.symbol) + (isPure(key) ? "" : ` (${key.unit})`);
}

/** The value as a plain number of the case file says it: the group where there is one, otherwise in the key's unit. */
export function plainValue(key: Key, value: CaseValue): number {
  return (key.group === null ? value.si : value.group) ?? value.number;
}

/** A key in a list of them. */
export function keyHead(key: Key): string {
  return `${keyName(key)} ${symbolText(key.symbol)}`.trim();
}

/** The text that sets a key to such a number: a key without a group takes nothing without its unit. */
export function plainText(key: Key, value: number): string {
  return key.group === null && !isPure(key) ? `${value} ${key.unit}` : String(value);
}

/** The number that such a text says; undefined for other units, which only the server reads. */
export function numberIn(key: Key, text: string): number | undefined {
  const [number, unit, ...rest] = text.trim().split(/\s+/);
  const asked = key.group === null && !isPure(key) ? key.unit : undefined;
  const value = Number(number);
  return rest.length === 0 && unit === asked && Number.isFinite(value) ? value : undefined;
}

export function isPure(key: Key): boolean {
  return key.unit === "1" || key.unit === "";
}

/** The text that sets a key to its value. */
export function valueText(key: Key, value: CaseValue): string {
  return value.form === "si" && value.si !== null && !isPure(key) ? `${value.si} ${key.unit}` : String(value.number);
}

/** The other form of a value, as markup: with its unit beside a group, the group beside a value with a unit. */
export function otherForm(key: Key, value: CaseValue): string {
  const si = value.si === null || isPure(key) ? "" : withUnit(readable(significant(value.si), key.unit));
  const group = value.group === null || key.group === null ? "" : `${symbolMarkup(key.group)} = ${written(significant(value.group))}`;
  return value.form === "si" ? group : si;
}

export const SLIDER_STEPS = 1000;

/** The ends of a key's slider, moved out to its value where that lies beyond. */
export function sliderRange(key: Key, value: number): readonly [number, number] {
  const { from, to, scale } = key.slider;
  if (!Number.isFinite(value) || (scale === "log" && value <= 0)) return [from, to];
  return [Math.min(from, value), Math.max(to, value)];
}

export function sliderPlace(key: Key, value: number): number {
  const { scale } = key.slider;
  const [from, to] = sliderRange(key, value);
  const share = (stretch(scale, value) - stretch(scale, from)) / (stretch(scale, to) - stretch(scale, from));
  return Number.isFinite(share) ? Math.round(share * SLIDER_STEPS) : 0;
}

/** The value at a place of the slider, whose ends are those of `range`. */
export function sliderValue(key: Key, range: readonly [number, number], place: number): number {
  const { scale } = key.slider;
  if (place <= 0) return range[0];
  if (place >= SLIDER_STEPS) return range[1];
  const [from, to] = [stretch(scale, range[0]), stretch(scale, range[1])];
  return significant(shrink(scale, from + ((to - from) * place) / SLIDER_STEPS));
}
