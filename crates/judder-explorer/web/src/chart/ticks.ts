/** Where an axis is marked and what stands at the marks: as in drawings (`judder-report`, ticks.rs), whose marks are this one's tests. */

import { type Range, type Scale, fraction } from "./scale";

export interface Tick {
  readonly value: number;
  /** Markup (see `markup.ts`); empty for a mark that, for want of room, has no label. */
  readonly label: string;
}

export interface Ticks {
  readonly major: readonly Tick[];
  readonly minor: readonly number[];
  /** Power of ten that the labels leave out and the label of the axis has to name. */
  readonly exponent: number | null;
}

/** A hair's width at the ends of an axis, as a share of it. */
const HAIR = 1e-9;

/** Ticks of an axis that has room for about `room` labels. */
export function ticks(scale: Scale, range: Range, room: number): Ticks {
  const places = Math.max(2, Math.floor(room));
  const own = shown(allTicks(scale, range, places), scale, range);
  // between two decades there may be none
  const labels = own.major.filter((tick) => tick.label !== "").length;
  return labels < 2 ? shown(linearTicks(range[0], range[1], places), scale, range) : own;
}

/** The ticks of an axis with names: one each. */
export function namedTicks(names: readonly (readonly [number, string])[], scale: Scale, range: Range): Ticks {
  return shown({ major: names.map(([value, label]) => ({ value, label })), minor: [], exponent: null }, scale, range);
}

/** The ticks within the range. */
function shown(all: Ticks, scale: Scale, range: Range): Ticks {
  const inside = (value: number) => {
    const share = fraction(scale, range, value);
    return share >= -HAIR && share <= 1 + HAIR;
  };
  return { ...all, major: all.major.filter((tick) => inside(tick.value)), minor: all.minor.filter(inside) };
}

function allTicks(scale: Scale, [from, to]: Range, room: number): Ticks {
  if (scale === "linear") return linearTicks(from, to, room);
  if (scale === "log") return logTicks(from, to, room);
  return symmetricLogTicks(from, to, scale["symmetric-log"].linear, room);
}

/** Multiples of 1, 2 or 5 times a power of ten, with fifths or quarters between them. */
function linearTicks(from: number, to: number, room: number): Ticks {
  let [leading, power] = niceStep((to - from) / room);
  // a single label does not tell the scale, so a step that allows no second one is refined
  for (let more = room + 1; more < room + 4 && multiples(from, to, leading * 10 ** power).length < 2; more += 1) {
    [leading, power] = niceStep((to - from) / more);
  }
  const step = leading * 10 ** power;
  const largest = Math.floor(Math.log10(Math.max(Math.abs(from), Math.abs(to))));
  const exponent = largest < -2 || largest > 4 ? largest : null;
  const decimals = Math.min(Math.max((exponent ?? 0) - power, 0), 15);
  const label = (value: number) => plain(value / 10 ** (exponent ?? 0), decimals);
  const major = multiples(from, to, step).map((value) => ({ value, label: label(value) }));
  return { major, minor: multiples(from, to, step / (leading === 2 ? 4 : 5)), exponent };
}

/** The smallest of 1, 2, 5 times a power of ten that is not below `least`, as factor and power. */
function niceStep(least: number): [number, number] {
  const power = Math.floor(Math.log10(least));
  const mantissa = least / 10 ** power;
  if (mantissa <= 1) return [1, power];
  if (mantissa <= 2) return [2, power];
  return mantissa <= 5 ? [5, power] : [1, power + 1];
}

/** The multiples of `step` in a range; none where the step drowns in rounding. */
function multiples(from: number, to: number, step: number): number[] {
  const [first, last] = [Math.ceil(from / step - 1e-9), Math.floor(to / step + 1e-9)];
  const count = last - first >= 0 && last - first < 1000 ? last - first + 1 : 0;
  return Array.from({ length: count }, (_, index) => (first + index) * step);
}

