/**
 * Decodes `application/x-judder-frames`: a sequence of frames, each `u32` length of the header, `u32` length of the payload,
 * the header (JSON) and the payload (little-endian arrays at multiples of 8).
 */

export interface FrameArray {
  readonly name: string;
  /** `f64`, `u8`, `complex` (pairs of f64) or `text`. */
  readonly type: string;
  readonly shape: readonly number[];
  readonly dimensions: readonly string[];
  readonly units: string;
  readonly longName: string;
  readonly attributes: Readonly<Record<string, unknown>>;
  /** Numbers; empty for texts. Complex numbers are real and imaginary parts in turn. */
  readonly data: Float64Array | Uint8Array;
  /** Texts; empty for numbers. */
  readonly texts: readonly string[];
}

export interface Frame {
  readonly kind: string;
  readonly header: Readonly<Record<string, unknown>>;
  readonly arrays: ReadonlyMap<string, FrameArray>;
}

export class FrameError extends Error {
  override readonly name = "FrameError";
}

/** Longer frames are not sent: such a length is a broken stream. */
const LARGEST_FRAME = 2 ** 30;
const PREFIX = 8;

/** Takes chunks as they come and gives the frames that are complete, each decoded when it is asked for. */
export class FrameDecoder {
  /** The frame that is being filled; before its lengths are known only the prefix. */
  private filling: Uint8Array = new Uint8Array(PREFIX);
  private filled = 0;

  *push(chunk: Uint8Array): Generator<Frame, void, void> {
    let from = 0;
    while (from < chunk.length) {
      const whole = this.filled === 0 ? wholeFrame(chunk, from) : undefined;
      if (whole) {
        from += whole.length;
        yield decodeFrame(whole);
        continue;
      }
      const count = Math.min(this.filling.length - this.filled, chunk.length - from);
      this.filling.set(chunk.subarray(from, from + count), this.filled);
      this.filled += count;
      from += count;
      if (this.filled === PREFIX && this.filling.length === PREFIX) this.grow();
      if (this.filled === this.filling.length && this.filled > PREFIX) {
        const frame = this.filling;
        this.filling = new Uint8Array(PREFIX);
        this.filled = 0;
        yield decodeFrame(frame);
      }
    }
  }

  /** Tells whether the stream may end here. */
  finish(): void {
    if (this.filled > 0) throw new FrameError("the answer ended within a frame");
  }

  private grow(): void {
    const frame = new Uint8Array(frameLength(this.filling, 0));
    frame.set(this.filling);
    this.filling = frame;
  }
}

/** The bytes of the frame at `from` where all of it lies in the chunk and can be viewed in place. */
function wholeFrame(chunk: Uint8Array, from: number): Uint8Array | undefined {
  if (chunk.length - from < PREFIX || (chunk.byteOffset + from) % 8 !== 0) return undefined;
  const length = frameLength(chunk, from);
  return chunk.length - from < length ? undefined : chunk.subarray(from, from + length);
}

function frameLength(bytes: Uint8Array, from: number): number {
  const view = new DataView(bytes.buffer, bytes.byteOffset + from, PREFIX);
  const [header, payload] = [view.getUint32(0, true), view.getUint32(4, true)];
  const length = PREFIX + header + payload;
  if ((PREFIX + header) % 8 !== 0 || payload % 8 !== 0 || header < 2 || length > LARGEST_FRAME) {
    throw new FrameError(`no frame has a header of ${header} and a payload of ${payload} bytes`);
  }
  return length;
}

