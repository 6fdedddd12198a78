/** A mode that moves, in space: orbit, views, scale, phase, colours by displacement. */

import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { Chart } from "../../chart/Chart";
import { homeWindow } from "../../chart/frame";
import { registerExport } from "../../chart/exports";
import { type Keep, useView } from "../../state/store";
import { withFields } from "../../state/view";
import { useApp } from "../../ui/app";
import { download, fileName } from "../../ui/files";
import { useTheme } from "../../ui/theme";
import { type Body, DISPLACEMENT, type Swing, bodySpec, drawnFactor } from "./body";
import { DisplacementBar } from "./DisplacementBar";
import { short } from "./locus";
import { ScaleAndPhase } from "./ScaleAndPhase";
import { FREE, type Look, numberField, readLook, readScale, withLook } from "./state";
import { PERIOD, useBodyScene } from "./useBodyScene";

interface ShapeViewProps {
  /** What is shown: the name of exported files. */
  readonly title: string;
  readonly body: Body;
  readonly swing: Swing;
  /** Hz; null where it is not known. */
  readonly frequency: number | null;
  /** 1/s; null where there is no damping. */
  readonly growth: number | null;
  /** The unit of the shape's numbers. */
  readonly unit: string;
}

const VIEWS: readonly (readonly [string, Look])[] = [
  ["Front", { azimuth: 0, elevation: 0 }],
  ["Top", { azimuth: 0, elevation: 90 }],
  ["Side", { azimuth: 90, elevation: 0 }],
  ["Free", FREE],
];
const SIZE = { width: 760, height: 480 };
const STEP = 5;
const [NEAREST, FURTHEST] = [20, 0.2];

export function ShapeView({ title, body, swing, frequency, growth, unit }: ShapeViewProps) {
  const { store } = useApp();
  const view = useView(store);
  const theme = useTheme();
  const look = readLook(view, body.planar);
  const scale = readScale(view);
  const [zoom, setZoom] = useState(1);
  const [phase, setPhase] = useState(((numberField(view, "phase") ?? 0) * Math.PI) / 180);
  // what moves by itself must not where less motion is wished for, nor where the address asks for one moment
  const [playing, setPlaying] = useState(() => !globalThis.matchMedia?.("(prefers-reduced-motion: reduce)").matches && numberField(view, "phase") === undefined);
  const factor = drawnFactor(body, swing, scale);
  const { canvas, state, picture } = useBodyScene({ body, swing, theme, still: { look, zoom, phase, factor }, playing, onPhase: setPhase });

  const spec = useMemo(() => bodySpec(title, body, swing, look, phase, factor), [title, body, swing, look.azimuth, look.elevation, phase, factor]);
  const shown = useRef(spec);
  shown.current = spec;
  // the chart that stands in for the picture registers itself
  useEffect(
    () => (state === "missing" ? undefined : registerExport(title, () => ({ spec: shown.current, window: homeWindow(shown.current), size: SIZE }))),
    [title, state],
  );

  const turn = (next: Look, keep: Keep) => store.update((view) => withLook(view, next), keep);
  const keepPhase = (next: number | undefined) =>
    store.update((view) => withFields(view, { phase: next === undefined ? undefined : String(Math.round((next * 180) / Math.PI) % 360) }), "quiet");
  const play = (on: boolean) => {
    setPlaying(on);
    keepPhase(on ? undefined : phase);
  };
  const still = (next: number) => {
    setPlaying(false);
    setPhase(next);
    keepPhase(next);
  };
  const savePng = () => {
    const address = picture();
    if (address) download(`${fileName(title)}-3d.png`, pngOf(address), "image/png");
  };
  const orbit = useOrbit(look, turn, (by) => setZoom((zoom) => Math.min(Math.max(zoom * by, FURTHEST), NEAREST)), () => setZoom(1));

  return (
    <section class="shape" aria-label={`Shape: ${title}`}>
      <div class="shape-tools">
        <button type="button" onClick={() => play(!playing)} aria-pressed={playing}>
          {playing ? "Pause" : "Play"}
        </button>
        <div role="group" aria-label="Views">
          {VIEWS.map(([name, one]) => (
            <button type="button" key={name} aria-pressed={same(look, one)} onClick={() => turn(one, "push")}>
              {name}
            </button>
          ))}
        </div>
        <button type="button" onClick={savePng} disabled={state !== "drawn"} title="The picture as it is; the export menu has its lines as SVG">
          PNG
        </button>
      </div>
      {state === "missing" && <p role="status">This browser has no WebGL: the projected lines are shown instead.</p>}
      <div class="shape-picture" data-state={state}>
        {state === "missing" ? (
          <Chart spec={spec} height={360} quiet />
        ) : (
          <canvas
            ref={canvas}
            class="shape-canvas"
            role="application"
            aria-roledescription="3-D picture"
            aria-label={`${title}, seen from ${look.azimuth}° around and ${look.elevation}° above`}
            aria-describedby="shape-keys"
            tabindex={0}
            {...orbit}
          />
        )}
        <DisplacementBar theme={theme} largest={swing.largest} unit={unit} />
      </div>
      <p id="shape-keys" class="shape-hint">
        {state === "missing" ? "The views and the two sliders turn it." : "Drag or press the arrow keys to turn it, + and − or the wheel with Ctrl to zoom, 0 for its first size."}
      </p>
      <ScaleAndPhase
        scale={scale}
        onScale={(scale, keep) => store.update((view) => withFields(view, { scale: scale === 1 ? undefined : String(scale) }), keep)}
        phase={phase}
        onPhase={still}
        playing={playing}
        look={look}
        onLook={turn}
      />
      <p class="shape-words">
        {slowness(frequency)} The largest displacement is drawn as {short(100 * DISPLACEMENT * scale)} % of the body&apos;s diagonal. {leftOut(growth)}
      </p>
    </section>
  );
}

