/** Pointer, wheel and keys of a chart, as changes of its window and its cursor. */

import { useEffect, useRef, useState } from "preact/hooks";
import { type Frame, valuesAt } from "./frame";
import { type Range, type Window, fraction, moved, part, shrink, stretch, zoomed } from "./scale";
import type { ChartSpec } from "./spec";

export interface Cursor {
  readonly x: number;
  readonly y: number;
}

/** `drag` while it moves, `push` when it rests: as the store of views takes it. */
export type Phase = "drag" | "push";

export interface Handlers {
  readonly onWindow: (window: Window | null, phase: Phase) => void;
  readonly onCursor: (cursor: Cursor | null, by: "pointer" | "keyboard") => void;
  readonly onPick: ((cursor: Cursor) => void) | undefined;
  /** Whether the wheel is the page's, and zooms with Ctrl alone. */
  readonly scrolls: boolean;
}

interface Box {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

const ZOOM_STEP = 1.5;
/** A press that moves by less is a click. */
const CLICK = 4;
/** A click picks when no second one has come within so many milliseconds. */
const DOUBLE_CLICK = 220;
/** A wheel that rests for so long has ended its zoom, in milliseconds. */
const WHEEL_REST = 300;

export function zoomBy(spec: ChartSpec, window: Window, factor: number, x = 0.5, y = 0.5): Window {
  return { x: zoomed(spec.x.scale, window.x, factor, x), y: zoomed(spec.y.scale, window.y, factor, y) };
}

function moveBy(spec: ChartSpec, window: Window, x: number, y: number): Window {
  return { x: moved(spec.x.scale, window.x, x), y: moved(spec.y.scale, window.y, y) };
}

/** Where the cursor goes by steps of the axes (shares of the plot). */
function stepped(spec: ChartSpec, frame: Frame, cursor: Cursor | null, x: number, y: number): Cursor {
  const step = (axis: "x" | "y", share: number) => {
    const { scale } = spec[axis];
    const range = frame.window[axis];
    const [first, last] = [stretch(scale, range[0]), stretch(scale, range[1])];
    const now = cursor ? fraction(scale, range, cursor[axis]) : 0.5;
    const next = Math.min(Math.max((Number.isNaN(now) ? 0.5 : now) + share, 0), 1);
    return shrink(scale, first + next * (last - first));
  };
  return { x: step("x", x), y: step("y", y) };
}

const ARROWS: Record<string, readonly [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

interface Press {
  readonly id: number;
  readonly x: number;
  readonly y: number;
  readonly window: Window;
  readonly boxing: boolean;
  moved: boolean;
}

/** What handlers that outlive a picture read. */
interface Current {
  readonly spec: ChartSpec;
  readonly frame: Frame;
  readonly cursor: Cursor | null;
  readonly handlers: Handlers;
}

/** Everything that the element of a chart needs. */
export function useInteraction(spec: ChartSpec, frame: Frame, cursor: Cursor | null, handlers: Handlers) {
  const element = useRef<SVGSVGElement>(null);
  const current = useRef<Current>({ spec, frame, cursor, handlers });
  current.current = { spec, frame, cursor, handlers };
  const picking = useRef<ReturnType<typeof setTimeout> | undefined>(undefined);
  useWheel(element, current);
  const { box, on } = usePointer(element, current.current, (point) => {
    clearTimeout(picking.current);
    picking.current = setTimeout(() => current.current.handlers.onPick?.(point), DOUBLE_CLICK);
  });
  const onKeyDown = (event: KeyboardEvent) => {
    if (!event.ctrlKey && !event.metaKey && !event.altKey && pressed(current.current, event.key, event.shiftKey)) event.preventDefault();
  };
  const onDblClick = () => {
    clearTimeout(picking.current);
    handlers.onWindow(null, "push");
  };
  return { element, box, on: { ...on, onKeyDown, onDblClick } };
}

/** Hovering, clicks, drags and boxes. */
function usePointer(element: { current: SVGSVGElement | null }, { spec, frame, handlers }: Current, onClick: (point: Cursor) => void) {
  const press = useRef<Press | null>(null);
  const [box, setBox] = useState<Box | null>(null);
  const place = (event: PointerEvent) => {
    const bounds = element.current?.getBoundingClientRect();
    return { x: event.clientX - (bounds?.left ?? 0), y: event.clientY - (bounds?.top ?? 0) };
  };
  const inside = ({ x, y }: { x: number; y: number }) =>
    x >= frame.left && x <= frame.left + frame.width && y >= frame.top && y <= frame.top + frame.height;
  const dragged = (held: Press, at: { x: number; y: number }) =>
    moveBy(spec, held.window, (held.x - at.x) / frame.width, (at.y - held.y) / frame.height);

  const onPointerDown = (event: PointerEvent) => {
    const at = place(event);
    if (event.button !== 0 || !inside(at)) return;
    element.current?.setPointerCapture(event.pointerId);
    press.current = { id: event.pointerId, ...at, window: frame.window, boxing: event.shiftKey, moved: false };
  };
  const onPointerMove = (event: PointerEvent) => {
    const at = place(event);
    const held = press.current;
    if (!held) return inside(at) ? handlers.onCursor(valuesAt(spec, frame, at.x, at.y), "pointer") : undefined;
    if (held.id !== event.pointerId) return;
    held.moved ||= Math.hypot(at.x - held.x, at.y - held.y) > CLICK;
    if (!held.moved) return;
    if (held.boxing) setBox(boxOf(held, at));
    else handlers.onWindow(dragged(held, at), "drag");
  };
  const onPointerUp = (event: PointerEvent) => {
    const held = press.current;
    if (!held || held.id !== event.pointerId) return;
    press.current = null;
    setBox(null);
    const at = place(event);
    if (!held.moved) onClick(valuesAt(spec, frame, at.x, at.y));
    else handlers.onWindow(held.boxing ? windowOfBox(spec, frame, boxOf(held, at)) : dragged(held, at), "push");
  };
  const onPointerCancel = () => {
    const held = press.current;
    press.current = null;
    setBox(null);
    if (held?.moved && !held.boxing) handlers.onWindow(held.window, "push");
  };
  return { box, on: { onPointerDown, onPointerMove, onPointerUp, onPointerCancel } };
}

/** What a key does; whether it does anything. */
function pressed({ spec, frame, cursor, handlers }: Current, key: string, large: boolean): boolean {
  const arrow = ARROWS[key];
  const share = large ? 0.1 : 0.01;
  if (arrow) handlers.onCursor(stepped(spec, frame, cursor, arrow[0] * share, arrow[1] * share), "keyboard");
  else if (key === "+" || key === "=") handlers.onWindow(zoomAtCursor(spec, frame, cursor, 1 / ZOOM_STEP), "push");
  else if (key === "-") handlers.onWindow(zoomAtCursor(spec, frame, cursor, ZOOM_STEP), "push");
  else if (key === "0") handlers.onWindow(null, "push");
  else if (key === "Enter" && cursor && handlers.onPick) handlers.onPick(cursor);
  else return false;
  return true;
}

function zoomAtCursor(spec: ChartSpec, frame: Frame, cursor: Cursor | null, factor: number): Window {
  const about = (axis: "x" | "y") => {
    const share = cursor ? fraction(spec[axis].scale, frame.window[axis], cursor[axis]) : 0.5;
    return share >= 0 && share <= 1 ? share : 0.5;
  };
  return zoomBy(spec, frame.window, factor, about("x"), about("y"));
}

function boxOf(from: { x: number; y: number }, to: { x: number; y: number }): Box {
  return {
    x: Math.min(from.x, to.x),
    y: Math.min(from.y, to.y),
    width: Math.abs(to.x - from.x),
    height: Math.abs(to.y - from.y),
  };
}

function windowOfBox(spec: ChartSpec, frame: Frame, box: Box): Window {
  const across = (x: number) => Math.min(Math.max((x - frame.left) / frame.width, 0), 1);
  const up = (y: number) => Math.min(Math.max(1 - (y - frame.top) / frame.height, 0), 1);
  return {
    x: part(spec.x.scale, frame.window.x, across(box.x), across(box.x + box.width)),
    y: part(spec.y.scale, frame.window.y, up(box.y), up(box.y + box.height)),
  };
}

/** Whether two windows show the same but for rounding. */
function isAbout(one: Window, other: Window): boolean {
  const near = (a: Range, b: Range) => Math.abs(a[0] - b[0]) + Math.abs(a[1] - b[1]) <= 1e-6 * Math.abs(b[1] - b[0]);
  return near(one.x, other.x) && near(one.y, other.y);
}

/** Wheels are listened to by hand: only a listener that is not passive can keep the page from scrolling. */
function useWheel(element: { current: SVGSVGElement | null }, current: { readonly current: Current }): void {
  useEffect(() => {
    const node = element.current;
    if (!node) return;
    let rest: ReturnType<typeof setTimeout> | undefined;
    let latest: Window | undefined;
    const onWheel = (event: WheelEvent) => {
      const { spec, frame, handlers } = current.current;
      if (handlers.scrolls && !event.ctrlKey && !event.metaKey) return;
      const bounds = node.getBoundingClientRect();
      const x = (event.clientX - bounds.left - frame.left) / frame.width;
      const y = 1 - (event.clientY - bounds.top - frame.top) / frame.height;
      if (x < 0 || x > 1 || y < 0 || y > 1) return;
      event.preventDefault();
      const lines = event.deltaMode === 1 ? 30 : 1;
      const factor = Math.exp(Math.min(Math.max(event.deltaY * lines, -240), 240) * 0.0018);
      // turns come faster than pictures
      latest = zoomBy(spec, latest ?? frame.window, factor, x, y);
      handlers.onWindow(latest, "drag");
      clearTimeout(rest);
      rest = setTimeout(() => {
        const now = current.current;
        // what a report has shown since then, as everything again, stays; the page rounds what it shows
        const stays = now.handlers.scrolls && latest && !isAbout(now.frame.window, latest);
        if (latest && !stays) now.handlers.onWindow(latest, "push");
        latest = undefined;
      }, WHEEL_REST);
    };
    node.addEventListener("wheel", onWheel, { passive: false });
    return () => {
      clearTimeout(rest);
      node.removeEventListener("wheel", onWheel);
    };
  }, []);
}
