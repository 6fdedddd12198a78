/** A motion as frames bring it: histories, contact states, phase portrait, spectrum. */

import { classOf } from "../../chart/palette";
import type { Curve } from "../../chart/runs";
import { rangeOf } from "../../chart/scale";
import type { BandsLayer, ChartSpec, Layer } from "../../chart/spec";
import { type Frame, codes, reals, words } from "../../wire/frames";
import type { Collector } from "./useRun";
import type { Mode } from "./eigen";

/** Stretches of time in one contact state. */
export interface Stretches {
  /** The state, in a word. */
  readonly state: string;
  readonly from: Float64Array;
  readonly to: Float64Array;
}

interface Histories {
  /** θ = ω_nx t. */
  readonly time: Float64Array;
  readonly x: Float64Array;
  readonly y: Float64Array;
  readonly velocity: Float64Array;
}

export interface Motion extends Histories {
  readonly states: readonly Stretches[];
  /** With the steps of the engine between the points of the grid. */
  readonly fine: { readonly time: Float64Array; readonly x: Float64Array; readonly velocity: Float64Array };
  /** From when on the steps of the engine are known, not only the grid. */
  readonly known: number;
  readonly spectrum: Curve | null;
  /** What is told of the whole; null while it is computed. */
  readonly outcome: Frame | null;
}

/** Grows as blocks come; its histories are views. */
class Growing {
  private columns = Array.from({ length: 4 }, () => new Float64Array(4096));
  private states = new Uint8Array(4096);
  private length = 0;
  private words: readonly string[] = [];

  add(frame: Frame): void {
    const parts = ["time", "x", "y", "velocity_x"].map((name) => reals(frame, name));
    const more = parts[0]?.length ?? 0;
    while (this.length + more > this.states.length) this.double();
    this.columns.forEach((column, i) => column.set(parts[i] as Float64Array, this.length));
    this.states.set(codes(frame, "contact_state"), this.length);
    this.words = words(frame.arrays.get("contact_state"));
    this.length += more;
  }

  motion(): Motion {
    const [time, x, y, velocity] = this.columns.map((column) => column.subarray(0, this.length)) as [Float64Array, Float64Array, Float64Array, Float64Array];
    const states = stretchesOf(time, this.states.subarray(0, this.length), this.words);
    return { time, x, y, velocity, states, fine: { time, x, velocity }, known: Number.POSITIVE_INFINITY, spectrum: null, outcome: null };
  }

  private double(): void {
    this.columns = this.columns.map((column) => longer(column, new Float64Array(2 * column.length)));
    this.states = longer(this.states, new Uint8Array(2 * this.states.length));
  }
}

function longer<T extends Float64Array | Uint8Array>(from: T, to: T): T {
  to.set(from);
  return to;
}

export function collectMotion(): Collector<Motion> {
  const growing = new Growing();
  return (frame) => {
    if (frame.kind === "outcome") return motionOf(frame);
    if (frame.kind !== "block") return null;
    growing.add(frame);
    return growing.motion();
  };
}

/** The motion, or the cycle, of an outcome. */
export function motionOf(frame: Frame): Motion {
  const [time, x, y, velocity] = [reals(frame, "time"), reals(frame, "x"), reals(frame, "y"), reals(frame, "velocity_x")];
  const spectrum = frame.arrays.has("frequency") ? { x: reals(frame, "frequency"), y: reals(frame, "amplitude") } : null;
  const path = { time: reals(frame, "path_time"), x: reals(frame, "path_x"), velocity: reals(frame, "path_velocity_x") };
  const stick = words(frame.arrays.get("contact_state")).indexOf("stick");
  const known = knownFrom(time, path.time, codes(frame, "contact_state"), stick);
  return { time, x, y, velocity, states: exactStretches(frame, time), fine: merged({ time, x, velocity }, path), known, spectrum, outcome: frame };
}

/** Of a long motion only the last steps are kept; in stick there are none, and none are needed. */
function knownFrom(time: Float64Array, path: Float64Array, states: Uint8Array, stick: number): number {
  const moves = states.findIndex((state) => state !== stick);
  if (moves < 0) return time[0] ?? 0;
  const first = path[0] ?? Number.POSITIVE_INFINITY;
  return first <= (time[moves + 1] ?? Number.POSITIVE_INFINITY) ? (time[0] ?? 0) : first;
}

