/** The map page: stability over two keys, live. */

import { useMemo } from "preact/hooks";
import { Chart } from "../../chart/Chart";
import { isShown } from "../../chart/readout";
import { type Window, rangeOf } from "../../chart/scale";
import { BOUNDARIES } from "../../state/fields";
import { useView } from "../../state/store";
import { options } from "../../state/view";
import { useApp } from "../../ui/app";
import { ErrorNote, ofBefore, unlessSaid } from "../../ui/ErrorNote";
import { useCaseFile } from "../../ui/files";
import { Page } from "../../ui/Page";
import { leading } from "../../ui/PointValues";
import { type Facts, type Standing, StandingContext, useStanding } from "../../ui/standing";
import { usePoint } from "../../ui/usePoint";
import { type Key, type KeyAxis, fetchCaseFile } from "../../wire/api";
import type { RequestError } from "../../wire/request";
import { AxisPicker } from "./AxisPicker";
import { CursorPanel } from "./CursorPanel";
import { MapSwitches } from "./MapSwitches";
import { MapWarnings, useMapWarnings } from "./MapWarnings";
import { moves } from "./moves";
import { type MapPicture, mapAnalysis, planeOf } from "./picture";
import { mapSpec } from "./spec";
import { optionsAt, rangeOfAxis, readMap } from "./state";
import { criticalAnalysis, useCritical } from "./useCritical";
import { type LiveMap, useMap } from "./useMap";
import "./map.css";

export function MapPage() {
  const { session, store, keys, error: refused } = useApp();
  const view = useView(store);
  const state = useMemo(() => readMap(view, session, keys), [view, session, keys]);
  const [x, y] = [keys.get(state.x.key) as Key, keys.get(state.y.key) as Key];
  const set = options(view);
  const boundaries = BOUNDARIES.filter((name) => state.show.includes(name));
  const live = useMap({ set, x: state.x, y: state.y, boundaries });
  const picture = live.picture?.plane === planeOf(state) ? live.picture : null;
  const analysis = criticalAnalysis(state.x, state.y);
  const { critical, error: criticalError } = useCritical(set, state.show.includes("critical") ? analysis : null);

  const window = useWindow(state.x, state.y, x, y, picture);
  const spec = useMemo(
    () => mapSpec({ state, x, y, window, picture, critical }),
    [picture, critical, x, y, window, state.x, state.y, state.show.join(), state.marks.join()],
  );

  const shown = state.pin ?? state.cursor;
  const isOutside = shown !== null && window !== null && !isShown(spec, window, shown);
  const at = shown ? optionsAt(view, state, keys, shown) : null;
  const point = usePoint(at ? options({ ...view, set: at }) : null);
  const move = moves({ store, session, state, x, y, window });
  const facts = factsOf(picture, live, set, refused);
  const standing = useStanding(facts, picture);
  const told = useMapWarnings(set, state, facts.isCurrent && picture?.stage === "exact");

  useMapCaseFile();
  const all = session.keys;
  return (
    <Page title="Stability map" hiddenKeys={[x.path, y.path]}>
      <div class="map-layout">
        <div class="map-main">
          <div class="map-tools">
            <AxisPicker name="x" error={live.error} axis={state.x} keys={all} taken={y.path} onKey={move.onKey("x")} onAxis={move.onAxis("x")} />
            <AxisPicker name="y" error={live.error} axis={state.y} keys={all} taken={x.path} onKey={move.onKey("y")} onAxis={move.onAxis("y")} />
            <MapSwitches state={state} hasCritical={analysis !== null} onShow={move.onShow} onMarks={move.onMarks} />
          </div>
          <ErrorNote error={unlessSaid(live.error ?? criticalError, refused)} />
          <MapWarnings told={told} />
          <div class="map-chart" data-stage={picture?.stage ?? "none"} data-set={picture?.options} data-busy={live.busy} data-refused={standing?.kind === "refused"}>
            <StandingContext.Provider value={standing}>
              <Chart
                spec={spec}
                window={window}
                onWindow={move.onWindow}
                cursor={state.cursor}
                onCursor={move.onCursor}
                onPick={move.onPick}
                pin={state.pin}
                quiet
                spoken={point.point ? spokenPoint(point.point.point) : ""}
              />
            </StandingContext.Provider>
          </div>
          <p class="map-status" role="status">
            {/* what stands over the map is read aloud here, and not shown twice */}
            <span class={standing ? "visually-hidden" : ""}>{status(picture, live, standing)}</span>
          </p>
        </div>
        <CursorPanel state={state} place={shown} x={x} y={y} live={point} set={at} isOutside={isOutside} />
      </div>
    </Page>
  );
}

/** The picture belongs to the present values, or says that it does not. */
function factsOf(picture: MapPicture | null, { busy, progress, error }: LiveMap, set: readonly string[], refused: RequestError | null): Facts {
  const isCurrent = picture?.options === JSON.stringify(set);
  // values that are refused are refused for every map, also while the newest answer is on its way
  const wrong = error ?? refused;
  return { has: picture !== null, isCurrent: isCurrent && !wrong, busy: busy && !refused, what: progress ? "the contact law" : "the map", progress, error: wrong };
}

function status(picture: MapPicture | null, { busy, error }: LiveMap, standing: Standing | null): string {
  if (standing?.kind === "refused" && picture && error) return ofBefore(error);
  if (standing) return standing.words;
  if (!picture) return busy ? "Computing…" : "";
  const unresolved = picture.unresolved > 0 ? ` ${picture.unresolved} points are unresolved.` : "";
  const open = picture.withinLaw?.filter(Boolean).length ?? 0;
  const marginal = open > 0 ? ` At ${open} of them the errors of the contact law decide, not steady sliding.` : "";
  return (picture.stage === "coarse" ? "Coarse map." : `${picture.x.length} × ${picture.y.length} points.`) + unresolved + marginal;
}

function spokenPoint(point: Parameters<typeof leading>[0]): string {
  const growth = Number(point.growth_rate.toPrecision(3));
  return `${point.verdict}, ${point.mechanism ?? ""}, growth rate ${growth}, frequency ${Number(Math.abs(leading(point)[1]).toPrecision(3))}`;
}

/** The window that the axes ask for; where their ends have units that only the server reads, that of the last map. */
function useWindow(xAxis: KeyAxis, yAxis: KeyAxis, x: Key, y: Key, picture: MapPicture | null): Window | null {
  return useMemo(() => {
    const xRange = rangeOfAxis(xAxis, x) ?? (picture ? rangeOf(xAxis.scale, [picture.x]) : null);
    const yRange = rangeOfAxis(yAxis, y) ?? (picture ? rangeOf(yAxis.scale, [picture.y]) : null);
    return xRange && yRange ? { x: xRange, y: yRange } : null;
  }, [xAxis.key, xAxis.from, xAxis.to, xAxis.scale, yAxis.key, yAxis.from, yAxis.to, yAxis.scale, x, y, picture?.x, picture?.y]);
}

/** The exported case holds the point that is shown, and the map about it. */
function useMapCaseFile(): void {
  const { session, store, keys } = useApp();
  useCaseFile(() => {
    const view = store.view;
    const state = readMap(view, session, keys);
    const place = state.pin ?? state.cursor;
    const set = place ? optionsAt(view, state, keys, place) : view.set;
    const boundaries = BOUNDARIES.some((name) => state.show.includes(name));
    return { text: fetchCaseFile(options({ ...view, set }), mapAnalysis(state, boundaries)) };
  });
}
