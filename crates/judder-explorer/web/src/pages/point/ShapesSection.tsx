/** Mode shapes as orbits of a sphere, in motion. */

import { useEffect, useMemo, useRef } from "preact/hooks";
import { registerExport } from "../../chart/exports";
import { INK } from "../../chart/palette";
import { SceneView } from "../../chart/SceneView";
import { markupOf, shape } from "../../chart/scene";
import { withFields } from "../../state/view";
import { useApp } from "../../ui/app";
import { useTheme } from "../../ui/theme";
import { brief } from "../../chart/readout";
import type { Pair, Point } from "../../wire/api";
import { type Mode } from "./eigen";
import { type ModeShape, type Slowed, PICTURE, ground, normalised, offset, orbitAt, orbitCsv, slowed, sphere } from "./orbit";
import type { PointState } from "./state";

const calm = globalThis.matchMedia?.("(prefers-reduced-motion: reduce)");

interface ShapesSectionProps {
  readonly state: PointState;
  readonly point: Point;
  readonly modes: readonly Mode[];
  /** ω_nx in rad/s. */
  readonly frequency: number;
}

export function ShapesSection({ state, point, modes, frequency }: ShapesSectionProps) {
  const { store } = useApp();
  const still = state.still || calm?.matches === true;
  return (
    <section class="card" aria-labelledby="shapes-title">
      <h2 id="shapes-title">Mode shapes</h2>
      <div class="run-bar">
        <button
          type="button"
          aria-pressed={state.still}
          disabled={calm?.matches === true}
          onClick={() => store.update((view) => withFields(view, { still: state.still ? undefined : "on" }))}
        >
          Pause
        </button>
        <span class="note">
          {calm?.matches ? "This system asks for less motion: orbits stand still." : "Orbits have no scale: each fills its picture, then grows or decays as its eigenvalue says."}
        </span>
      </div>
      <div class="shapes">
        {modes.map((mode, index) => (
          <ModePicture key={index} mode={mode} index={index} shape={point.modes[mode.index]?.shape ?? []} frequency={frequency} still={still} />
        ))}
      </div>
    </section>
  );
}

interface ModePictureProps {
  readonly mode: Mode;
  readonly index: number;
  readonly shape: readonly Pair[];
  readonly frequency: number;
  readonly still: boolean;
}

function ModePicture({ mode, index, shape: given, frequency, still }: ModePictureProps) {
  const theme = useTheme();
  const [re, im] = mode.value;
  const orbit = useMemo(() => normalised(given), [given]);
  const motion = useMemo(() => slowed([re * frequency, im * frequency]), [re, im, frequency]);
  const moving = useMovement(orbit, motion, still);
  const title = `Orbit of ${mode.name}`;
  useExported(title, orbit, mode, index);
  return (
    <figure class="shape">
      <svg viewBox={`0 0 ${PICTURE.width} ${PICTURE.height}`} role="img" aria-label={`${title}: ${inWords(mode)}`}>
        <SceneView shapes={ground(orbit, mode.oscillates, index, theme)} />
        <g ref={moving}>
          <SceneView shapes={sphere(theme)} />
        </g>
      </svg>
      <figcaption>
        <b>{mode.name}</b> {inWords(mode)}
        <br />
        {mode.oscillates && `${brief((im * frequency) / (2 * Math.PI))} Hz, `}
        {brief(re * frequency)} 1/s; {motion.factor >= 1 ? `slowed ${brief(motion.factor)} times` : `sped up ${brief(1 / motion.factor)} times`}
      </figcaption>
    </figure>
  );
}

function inWords({ value: [re], oscillates }: Mode): string {
  return `${oscillates ? "oscillates and" : "moves along a line and"} ${re > 0 ? "grows" : "decays"}`;
}

/** The picture at the orbit's beginning, in the export menu. */
function useExported(title: string, orbit: ModeShape, mode: Mode, index: number): void {
  const figure = () => ({ size: SAVED, svg: async () => pictureFile(title, orbit, mode, index), csv: () => orbitCsv(orbit, mode.oscillates) });
  const newest = useRef(figure);
  newest.current = figure;
  useEffect(() => registerExport(title, () => newest.current()), [title]);
}

const SAVED = { width: 2 * PICTURE.width, height: 2 * PICTURE.height };

function pictureFile(title: string, orbit: ModeShape, mode: Mode, index: number): string {
  const { width, height } = PICTURE;
  const backdrop = shape("rect", { width, height, fill: INK.light.ground });
  const attributes = { xmlns: "http://www.w3.org/2000/svg", ...SAVED, viewBox: `0 0 ${width} ${height}` };
  const { dx, dy } = offset(orbitAt(orbit, 0));
  const moved = shape("g", { transform: `translate(${dx} ${dy})` }, ...sphere("light"));
  const picture = shape("svg", attributes, shape("title", {}, title), backdrop, ...ground(orbit, mode.oscillates, index, "light"), moved);
  return `<?xml version="1.0" encoding="UTF-8"?>\n${markupOf(picture)}\n`;
}

/** Moves an element along the orbit without drawing anew; at rest it stands where the orbit begins. */
function useMovement(orbit: ModeShape, motion: Slowed, still: boolean) {
  const element = useRef<SVGGElement>(null);
  useEffect(() => {
    const place = (amplitude: number, phase: number) => {
      const { dx, dy } = offset(orbitAt(orbit, phase));
      element.current?.setAttribute("transform", `translate(${amplitude * dx} ${amplitude * dy})`);
    };
    if (still) return place(1, 0);
    const begin = performance.now();
    let request = requestAnimationFrame(function step(now) {
      const { amplitude, phase } = motion.at(Math.max(now - begin, 0) / 1000);
      place(amplitude, phase);
      request = requestAnimationFrame(step);
    });
    return () => cancelAnimationFrame(request);
  }, [orbit, motion, still]);
  return element;
}
