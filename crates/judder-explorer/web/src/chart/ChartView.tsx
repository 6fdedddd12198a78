/** The one interactive chart, of pages and of reports: SVG axes and curves over rasters, with zoom, cursor and keys. */

import { useEffect, useId, useLayoutEffect, useMemo, useRef, useState } from "preact/hooks";
import { Label } from "../ui/Label";
import { draw } from "./draw";
import { type Frame, type Size, homeWindow } from "./frame";
import { type Cursor, type Phase, useInteraction, zoomBy } from "./interaction";
import { plainText } from "./markup";
import { type Found, found } from "./nearest";
import { INK, type Theme, lineStyle } from "./palette";
import { RasterView } from "./RasterView";
import { isShown, readings } from "./readout";
import type { Window } from "./scale";
import { SceneView } from "./SceneView";
import { type ChartSpec, isRaster } from "./spec";

/** What a chart shows now. */
export interface Shown {
  readonly window: Window;
  readonly size: Size;
}

/** What is said over the plot. */
interface Standing {
  readonly kind: string;
  readonly words: string;
}

export interface ChartViewProps {
  readonly spec: ChartSpec;
  readonly theme: Theme;
  /** Begins the ids of its picture; left out, one of its own. */
  readonly name?: string;
  readonly standing?: Standing | null;
  /** What it shows, kept current for who asks. */
  readonly shown?: { current: Shown | null };
  /** Reads the point that is nearest in the picture, in the place of every layer at the cursor. */
  readonly nearest?: boolean;
  /** On a page that scrolls, the wheel zooms with Ctrl alone. */
  readonly scrolls?: boolean;
  /** What is shown, where the page keeps it; left out, the chart keeps it itself. Null is everything. */
  readonly window?: Window | null;
  readonly onWindow?: (window: Window | null, phase: Phase) => void;
  /** The cursor, where the page keeps it. */
  readonly cursor?: Cursor | null;
  readonly onCursor?: (cursor: Cursor | null, by: "pointer" | "keyboard") => void;
  /** A click or Enter. */
  readonly onPick?: (cursor: Cursor) => void;
  readonly pin?: Cursor | null;
  /** A value of x that is marked across the plot: a place that other charts share, or what is heard. */
  readonly mark?: number | null;
  /** Further words for the cursor's live region. */
  readonly spoken?: string;
  /** In pixels; left out, the chart fills its parent. */
  readonly height?: number;
  /** Hides the line of readings, where the page shows its own. */
  readonly quiet?: boolean;
}

/** Until an element has been measured. */
const UNMEASURED: Size = { width: 640, height: 420 };

export function ChartView(props: ChartViewProps) {
  const { spec, theme, standing = null } = props;
  const own = `c${useId().replace(/[^\w]/g, "")}`;
  const prefix = props.name ?? own;
  const [host, size] = useSize(props.height);
  const { window, cursor, setWindow, setCursor } = useKept(props);
  const scene = useMemo(
    () => draw(spec, window, size, theme, prefix),
    [spec, window.x[0], window.x[1], window.y[0], window.y[1], size, theme, prefix],
  );
  const { frame } = scene;
  const { element, box, on } = useInteraction(spec, frame, cursor, {
    onWindow: setWindow,
    onCursor: setCursor,
    onPick: props.onPick,
    scrolls: props.scrolls === true,
  });
  if (props.shown) props.shown.current = { window, size };

  const within = cursor && isShown(spec, frame.window, cursor) ? cursor : null;
  const near = within && props.nearest ? found(spec, frame, within) : null;
  const texts = near?.readings ?? (within ? readings(spec, within) : []);
  const hint = `${prefix}-keys`;
  return (
    <div class="chart" data-standing={standing?.kind}>
      <div class="chart-picture" ref={host} style={props.height ? { height: `${props.height}px` } : {}}>
        <svg class="chart-under" width={size.width} height={size.height} aria-hidden="true">
          <SceneView shapes={scene.definitions} />
          <SceneView shapes={scene.under} />
        </svg>
        {spec.layers.some(isRaster) && <RasterView spec={spec} frame={frame} />}
        <svg
          ref={element}
          class="chart-over"
          width={size.width}
          height={size.height}
          role="application"
          aria-roledescription="chart"
          aria-label={spec.title}
          aria-describedby={hint}
          tabindex={0}
          {...on}
        >
          <rect width={size.width} height={size.height} fill="none" pointer-events="all" />
          <SceneView shapes={scene.over} />
          <Marks frame={frame} theme={theme} cursor={cursor} found={near} pin={props.pin ?? null} mark={props.mark ?? null} onAreas={spec.layers.some(isRaster)} />
          {box && <rect class="chart-box" {...box} />}
        </svg>
      </div>
      {standing && (
        // the page says it to readers of screens once, not every chart
        <p class="chart-standing" aria-hidden="true" style={{ left: `${frame.left + 8}px`, top: `${frame.top + 8}px`, maxWidth: `${Math.max(frame.width - 16, 120)}px` }}>
          {standing.words}
        </p>
      )}
      <div class={props.quiet ? "chart-foot" : "chart-foot chart-foot-readings"}>
        {!props.quiet && <Readings texts={texts} />}
        <Buttons title={spec.title} zoom={(factor) => setWindow(factor === null ? null : zoomBy(spec, frame.window, factor), "push")} />
      </div>
      <p id={hint} class="visually-hidden">
        Arrow keys move the cursor, with Shift in larger steps. Plus and minus zoom, 0 shows everything
        {props.onPick ? ", Enter pins the point" : ""}.
      </p>
      <Spoken text={[...texts.map(({ label, value }) => `${plainText(label)}: ${plainText(value)}`), props.spoken ?? ""].filter(Boolean).join("; ")} />
    </div>
  );
}