type Fine = Motion["fine"];

/** Two histories over ascending times in one. */
export function merged(a: Fine, b: Fine): Fine {
  const length = a.time.length + b.time.length;
  const all: Fine = { time: new Float64Array(length), x: new Float64Array(length), velocity: new Float64Array(length) };
  let [i, j] = [0, 0];
  for (let k = 0; k < length; k += 1) {
    const takeA = j >= b.time.length || (i < a.time.length && (a.time[i] as number) <= (b.time[j] as number));
    const [from, at] = takeA ? [a, i] : [b, j];
    if (takeA) i += 1;
    else j += 1;
    all.time[k] = from.time[at] as number;
    all.x[k] = from.x[at] as number;
    all.velocity[k] = from.velocity[at] as number;
  }
  return all;
}

/** Stretches of equal states of a history: each ends where the next begins. */
export function stretchesOf(time: Float64Array, states: Uint8Array, words: readonly string[]): readonly Stretches[] {
  const changes: number[] = [];
  for (let i = 1; i < states.length; i += 1) if (states[i] !== states[i - 1]) changes.push(i);
  const ends = [...changes, states.length - 1].map((i) => time[i] as number);
  return byState([time[0] ?? 0, ...ends], [states[0] ?? -1, ...changes.map((i) => states[i] as number)], words);
}

/** Stretches between the events of an outcome. */
function exactStretches(frame: Frame, time: Float64Array): readonly Stretches[] {
  const [events, after] = [reals(frame, "event_time"), codes(frame, "event_to")];
  const first = codes(frame, "event_from")[0] ?? codes(frame, "contact_state")[0] ?? -1;
  return byState([time[0] ?? 0, ...events, time.at(-1) ?? 0], [first, ...after], words(frame.arrays.get("contact_state")));
}

function byState(ends: readonly number[], states: readonly number[], words: readonly string[]): readonly Stretches[] {
  return words.map((state, code) => {
    const mine = states.flatMap((state, i) => (state === code && (ends[i + 1] as number) > (ends[i] as number) ? [i] : []));
    return { state, from: Float64Array.from(mine, (i) => ends[i] as number), to: Float64Array.from(mine, (i) => ends[i + 1] as number) };
  });
}

/** Contact states as bands; slip is the plain ground. */
function bands(states: readonly Stretches[]): BandsLayer[] {
  return states.flatMap(({ state, from, to }): BandsLayer[] => {
    const style = classOf(state);
    return style.colour === "none" || from.length === 0 ? [] : [{ kind: "bands", label: style.name, from, to, style }];
  });
}

const TIME = "Time $θ$ = $ω_{nx}$ $t$ (−)";
const VELOCITY = "Velocity d$x$/d$θ$ (−)";

/** The three histories, as charts over one time; `end` is where it will end, where that is known. */
export function historySpecs(motion: Motion, belt: number | null, end: number | null): readonly ChartSpec[] {
  const chart = (title: string, label: string, lines: readonly Layer[]): ChartSpec => ({
    title,
    x: { label: TIME, scale: "linear", ...(end !== null && end > 0 ? { range: [0, end] as const } : {}) },
    y: { label, scale: "linear" },
    layers: [...bands(motion.states), ...lines],
  });
  const { fine, time } = motion;
  const slip: Layer[] = belt === null ? [] : [{ kind: "rule", label: "substrate $v_{d}$", across: "y", at: belt, role: "decoupled-boundary" }];
  return [
    chart("History of x", "$x$/$x_{0}$ (−)", [{ kind: "line", label: "$x$", x: fine.time, y: fine.x, role: { series: 0 } }]),
    chart("History of y", "$y$/$x_{0}$ (−)", [{ kind: "line", label: "$y$", x: time, y: motion.y, role: { series: 2 }, dash: "solid" }]),
    chart("History of the velocity", VELOCITY, [{ kind: "line", label: "d$x$/d$θ$", x: fine.time, y: fine.velocity, role: { series: 0 } }, ...slip]),
  ];
}