/** Decodes one whole frame that starts at a multiple of 8 of its buffer; its arrays are views. */
export function decodeFrame(bytes: Uint8Array): Frame {
  const headerLength = new DataView(bytes.buffer, bytes.byteOffset, PREFIX).getUint32(0, true);
  const text = new TextDecoder("utf-8", { fatal: true }).decode(bytes.subarray(PREFIX, PREFIX + headerLength));
  const header = JSON.parse(text) as Record<string, unknown>;
  if (typeof header["kind"] !== "string") throw new FrameError("a frame without a kind");
  const payload = bytes.subarray(PREFIX + headerLength);
  const listed = Array.isArray(header["arrays"]) ? (header["arrays"] as Record<string, unknown>[]) : [];
  const arrays = new Map(listed.map((entry) => decodeArray(entry, payload)).map((array) => [array.name, array]));
  return { kind: header["kind"], header, arrays };
}

function decodeArray(entry: Record<string, unknown>, payload: Uint8Array): FrameArray {
  const shape = (entry["shape"] as number[] | undefined) ?? [];
  const type = String(entry["type"]);
  return {
    name: String(entry["name"]),
    type,
    shape,
    dimensions: (entry["dimensions"] as string[] | undefined) ?? [],
    units: (entry["units"] as string | null | undefined) ?? "",
    longName: (entry["long_name"] as string | null | undefined) ?? "",
    attributes: (entry["attributes"] as Record<string, unknown> | null | undefined) ?? {},
    data: decodeNumbers(type, Number(entry["offset"] ?? 0), shape, payload),
    texts: type === "text" ? ((entry["values"] as string[] | undefined) ?? []) : [],
  };
}

function decodeNumbers(type: string, offset: number, shape: readonly number[], payload: Uint8Array) {
  const count = shape.reduce((product, length) => product * length, 1);
  if (type === "text") return new Uint8Array(0);
  const size = type === "u8" ? 1 : type === "complex" ? 16 : 8;
  if (!["u8", "f64", "complex"].includes(type)) throw new FrameError(`an array of the unknown type ${type}`);
  if (!Number.isInteger(offset) || offset % 8 !== 0 || offset < 0 || offset + count * size > payload.length) {
    throw new FrameError("an array beyond its frame");
  }
  const start = payload.byteOffset + offset;
  return type === "u8"
    ? new Uint8Array(payload.buffer, start, count)
    : new Float64Array(payload.buffer, start, (count * size) / 8);
}

/** The frames of a stream of bytes, as they come. */
export async function* frames(stream: ReadableStream<Uint8Array>): AsyncGenerator<Frame, void, void> {
  const decoder = new FrameDecoder();
  const reader = stream.getReader();
  try {
    for (;;) {
      const { done, value } = await reader.read();
      if (done) break;
      yield* decoder.push(value);
    }
    decoder.finish();
  } finally {
    // leaving the loop early must close the connection: the server stops computing then
    void reader.cancel().catch(() => undefined);
  }
}

/** The numbers of an array; empty where the frame has none of this name. */
export function reals(frame: Frame, name: string): Float64Array {
  const data = frame.arrays.get(name)?.data;
  if (data instanceof Float64Array) return data;
  return data ? Float64Array.from(data) : new Float64Array(0);
}

/** The codes of an array; empty where the frame has none of this name. */
export function codes(frame: Frame, name: string): Uint8Array {
  const data = frame.arrays.get(name)?.data;
  return data instanceof Uint8Array ? data : new Uint8Array(0);
}

/** The words that the codes of an array stand for, by code. */
export function words(array: FrameArray | undefined): readonly string[] {
  const { flag_values: values, flag_meanings: told } = array?.attributes ?? {};
  const words = typeof told === "string" ? told.split(" ").map((word) => word.replaceAll("_", " ")) : [];
  const codes = Array.isArray(values) ? values.map(Number) : [...words.keys()];
  return Array.from({ length: Math.max(-1, ...codes) + 1 }, (_, code) => words[codes.indexOf(code)] ?? "");
}

/** What the codes of an array mean, an entry a code: the words that it brings. */
export function meanings(array: FrameArray): readonly string[] {
  const own = words(array);
  return Array.from(array.data, (code) => own[code] ?? "");
}
