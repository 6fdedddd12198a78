/** A motion as sound: time scaled to the audible, resampled, normalised, and written as WAV. */

import type { Pair } from "../../wire/api";

/** A motion over real time: what is heard is its velocity. */
export interface Track {
  /** In seconds, ascending. */
  readonly time: Float64Array;
  /** Displacement. */
  readonly x: Float64Array;
  /** Its rate, per second. */
  readonly velocity: Float64Array;
  /** Hz. */
  readonly frequency: number;
  /** Whether its end is its beginning. */
  readonly loops: boolean;
}

export const RATE = 48_000;
/** Seconds of sound at most. */
export const LONGEST = 30;
const LOOP_SECONDS = 3;
const AUDIBLE = [200, 2000] as const;
const FADE = 0.012;
/** Of full scale. */
const PEAK = 0.89;

/** The nearest shift by octaves that puts a frequency within what is heard well. */
export function octaveFactor(frequency: number): number {
  if (!(frequency > 0)) return 1;
  if (frequency < AUDIBLE[0]) return 2 ** Math.ceil(Math.log2(AUDIBLE[0] / frequency));
  return frequency > AUDIBLE[1] ? 2 ** -Math.ceil(Math.log2(frequency / AUDIBLE[1])) : 1;
}

export interface Sound {
  readonly samples: Float32Array<ArrayBuffer>;
  /** What a unit of velocity became, as a share of full scale. */
  readonly gain: number;
  /** Whether the track is longer than what is played. */
  readonly cut: boolean;
}

/** Each sample is the mean velocity over its time, from displacements: fast parts between samples do not alias into noise. */
export function render(track: Track, factor: number): Sound {
  const { time, x, loops } = track;
  const [first, last] = [time[0] ?? 0, time.at(-1) ?? 0];
  const length = (last - first) / factor;
  const rounds = loops ? Math.max(1, Math.round(LOOP_SECONDS / length)) : 1;
  const seconds = Math.min(length * rounds, LONGEST);
  const count = Math.max(2, Math.round(seconds * RATE));
  // a whole number of rounds in a whole number of samples closes without a click
  const step = ((seconds < length * rounds ? seconds / rounds : length) * factor * rounds) / count;
  const drift = loops ? (x.at(-1) ?? 0) - (x[0] ?? 0) : 0;
  const place = follower(track);
  const samples = new Float32Array(count);
  let before = place(first);
  let peak = 0;
  const values = new Float64Array(count);
  for (let i = 0; i < count; i += 1) {
    const passed = (i + 1) * step;
    const round = loops ? Math.floor(passed / (last - first) + 1e-12) : 0;
    const now = place(first + passed - round * (last - first)) + round * drift;
    const value = (now - before) / step;
    values[i] = value;
    peak = Math.max(peak, Math.abs(value));
    before = now;
  }
  const gain = peak > 0 ? PEAK / peak : 0;
  for (let i = 0; i < count; i += 1) samples[i] = gain * (values[i] as number);
  return { samples, gain, cut: length * rounds > LONGEST };
}

/** Displacement at a time, by cubics through displacements and velocities; times are asked for mostly in their order. */
function follower({ time, x, velocity }: Track): (at: number) => number {
  let i = 0;
  return (at) => {
    if (at < (time[i] as number)) i = 0;
    while (i < time.length - 2 && (time[i + 1] as number) < at) i += 1;
    const h = (time[i + 1] as number) - (time[i] as number);
    if (!(h > 0)) return x[i] as number;
    const s = Math.min(Math.max((at - (time[i] as number)) / h, 0), 1);
    const [a, b] = [s * s * (3 - 2 * s), 1 - s];
    return (1 - a) * (x[i] as number) + a * (x[i + 1] as number) + h * s * b * (b * (velocity[i] as number) - s * (velocity[i + 1] as number));
  };
}

/** Begins and ends in silence. */
export function faded(samples: Float32Array): Float32Array<ArrayBuffer> {
  const soft = new Float32Array(samples);
  const ramp = Math.min(Math.round(FADE * RATE), Math.floor(soft.length / 2));
  for (let i = 0; i < ramp; i += 1) {
    const level = 0.5 - 0.5 * Math.cos((Math.PI * i) / ramp);
    soft[i] = level * (soft[i] as number);
    soft[soft.length - 1 - i] = level * (soft[soft.length - 1 - i] as number);
  }
  return soft;
}

/** Decades that a mode grows or decays by, and seconds of its sound at most. */
const [FOLDS, MODE_SECONDS] = [Math.log(1000), 4];

/** One mode alone, growing from next to nothing or dying away; `eigenvalue` in 1/s. */
export function modeTrack([growth, rate]: Pair): Track {
  const frequency = Math.abs(rate) / (2 * Math.PI);
  const whole = MODE_SECONDS * octaveFactor(frequency);
  const span = Math.min(whole, Math.max(FOLDS / Math.max(Math.abs(growth), 1e-300), 4 / frequency));
  const count = Math.min(Math.max(Math.ceil(span * frequency * 24), 64), 400_000);
  const time = Float64Array.from({ length: count + 1 }, (_, i) => (span * i) / count);
  // in proportion to the largest value, so that nothing overflows
  const level = (t: number) => Math.exp(growth * (growth > 0 ? t - span : t));
  const x = time.map((t) => level(t) * Math.sin(rate * t));
  const velocity = time.map((t) => level(t) * (growth * Math.sin(rate * t) + rate * Math.cos(rate * t)));
  return { time, x, velocity, frequency, loops: false };
}

/** 16-bit mono. */
export function wav(samples: Float32Array): Blob {
  const bytes = new DataView(new ArrayBuffer(44 + 2 * samples.length));
  const text = (at: number, word: string) => [...word].forEach((letter, i) => bytes.setUint8(at + i, letter.charCodeAt(0)));
  text(0, "RIFF");
  bytes.setUint32(4, 36 + 2 * samples.length, true);
  text(8, "WAVEfmt ");
  bytes.setUint32(16, 16, true);
  bytes.setUint16(20, 1, true);
  bytes.setUint16(22, 1, true);
  bytes.setUint32(24, RATE, true);
  bytes.setUint32(28, 2 * RATE, true);
  bytes.setUint16(32, 2, true);
  bytes.setUint16(34, 16, true);
  text(36, "data");
  bytes.setUint32(40, 2 * samples.length, true);
  samples.forEach((sample, i) => bytes.setInt16(44 + 2 * i, Math.round(32767 * Math.min(Math.max(sample, -1), 1)), true));
  return new Blob([bytes.buffer as ArrayBuffer], { type: "audio/wav" });
}
