/** The map of the view, asked for as it changes. */

import { useEffect, useRef, useState } from "preact/hooks";
import { Latest } from "../../wire/latest";
import { type RequestError, asRequestError, isAbort, postFrames, slot } from "../../wire/request";
import { type MapPicture, type MapRequest, mapAnalysis, withFrame } from "./picture";

export interface Progress {
  readonly done: number;
  readonly of: number;
}

export interface LiveMap {
  readonly picture: MapPicture | null;
  /** Whether something newer than the picture is being computed. */
  readonly busy: boolean;
  /** How far the contact law is, which some cases compute before their first map. */
  readonly progress: Progress | null;
  readonly error: RequestError | null;
}

export function useMap(request: MapRequest): LiveMap {
  const [picture, setPicture] = useState<MapPicture | null>(null);
  const [busy, setBusy] = useState(false);
  const [progress, setProgress] = useState<Progress | null>(null);
  const [error, setError] = useState<RequestError | null>(null);
  const latest = useRef(new Latest());
  const newest = useRef<MapPicture | null>(null);
  const text = JSON.stringify(request);
  useEffect(() => {
    const request = JSON.parse(text) as MapRequest;
    const body = {
      set: request.set,
      analysis: mapAnalysis(request, false),
      boundaries: request.boundaries,
      slot: slot("map"),
    };
    latest.current.submit(async (signal, shown) => {
      setBusy(true);
      setProgress(null);
      try {
        for await (const frame of postFrames("/api/map", body, signal)) {
          if (frame.kind === "progress") {
            setProgress({ done: Number(frame.header["done"]), of: Number(frame.header["of"]) });
            continue;
          }
          newest.current = withFrame(newest.current, frame, request);
          setProgress(null);
          setPicture(newest.current);
          setError(null);
          shown();
        }
        setBusy(false);
      } catch (failure) {
        if (isAbort(failure)) return;
        // the last good picture stays
        setError(asRequestError(failure));
        setBusy(false);
      }
    });
  }, [text]);
  useEffect(() => () => latest.current.stop(), []);
  return { picture, busy, progress, error };
}