/** What is shown and the cursor: as the page keeps them, or the chart itself. */
function useKept(props: ChartViewProps) {
  const [ownWindow, setOwnWindow] = useState<Window | null>(null);
  const [ownCursor, setOwnCursor] = useState<Cursor | null>(null);
  return {
    window: (props.onWindow ? props.window : ownWindow) ?? homeWindow(props.spec),
    cursor: props.onCursor ? (props.cursor ?? null) : ownCursor,
    setWindow: props.onWindow ?? ((next: Window | null) => setOwnWindow(next)),
    setCursor: props.onCursor ?? ((next: Cursor | null) => setOwnCursor(next)),
  };
}

function Readings({ texts }: { readonly texts: ReturnType<typeof readings> }) {
  return (
    <dl class="chart-readings">
      {texts.map(({ label, value }) => (
        <div key={label}>
          <dt>
            <Label text={label} />
          </dt>
          <dd>
            <Label text={value} />
          </dd>
        </div>
      ))}
    </dl>
  );
}

function Buttons({ title, zoom }: { readonly title: string; readonly zoom: (factor: number | null) => void }) {
  return (
    <div class="chart-buttons" role="group" aria-label={`Zoom of: ${title}`}>
      <button type="button" onClick={() => zoom(1 / 1.5)} aria-label="Zoom in" title="Zoom in (+); Shift and drag for a box">
        +
      </button>
      <button type="button" onClick={() => zoom(1.5)} aria-label="Zoom out" title="Zoom out (−)">
        −
      </button>
      <button type="button" onClick={() => zoom(null)} title="Show everything (0, double click)">
        Reset
      </button>
    </div>
  );
}

interface MarksProps {
  readonly frame: Frame;
  readonly theme: Theme;
  readonly found: Found | null;
  readonly cursor: Cursor | null;
  readonly pin: Cursor | null;
  readonly mark: number | null;
  readonly onAreas: boolean;
}

/** Cross hairs of the cursor, the pinned point, and the marked value. */
function Marks({ frame, theme, cursor, found, pin, mark, onAreas }: MarksProps) {
  const over = onAreas ? "light" : theme;
  const { ink } = INK[over];
  const rim = onAreas ? INK.light.ground : "none";
  const at = (point: Cursor) => {
    const [x, y] = [frame.px(point.x), frame.py(point.y)];
    const inside = x >= frame.left && x <= frame.left + frame.width && y >= frame.top && y <= frame.top + frame.height;
    return inside ? { x, y } : undefined;
  };
  const [hair, pinned, ring] = [cursor && at(cursor), pin && at(pin), found?.at && at(found.at)];
  const across = mark === null ? Number.NaN : frame.px(mark);
  const marked = across >= frame.left && across <= frame.left + frame.width;
  return (
    <g class="chart-marks" aria-hidden="true">
      {marked && (
        <>
          <path d={`M${across} ${frame.top}v${frame.height}`} stroke={rim} stroke-opacity={0.6} stroke-width={5} />
          <path class="chart-mark" d={`M${across} ${frame.top}v${frame.height}`} stroke={lineStyle("decoupled-boundary", over).colour} stroke-width={2} />
        </>
      )}
      {hair && (
        <>
          <path d={cross(frame, hair)} stroke={rim} stroke-opacity={0.6} stroke-width={3} />
          <path d={cross(frame, hair)} stroke={ink} stroke-width={1} stroke-dasharray="3 2" />
        </>
      )}
      {ring && <circle class="chart-found" cx={ring.x} cy={ring.y} r={5} fill="none" stroke={ink} stroke-width={1.5} />}
      {pinned && <circle cx={pinned.x} cy={pinned.y} r={6} fill={INK.light.ground} stroke={lineStyle("decoupled-boundary", "light").colour} stroke-width={3} />}
    </g>
  );
}

function cross(frame: Frame, { x, y }: { x: number; y: number }): string {
  return `M${x} ${frame.top}v${frame.height}M${frame.left} ${y}h${frame.width}`;
}

/** How long a cursor rests before its values are read aloud, in milliseconds. */
const SPEECH_REST = 400;

function Spoken({ text }: { readonly text: string }) {
  const [spoken, setSpoken] = useState("");
  useEffect(() => {
    const timer = setTimeout(() => setSpoken(text), SPEECH_REST);
    return () => clearTimeout(timer);
  }, [text]);
  return (
    <p class="visually-hidden" aria-live="polite">
      {spoken}
    </p>
  );
}

/** The size of the element that holds the picture. */
function useSize(height: number | undefined) {
  const host = useRef<HTMLDivElement>(null);
  const [size, setSize] = useState<Size>(UNMEASURED);
  useLayoutEffect(() => {
    const node = host.current;
    if (!node || typeof ResizeObserver === "undefined") return;
    const measure = () => {
      const next = { width: Math.round(node.clientWidth), height: Math.round(height ?? node.clientHeight) };
      if (next.width < 2 || next.height < 2) return;
      setSize((size) => (size.width === next.width && size.height === next.height ? size : next));
    };
    const observer = new ResizeObserver(measure);
    observer.observe(node);
    measure();
    return () => observer.disconnect();
  }, [height]);
  return [host, size] as const;
}
