/** A mode that moves, or steady sliding, in space: orbit, views, scale, phase, colours by displacement or by what contact points carry. */

import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { Chart } from "../../chart/Chart";
import { chartFigure } from "../../chart/export";
import { type Figure, registerExport } from "../../chart/exports";
import { homeWindow } from "../../chart/frame";
import { type Keep, useView } from "../../state/store";
import { withFields } from "../../state/view";
import { useApp } from "../../ui/app";
import { download, fileName } from "../../ui/files";
import { useTheme } from "../../ui/theme";
import { BodyNames } from "./BodyNames";
import { type Body, DISPLACEMENT, type Swing, bodyCsv, bodySpec, drawnFactor, projected } from "./body";
import { ColourBar } from "./ColourBar";
import { short } from "./locus";
import { type Marks, markLayers } from "./marks";
import { ScaleAndPhase } from "./ScaleAndPhase";
import { FREE, type Look, readLook, readScale, withLook } from "./state";
import { sized } from "./words";
import { PERIOD, useBodyScene } from "./useBodyScene";
import { useOrbit } from "./useOrbit";
import { usePlayback } from "./usePlayback";

/** How a mode swings. */
interface Motion {
  /** Hz; null where it is not known. */
  readonly frequency: number | null;
  /** 1/s; null where there is no damping. */
  readonly growth: number | null;
}

interface ShapeViewProps {
  /** What is shown: the name of exported files. */
  readonly title: string;
  readonly body: Body;
  readonly swing: Swing;
  /** Null where it rests. */
  readonly motion: Motion | null;
  /** The unit of the shape's numbers. */
  readonly unit: string;
  /** Contact points, of which the colours tell. */
  readonly marks?: Marks | null;
}

const VIEWS: readonly (readonly [string, Look])[] = [
  ["Front", { azimuth: 0, elevation: 0 }],
  ["Top", { azimuth: 0, elevation: 90 }],
  ["Side", { azimuth: 90, elevation: 0 }],
  ["Free", FREE],
];
const SIZE = { width: 760, height: 480 };
const [NEAREST, FURTHEST] = [20, 0.2];

export function ShapeView(props: ShapeViewProps) {
  return props.body.diagonal > 0 ? <Picture {...props} /> : <p>All freedoms lie at one place: there is no picture of them.</p>;
}

function Picture({ title, body, swing, motion, unit, marks = null }: ShapeViewProps) {
  const { store } = useApp();
  const view = useView(store);
  const theme = useTheme();
  const [look, scale] = [readLook(view, body.planar), readScale(view)];
  const [zoom, setZoom] = useState(1);
  const playback = usePlayback(store, view);
  const [phase, playing] = motion ? [playback.phase, playback.playing] : [0, false];
  const factor = drawnFactor(body, swing, scale);
  const { canvas, state, picture } = useBodyScene({ body, swing, marks, theme, still: { look, zoom, phase, factor }, playing, onPhase: playback.onPhase });

  const spec = useMemo(() => {
    const over = marks ? markLayers(marks, projected(marks.placesAt(swing, phase, factor), look, body.centre)) : [];
    return bodySpec(title, body, swing, look, phase, factor, over);
  }, [title, body, swing, marks, look.azimuth, look.elevation, phase, factor]);
  const dataOf = () => bodyCsv(body, swing, unit);
  useExported(title, () => chartFigure(spec, homeWindow(spec), SIZE, dataOf), state !== "missing");

  const turn = (next: Look, keep: Keep) => store.update((view) => withLook(view, next), keep);
  const savePng = () => {
    const address = picture();
    if (address) download(`${fileName(title)}-3d.png`, pngOf(address), "image/png");
  };
  const orbit = useOrbit(look, turn, (by) => setZoom((zoom) => Math.min(Math.max(zoom * by, FURTHEST), NEAREST)), () => setZoom(1));

  return (
    <section class="shape" aria-label={`Shape: ${title}`}>
      <ShapeTools playing={playing} onPlay={motion ? playback.play : null} look={look} onLook={(one) => turn(one, "push")} {...(state === "drawn" ? { onPng: savePng } : {})} />
      {state === "missing" && <p role="status">This browser has no WebGL: the projected lines are shown instead.</p>}
      <div class="shape-picture" data-state={state}>
        {state === "missing" ? (
          <Chart spec={spec} height={360} dataOf={dataOf} quiet />
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
        <ColourBar theme={theme} {...(marks?.told ?? { name: "Displacement", unit, range: [0, swing.largest] })} dataKey={marks ? "contacts.largest" : "shape.largest"} />
      </div>
      <BodyNames body={body} marks={marks} theme={theme} />
      <p id="shape-keys" class="shape-hint">
        {state === "missing" ? "The views and the two sliders turn it." : "Drag or press the arrow keys to turn it, + and − or the wheel with Ctrl to zoom, 0 for its first size."}
      </p>
      <ScaleAndPhase
        scale={scale}
        onScale={(scale, keep) => store.update((view) => withFields(view, { scale: scale === 1 ? undefined : String(scale) }), keep)}
        phase={motion ? { at: phase, playing, onMove: playback.hold } : null}
        look={look}
        onLook={turn}
      />
      <p class="shape-words">{motion ? swinging(motion, scale) : enlarged(factor, swing.largest, unit)}</p>
    </section>
  );
}

/** The lines of the picture and the shape in the export menu, unless a chart that stands in for it registers itself. */
function useExported(title: string, now: () => Figure, isOwn: boolean): void {
  const newest = useRef(now);
  newest.current = now;
  useEffect(() => (isOwn ? registerExport(title, () => newest.current()) : undefined), [title, isOwn]);
}

interface ToolsProps {
  readonly playing: boolean;
  /** Null where nothing moves. */
  readonly onPlay: ((on: boolean) => void) | null;
  readonly look: Look;
  readonly onLook: (look: Look) => void;
  /** Left out while there is no picture. */
  readonly onPng?: () => void;
}

function ShapeTools({ playing, onPlay, look, onLook, onPng }: ToolsProps) {
  return (
    <div class="shape-tools">
      {onPlay && (
        <button type="button" onClick={() => onPlay(!playing)} aria-pressed={playing}>
          {playing ? "Pause" : "Play"}
        </button>
      )}
      <div role="group" aria-label="Views">
        {VIEWS.map(([name, one]) => (
          <button type="button" key={name} aria-pressed={same(look, one)} onClick={() => onLook(one)}>
            {name}
          </button>
        ))}
      </div>
      <button type="button" onClick={() => onPng?.()} disabled={!onPng} title="The picture as it is; the export menu has its lines as SVG">
        PNG
      </button>
    </div>
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

/** How a swing is drawn. */
function swinging({ frequency, growth }: Motion, scale: number): string {
  return `${slowness(frequency)} The largest displacement is drawn as ${short(100 * DISPLACEMENT * scale)} % of the body's diagonal. ${leftOut(growth)}`;
}

/** By how much displacements at rest are drawn larger than they are. */
export function enlarged(factor: number, largest: number, unit: string): string {
  if (largest === 0) return "Nothing is displaced.";
  const told = sized(unit, [0, largest]);
  return `Displacements are drawn ${short(factor)} times as large as they are; the largest is ${told.text(largest)} ${told.unit}.`;
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
