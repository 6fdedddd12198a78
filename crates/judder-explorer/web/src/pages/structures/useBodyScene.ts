/** The 3-D picture on a canvas, with its own clock; three is loaded when the first shape is shown. */

import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import type { Theme } from "../../chart/palette";
import type { Body, Swing } from "./body";
import type { Marks } from "./marks";
import type { BodyScene, Still } from "./scene3d";

/** Seconds of one swing on the page. */
export const PERIOD = 2;
/** More pictures a second would only heat a software renderer. */
const EVERY = 1000 / 30;
/** How often the phase is told to the page, in milliseconds. */
const TOLD = 100;

interface Asked {
  readonly body: Body;
  readonly swing: Swing;
  readonly marks: Marks | null;
  readonly theme: Theme;
  readonly still: Still;
  readonly playing: boolean;
  readonly onPhase: (phase: number) => void;
}

type SceneState = "loading" | "drawn" | "missing";

export interface LiveScene {
  readonly canvas: { current: HTMLCanvasElement | null };
  readonly state: SceneState;
  /** The picture as it is now, as the address of a PNG. */
  readonly picture: () => string | null;
}

export function useBodyScene(asked: Asked): LiveScene {
  const canvas = useRef<HTMLCanvasElement>(null);
  const newest = useRef(asked);
  newest.current = asked;
  const phase = useRef(asked.still.phase);
  const { scene, state } = useScene(canvas);
  const draw = () => scene.current?.draw({ ...newest.current.still, phase: phase.current });
  useFit(canvas, state, (width, height) => {
    scene.current?.resize(width, height);
    draw();
  });

  useEffect(() => {
    scene.current?.show(asked.body, asked.swing, asked.theme, asked.marks);
    draw();
  }, [state, asked.body, asked.swing, asked.marks, asked.theme]);

  const { look, zoom, factor } = asked.still;
  useEffect(() => {
    if (!asked.playing) phase.current = asked.still.phase;
    draw();
  }, [look.azimuth, look.elevation, zoom, factor, asked.still.phase, asked.playing]);

  useClock(asked.playing, phase, draw, (phase) => newest.current.onPhase(phase));
  const picture = () => {
    const node = canvas.current;
    if (!node) return null;
    // the picture is kept only until the browser has shown it
    draw();
    return node.toDataURL("image/png");
  };
  return { canvas, state, picture };
}

/** The scene on the canvas, from when three has come until the canvas goes. */
function useScene(canvas: { readonly current: HTMLCanvasElement | null }) {
  const scene = useRef<BodyScene | null>(null);
  const [state, setState] = useState<SceneState>("loading");
  useEffect(() => {
    let wanted = true;
    import("./scene3d").then(
      ({ BodyScene }) => {
        if (!wanted || !canvas.current) return;
        try {
          scene.current = new BodyScene(canvas.current);
          setState("drawn");
        } catch {
          setState("missing");
        }
      },
      () => setState("missing"),
    );
    return () => {
      wanted = false;
      scene.current?.close();
      scene.current = null;
    };
  }, []);
  return { scene, state };
}

/** Tells the size of the canvas as it changes. */
function useFit(canvas: { readonly current: HTMLCanvasElement | null }, state: SceneState, onSize: (width: number, height: number) => void): void {
  useLayoutEffect(() => {
    const node = canvas.current;
    if (state !== "drawn" || !node) return;
    const fit = () => {
      const { clientWidth, clientHeight } = node;
      if (clientWidth >= 2 && clientHeight >= 2) onSize(clientWidth, clientHeight);
    };
    const observer = new ResizeObserver(fit);
    observer.observe(node);
    fit();
    return () => observer.disconnect();
  }, [state]);
}

/** Moves the phase on while it plays, draws it, and tells it now and then. */
function useClock(playing: boolean, phase: { current: number }, draw: () => void, onPhase: (phase: number) => void): void {
  useEffect(() => {
    if (!playing) return;
    let [frame, last, told] = [0, performance.now(), 0];
    const step = (now: number) => {
      frame = requestAnimationFrame(step);
      if (now - last < EVERY) return;
      phase.current = (phase.current + (2 * Math.PI * (now - last)) / (1000 * PERIOD)) % (2 * Math.PI);
      last = now;
      draw();
      if (now - told < TOLD) return;
      told = now;
      onPhase(phase.current);
    };
    frame = requestAnimationFrame(step);
    return () => cancelAnimationFrame(frame);
  }, [playing]);
}