/** The bytes behind the address of a picture. */
function pngOf(address: string): Blob {
  const text = atob(address.slice(address.indexOf(",") + 1));
  return new Blob([Uint8Array.from(text, (letter) => letter.charCodeAt(0))], { type: "image/png" });
}

function same(a: Look, b: Look): boolean {
  return a.azimuth === b.azimuth && a.elevation === b.elevation;
}

/** By how much the motion on the page is slower than that of the mode. */
export function slowness(frequency: number | null): string {
  if (frequency === null || !(frequency * PERIOD > 0)) return `One swing takes ${PERIOD} s here.`;
  const slower = frequency * PERIOD;
  return slower >= 1 ? `Slowed down ${short(slower)} times: one swing takes ${PERIOD} s here.` : `Sped up ${short(1 / slower)} times: one swing takes ${PERIOD} s here.`;
}

/** What the picture leaves out of the motion. */
export function leftOut(growth: number | null): string {
  if (growth === null || growth === 0 || !Number.isFinite(growth)) return "The motion neither grows nor decays here.";
  return `Its ${growth > 0 ? "growth" : "decay"}, ${short(Math.abs(growth))} 1/s, is left out of the animation.`;
}

/** Pointer, wheel and keys that turn the picture. */
function useOrbit(look: Look, turn: (look: Look, keep: Keep) => void, zoom: (by: number) => void, home: () => void) {
  const press = useRef<{ id: number; x: number; y: number; look: Look } | null>(null);
  const dragged = (event: PointerEvent) => {
    const held = press.current;
    if (!held || held.id !== event.pointerId) return undefined;
    return { azimuth: held.look.azimuth - (event.clientX - held.x) * 0.5, elevation: held.look.elevation + (event.clientY - held.y) * 0.5 };
  };
  const onPointerDown = (event: PointerEvent) => {
    if (event.button !== 0) return;
    (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    press.current = { id: event.pointerId, x: event.clientX, y: event.clientY, look };
  };
  const onPointerMove = (event: PointerEvent) => {
    const next = dragged(event);
    if (next) turn(next, "drag");
  };
  const onPointerUp = (event: PointerEvent) => {
    const next = dragged(event);
    const moved = press.current && Math.hypot(event.clientX - press.current.x, event.clientY - press.current.y) > 2;
    press.current = null;
    if (next && moved) turn(next, "push");
  };
  const onPointerCancel = () => {
    press.current = null;
  };
  const onWheel = (event: WheelEvent) => {
    // a plain wheel scrolls the page
    if (!event.ctrlKey) return;
    event.preventDefault();
    zoom(Math.exp(-Math.min(Math.max(event.deltaY, -240), 240) * 0.002));
  };
  const onKeyDown = (event: KeyboardEvent) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const step = event.shiftKey ? 3 * STEP : STEP;
    const by: Record<string, readonly [number, number]> = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, step], ArrowDown: [0, -step] };
    const arrow = by[event.key];
    if (arrow) turn({ azimuth: look.azimuth + arrow[0], elevation: look.elevation + arrow[1] }, "step");
    else if (event.key === "+" || event.key === "=") zoom(1.25);
    else if (event.key === "-") zoom(0.8);
    else if (event.key === "0") home();
    else return;
    event.preventDefault();
  };
  return { onPointerDown, onPointerMove, onPointerUp, onPointerCancel, onWheel, onKeyDown };
}
