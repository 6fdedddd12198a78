/** The map of the view, asked for as it changes. */

import { useEffect, useRef, useState } from "preact/hooks";
import { type Progress, progressOf } from "../../wire/follow";
import { Latest, type Work } from "../../wire/latest";
import { type RequestError, asRequestError, isAbort, postFrames, slot } from "../../wire/request";
import { type MapPicture, type MapRequest, SKETCH, mapAnalysis, withFrame } from "./picture";

export interface LiveMap {
  readonly picture: MapPicture | null;
  /** Whether something newer than the picture is being computed. */
  readonly busy: boolean;
  /** How far the contact law is, which some cases compute before their first map. */
  readonly progress: Progress | null;
  readonly error: RequestError | null;
}

/** Values that follow one another within this time, in milliseconds, are a drag. */
const DRAG = 120;

/**
 * While values are dragged only sketches are asked for: the exact map of a value that has passed would keep the processor from the next.
 * The value on which the drag rests gets its exact map.
 */
export function useMap(request: MapRequest): LiveMap {
  const [live, setLive] = useState<LiveMap>({ picture: null, busy: false, progress: null, error: null });
  const latest = useRef(new Latest());
  const newest = useRef<MapPicture | null>(null);
  const moved = useRef(Number.NEGATIVE_INFINITY);
  const text = JSON.stringify(request);
  useEffect(() => {
    const request = JSON.parse(text) as MapRequest;
    const change = (part: Partial<LiveMap>) => setLive((last) => ({ ...last, ...part }));
    const ask = (sketch: boolean): Work => (signal, shown) => follow(request, sketch, newest, signal, shown, change);
    const dragged = performance.now() - moved.current < DRAG;
    moved.current = performance.now();
    latest.current.submit(ask(dragged));
    if (!dragged) return;
    const timer = setTimeout(() => latest.current.submit(ask(false)), DRAG);
    return () => clearTimeout(timer);
  }, [text]);
  useEffect(() => () => latest.current.stop(), []);
  return live;
}

/** Sends one request and tells what its frames bring. */
async function follow(
  request: MapRequest,
  sketch: boolean,
  newest: { current: MapPicture | null },
  signal: AbortSignal,
  shown: () => void,
  change: (part: Partial<LiveMap>) => void,
): Promise<void> {
  const analysis = mapAnalysis(request, false, sketch ? SKETCH : undefined);
  const body = { set: request.set, analysis, boundaries: sketch ? [] : request.boundaries, slot: slot("map") };
  change({ busy: true, progress: null });
  try {
    for await (const frame of postFrames("/api/map", body, signal)) {
      if (frame.kind === "progress") {
        change({ progress: progressOf(frame) });
        continue;
      }
      // the server's first idea of a sketch is too rough to be of use
      if (sketch && frame.header["stage"] === "coarse") continue;
      newest.current = withFrame(newest.current, frame, request, sketch);
      change({ picture: newest.current, progress: null, error: null });
      shown();
    }
    if (!sketch) change({ busy: false });
  } catch (failure) {
    // the last good picture stays
    if (!isAbort(failure)) change({ busy: false, error: asRequestError(failure) });
  }
}
