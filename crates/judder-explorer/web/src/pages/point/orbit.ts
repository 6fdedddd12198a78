/** The motion of a mode: ellipses in (x, y), and the picture of a sphere on its substrate. */

import { table } from "../../chart/csv";
import { INK, type Theme, lineStyle } from "../../chart/palette";
import { type Shape, round, shape } from "../../chart/scene";
import { label } from "../../chart/text";
import type { Pair } from "../../wire/api";

/** Complex amplitudes of x and y. */
export type ModeShape = readonly [Pair, Pair];

/** The shape turned and scaled so that the orbit's largest distance from its middle is 1. */
export function normalised(shape: readonly Pair[]): ModeShape {
  const [x, y]: [Pair, Pair] = [shape[0] ?? [0, 0], shape[1] ?? [0, 0]];
  const largest = Math.max(...Array.from({ length: 180 }, (_, i) => Math.hypot(...orbitAt([x, y], (i * Math.PI) / 180))), 1e-300);
  const scaled = ([re, im]: Pair): Pair => [re / largest, im / largest];
  return [scaled(x), scaled(y)];
}

/** Where the orbit is at this phase: Re(shape · e^{iφ}). */
export function orbitAt([x, y]: ModeShape, phase: number): readonly [number, number] {
  const [c, s] = [Math.cos(phase), Math.sin(phase)];
  return [x[0] * c - x[1] * s, y[0] * c - y[1] * s];
}

/** Points that an orbit is drawn through: both ends are the same place. */
const DRAWN = 73;
const phaseAt = (index: number) => (2 * Math.PI * index) / (DRAWN - 1);

/** The orbit as it is drawn, over one turn without growth; of a mode that moves along a line, how far along it instead of the phase. */
export function orbitCsv(mode: ModeShape, oscillates: boolean): string {
  const along = alongLine(mode);
  const rows = Array.from({ length: DRAWN }, (_, i) => {
    const place = orbitAt(mode, phaseAt(i));
    return [oscillates ? phaseAt(i) : along(place), ...place];
  });
  const first = oscillates ? "phase (rad)" : "displacement along the line over the largest";
  return table([first, "x over the largest distance", "y into the substrate over the largest distance"], rows);
}

/** The part of a place in the direction in which the orbit begins or, where it begins at rest, goes. */
function alongLine(mode: ModeShape): (place: readonly [number, number]) => number {
  const [begin, quarter] = [orbitAt(mode, 0), orbitAt(mode, Math.PI / 2)];
  const [x, y] = Math.hypot(...begin) >= Math.hypot(...quarter) ? begin : quarter;
  const length = Math.max(Math.hypot(x, y), 1e-300);
  return (place) => (place[0] * x + place[1] * y) / length;
}

/** Time is slowed so that a mode turns at this rate, or grows e-fold in this time. */
const [TURNS, FOLD] = [0.6, 1.2];
/** A motion starts anew when it has grown out of the picture or died away. */
const [SMALLEST, LARGEST, CYCLES] = [0.06, 1, 4];

/** One mode in motion: how much slower than real it is shown, and where it is. */
export interface Slowed {
  /** Real time passes so many times slower. */
  readonly factor: number;
  /** Seconds until it starts anew. */
  readonly repeat: number;
  readonly at: (seconds: number) => { readonly amplitude: number; readonly phase: number };
}

/** `eigenvalue` in 1/s. */
export function slowed([growth, frequency]: Pair): Slowed {
  const turns = Math.abs(frequency) / (2 * Math.PI);
  const factor = Math.max(turns / TURNS, Math.abs(growth) * FOLD, 1e-12);
  const rate = growth / factor;
  const span = Math.log(LARGEST / SMALLEST);
  const whole = turns > 0 ? (CYCLES * factor) / turns : Number.POSITIVE_INFINITY;
  const repeat = Math.min(Math.abs(rate) > 1e-9 ? span / Math.abs(rate) : Number.POSITIVE_INFINITY, Math.max(whole, 6), 20);
  const first = rate > 0 ? LARGEST * Math.exp(-rate * repeat) : LARGEST;
  return {
    factor,
    repeat,
    at: (seconds) => {
      const time = seconds % repeat;
      return { amplitude: first * Math.exp(rate * time), phase: (Math.abs(frequency) / factor) * time };
    },
  };
}