/** A cycle, closed. */
export interface Loop {
  readonly x: Float64Array;
  readonly velocity: Float64Array;
}

export function portraitSpec(motion: Motion | null, cycle: Loop | null, belt: number | null, steady: number | null): ChartSpec {
  const layers: Layer[] = [];
  if (belt !== null) layers.push({ kind: "rule", label: "slip line, $v_{d}$", across: "y", at: belt, role: "decoupled-boundary" });
  if (motion) layers.push(...portraitOf(motion));
  if (cycle) layers.push({ kind: "line", label: "limit cycle", x: cycle.x, y: cycle.velocity, role: { series: 1 } });
  if (steady !== null) layers.push({ kind: "points", label: "steady sliding", x: [steady], y: [0], role: { series: 6 }, hollow: true });
  const across = rangeOf("linear", [motion?.fine.x ?? [], cycle?.x ?? [], steady === null ? [] : [steady]], 0.05);
  return { title: "Phase portrait", x: { label: "$x$/$x_{0}$ (−)", scale: "linear", range: across }, y: { label: VELOCITY, scale: "linear" }, layers };
}

/** Dots of a portrait at most: each is an outline. */
const DOTS = 2500;
/** Steps of its line at most: as many oscillations as can be told apart, drawn anew at every step of a drag. */
const STEPS = 8000;

/** A line where every step is known; dots where only points of the grid are, between which a line would be invented. */
function portraitOf({ fine, time, x, velocity, known }: Motion): Layer[] {
  const begin = Math.max(known, fine.time.at(-STEPS) ?? known);
  const from = fine.time.findIndex((time) => time >= begin);
  const unknown = time.findIndex((time) => time >= begin);
  const end = unknown < 0 ? time.length : unknown;
  const stride = Math.max(1, Math.ceil(end / DOTS));
  const dots = (values: Float64Array) => values.subarray(0, end).filter((_, i) => i % stride === 0);
  return [
    ...(end > 0 ? [{ kind: "points", label: "motion, points of its grid", x: dots(x), y: dots(velocity), role: { series: 0 }, size: 3 } as const] : []),
    ...(from >= 0 ? [{ kind: "line", label: "motion", x: fine.x.subarray(from), y: fine.velocity.subarray(from), role: { series: 0 } } as const] : []),
  ];
}

/** Amplitudes below this share of the largest are left out of what is shown at first. */
const FLOOR = 1e-4;

export function spectrumSpec(spectrum: Curve, modes: readonly Mode[]): ChartSpec {
  const largest = spectrum.y.reduce((most, value) => Math.max(most, value), 0);
  const marked = modes.filter((mode) => mode.oscillates);
  const above = spectrum.x.filter((_, i) => (spectrum.y[i] as number) > FLOOR * largest).at(-1) ?? 1;
  const most = Math.min(Math.max(above, 1.25 * Math.max(0, ...marked.map((mode) => mode.value[1]))), spectrum.x.at(-1) ?? 1);
  const layers: Layer[] = [
    { kind: "line", label: "amplitude of $x$", ...spectrum, role: { series: 6 }, dash: "solid" },
    ...marked.map((mode): Layer => ({ kind: "rule", label: `eigenfrequency of ${mode.name}`, across: "x", at: mode.value[1], role: { mode: modes.indexOf(mode) } })),
  ];
  return {
    title: "Spectrum of the motion",
    x: { label: "Frequency $ω$/$ω_{nx}$ (−)", scale: "linear", range: [0, most > 0 ? most : 1] },
    y: { label: "Amplitude of $x$/$x_{0}$ (−)", scale: "log", ...(largest > 0 ? { range: [FLOOR * largest, 2 * largest] as const } : {}) },
    layers,
  };
}

/** The frequency (rad per θ) with the largest amplitude, the mean aside. */
export function strongest(spectrum: Curve | null): number | null {
  if (!spectrum) return null;
  let best = 1;
  for (let i = 2; i < spectrum.y.length; i += 1) if ((spectrum.y[i] as number) > (spectrum.y[best] as number)) best = i;
  return (spectrum.y[best] ?? 0) > 0 ? (spectrum.x[best] ?? null) : null;
}