/** Decades, thinned to the room, with 2..9 between them; within one decade its own multiples. */
function logTicks(from: number, to: number, room: number): Ticks {
  const first = Math.ceil(Math.log10(from) - 1e-9);
  const last = Math.floor(Math.log10(to) + 1e-9);
  if (last - first < 1) return withinADecade(from, to, room);
  const count = last - first + 1;
  const stride = strideOf(count, room);
  const shown = powers(first, last);
  const major = shown.map((power) => ({ value: powerOfTen(power), label: power % stride === 0 ? decade(power) : "" }));
  const minor = count <= 3 * room ? [first - 1, ...shown].flatMap(betweenDecades) : [];
  return { major, minor, exponent: null };
}

/** The number that the text says: `10 ** -5` is not always the one nearest to 1e-5. */
function powerOfTen(power: number): number {
  return Number(`1e${power}`);
}

function strideOf(count: number, room: number): number {
  const least = Math.max(Math.ceil((count - 1) / room), 1);
  return [1, 2, 3, 5, 10, 20, 50, 100].find((stride) => stride >= least) ?? 200;
}

function decade(power: number): string {
  return `10^{${plain(power, 0)}}`;
}

function betweenDecades(power: number): number[] {
  return [2, 3, 4, 5, 6, 7, 8, 9].map((factor) => Number(`${factor}e${power}`));
}

/** A log range with fewer than two decades: multiples of its powers of ten, or linear ticks where it is short. */
function withinADecade(from: number, to: number, room: number): Ticks {
  const power = Math.floor(Math.log10(from));
  const all = [power, power + 1, power + 2]
    .flatMap((power) => [1, 2, 3, 4, 5, 6, 7, 8, 9].map((factor) => ({ factor, value: Number(`${factor}e${power}`) })))
    .filter(({ value }) => value >= from && value <= to);
  const labelled = all.filter(({ factor }) => all.length <= room || [1, 2, 5].includes(factor));
  if (labelled.length < 2) return linearTicks(from, to, room);
  const major = labelled.map(({ value }) => ({ value, label: scientific(value) }));
  return { major, minor: all.map(({ value }) => value), exponent: null };
}

/** Zero and the decades of both signs outside the linear part. */
function symmetricLogTicks(from: number, to: number, part: number, room: number): Ticks {
  const lowest = Math.ceil(Math.log10(part) - 1e-9);
  const side = (end: number) => (end > 0 ? Math.floor(Math.log10(end) + 1e-9) : lowest - 1);
  const [up, down] = [powers(lowest, side(to)), powers(lowest, side(-from))];
  const count = up.length + down.length;
  if (count === 0) return linearTicks(from, to, room);
  const stride = strideOf(count + 1, room);
  const mark = (sign: number) => (power: number) => ({
    value: sign * powerOfTen(power),
    label: power % stride === 0 ? `${sign < 0 ? "−" : ""}${decade(power)}` : "",
  });
  const major = [...down.map(mark(-1)).reverse(), { value: 0, label: "0" }, ...up.map(mark(1))];
  const between = (decades: readonly number[]) => [lowest - 1, ...decades].flatMap(betweenDecades).filter((value) => value > part);
  const minor = [...between(down).map((value) => -value).reverse(), ...between(up)];
  return { major, minor: count > 3 * room ? [] : minor, exponent: null };
}

function powers(first: number, last: number): number[] {
  return Array.from({ length: Math.max(last - first + 1, 0) }, (_, index) => first + index);
}

/** A number with a true minus sign; zero has none. */
function plain(value: number, decimals: number): string {
  const text = value.toFixed(decimals);
  return Number(text) === 0 ? text.replace("-", "") : text.replace("-", "−");
}

/** A value on its own: plain where it is short, otherwise with a power of ten. */
function scientific(value: number): string {
  const power = Math.floor(Math.log10(Math.abs(value)) + 1e-12);
  if (power >= -3 && power <= 4) return plain(value, Math.max(-power, 0));
  return `${plain(value / 10 ** power, 0)}×10^{${plain(power, 0)}}`;
}