export const PICTURE = { width: 240, height: 190 } as const;
const MIDDLE = { x: 120, y: 94 } as const;
const [RADIUS, REACH] = [40, 50];

/** Displacements as pixels: y points into the substrate. */
export function offset([x, y]: readonly [number, number]): { dx: number; dy: number } {
  return { dx: round(REACH * x), dy: round(REACH * y) };
}

/** What does not move: substrate, direction of sliding, orbit with its sense. */
export function ground(mode: ModeShape, oscillates: boolean, colour: number, theme: Theme): Shape[] {
  const { ink, quiet } = INK[theme];
  const style = lineStyle({ mode: colour }, theme);
  const level = MIDDLE.y + RADIUS - 5;
  const points = Array.from({ length: DRAWN }, (_, i) => offset(orbitAt(mode, phaseAt(i))));
  const path = points.map(({ dx, dy }, i) => `${i === 0 ? "M" : "L"}${round(MIDDLE.x + dx)} ${round(MIDDLE.y + dy)}`).join("");
  const axes = `M${MIDDLE.x - REACH - 12} ${MIDDLE.y}h${2 * REACH + 24}M${MIDDLE.x} ${MIDDLE.y - REACH - 12}v${2 * REACH + 24}`;
  return [
    shape("rect", { x: 0, y: level, width: PICTURE.width, height: PICTURE.height - level, fill: theme === "light" ? "#e4dccb" : "#4a4436" }),
    shape("path", { d: `M0 ${level}h${PICTURE.width}`, stroke: ink, "stroke-width": 1.2 }),
    shape("path", { d: `M14 ${level + 48}h58m-8 -5l8 5l-8 5`, stroke: ink, "stroke-width": 1.6, fill: "none" }),
    label("substrate, $v_{d}$", { x: 80, y: level + 52, size: 12, colour: ink }),
    shape("path", { d: axes, stroke: quiet, "stroke-width": 0.7, "stroke-dasharray": "2 3" }),
    label("$x$", { x: MIDDLE.x + REACH + 15, y: MIDDLE.y + 4, size: 12, colour: quiet }),
    label("$y$", { x: MIDDLE.x + 5, y: MIDDLE.y + REACH + 12, size: 12, colour: ink }),
    shape("path", { d: path, fill: "none", stroke: style.colour, "stroke-width": 2 }),
    ...(oscillates ? [arrow(mode, style.colour)] : []),
  ];
}

/** The head of an arrow on the orbit, where it is fastest apart from its ends. */
function arrow(mode: ModeShape, colour: string): Shape {
  const speed = (phase: number) => Math.hypot(orbitAt(mode, phase + 1e-3)[0] - orbitAt(mode, phase)[0], orbitAt(mode, phase + 1e-3)[1] - orbitAt(mode, phase)[1]);
  const phases = Array.from({ length: 72 }, (_, i) => (i * Math.PI) / 72);
  const phase = phases.reduce((best, one) => (speed(one) > speed(best) ? one : best), 0);
  const [here, next] = [offset(orbitAt(mode, phase)), offset(orbitAt(mode, phase + 0.05))];
  const angle = (Math.atan2(next.dy - here.dy, next.dx - here.dx) * 180) / Math.PI;
  return shape("path", {
    d: "M-6 -5L6 0L-6 5z",
    fill: colour,
    transform: `translate(${round(MIDDLE.x + here.dx)} ${round(MIDDLE.y + here.dy)}) rotate(${round(angle)})`,
  });
}

/** The sphere about its place at rest. */
export function sphere(theme: Theme): Shape[] {
  const { ink } = INK[theme];
  return [
    shape("circle", { cx: MIDDLE.x, cy: MIDDLE.y, r: RADIUS, fill: ink, "fill-opacity": 0.1, stroke: ink, "stroke-width": 1.4 }),
    shape("circle", { cx: MIDDLE.x, cy: MIDDLE.y, r: 3.5, fill: ink }),
  ];
}
