/** A figure as `judder-report` describes it (figure.rs, wire.rs). */

import type { ColourMap, Dash, Marker } from "../chart/palette";
import type { Range, Scale } from "../chart/scale";

export interface Figure {
  readonly name: string;
  readonly title: string;
  readonly caption: string;
  readonly columns: number;
  readonly panels: readonly Panel[];
}

export interface Panel {
  readonly title?: string;
  readonly x: Axis;
  readonly y: Axis;
  readonly layers: readonly Layer[];
  readonly second?: { readonly label: string; readonly x: Numbers; readonly value: Numbers };
}

export interface Axis {
  readonly label: string;
  readonly scale: Scale;
  readonly range: Range;
  readonly names?: readonly (readonly [number, string])[];
}

/** NaN is a gap. */
export type Numbers = ArrayLike<number>;

export type Role =
  | string
  | { readonly mode: number }
  | { readonly series: number }
  | { readonly graded: { readonly index: number; readonly count: number } };

interface Style {
  readonly role: Role;
  readonly dash: Dash;
  readonly marker: Marker;
  readonly crowded: boolean;
  /** In points. */
  readonly width: number;
}

export interface Line {
  readonly label: string;
  readonly x: Numbers;
  readonly y: Numbers;
  readonly style: Style;
  readonly swing?: Swing;
  readonly sizes?: Numbers;
}

/** At the phase φ points stand at their rest + Re((a + i b) e^{iφ}); they are drawn at φ = 0. */
export interface Swing {
  readonly x: readonly [a: Numbers, b: Numbers];
  readonly y: readonly [a: Numbers, b: Numbers];
}

export interface ClassMap {
  readonly x: Numbers;
  readonly y: Numbers;
  readonly codes: Numbers;
  readonly classes: readonly { readonly label: string; readonly role: Role }[];
}

interface ValueMap {
  readonly x: Numbers;
  readonly y: Numbers;
  readonly z: Numbers;
  readonly bar: Axis;
  readonly colours: ColourMap;
}

export type Layer =
  | { readonly line: Line }
  | { readonly points: Line }
  | { readonly classes: ClassMap }
  | { readonly values: ValueMap }
  | { readonly rule: { readonly direction: "horizontal" | "vertical"; readonly value: number; readonly label: string } }
  | { readonly region: { readonly label: string; readonly x: Range | null; readonly y: Range | null; readonly role: Role } }
  | { readonly note: { readonly x: number; readonly y: number; readonly text: string } };

type Kind = "f4" | "f8" | "u1";

/** Bytes of a number, and how they are read. */
const KINDS: Record<Kind, readonly [size: number, read: (bytes: ArrayBuffer) => Numbers]> = {
  f4: [4, (bytes) => new Float32Array(bytes)],
  f8: [8, (bytes) => new Float64Array(bytes)],
  u1: [1, (bytes) => new Uint8Array(bytes)],
};

/** Reads a figure with its arrays. */
export async function described(text: string): Promise<Figure> {
  const { arrays, bytes, ...figure } = JSON.parse(text) as { arrays: (readonly [Kind, number])[]; bytes: string };
  const all = await inflated(bytes);
  let start = 0;
  const read = arrays.map(([kind, length]) => {
    const [size, of] = KINDS[kind];
    const array = of(bySignificance(all.subarray(start, start + size * length), size, length));
    start += size * length;
    return array;
  });
  return filled(figure, read) as Figure;
}

async function inflated(base64: string): Promise<Uint8Array> {
  const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Numbers whose lowest bytes stand first, then the next ones, as they are in memory. */
function bySignificance(planes: Uint8Array, size: number, length: number): ArrayBuffer {
  const bytes = new Uint8Array(size * length);
  for (let place = 0; place < size; place += 1) {
    for (let k = 0; k < length; k += 1) bytes[size * k + place] = planes[length * place + k] as number;
  }
  return bytes.buffer;
}

/** The value with its arrays in their places, and gaps in short ones that stand there already. */
function filled(value: unknown, arrays: readonly Numbers[]): unknown {
  if (Array.isArray(value)) return value.some((item) => typeof item === "number") ? value.map((item) => item ?? Number.NaN) : value.map((item) => filled(item, arrays));
  if (typeof value !== "object" || value === null) return value;
  if ("array" in value) return arrays[value.array as number];
  return Object.fromEntries(Object.entries(value).map(([key, field]) => [key, filled(field, arrays)]));
}
