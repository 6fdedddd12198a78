/** Pointer, wheel and keys that turn the picture. */

import { useRef } from "preact/hooks";
import type { Keep } from "../../state/store";
import type { Look } from "./state";

/** Degrees of a press of an arrow key. */
const STEP = 5;

export function useOrbit(look: Look, turn: (look: Look, keep: Keep) => void, zoom: (by: number) => void, home: () => void) {
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
