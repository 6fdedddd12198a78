/** Eigenvalues over the position of the contact, or over any key. */

import { useMemo } from "preact/hooks";
import type { Cursor } from "../../chart/interaction";
import { brief } from "../../chart/readout";
import { type Keep, useView } from "../../state/store";
import { withFields } from "../../state/view";
import { useApp } from "../../ui/app";
import { ErrorNote } from "../../ui/ErrorNote";
import { Busy } from "./Busy";
import { swingOf } from "./body";
import { type Locus, frequencySpec, growthSpec, homePlace, locusVariables, modesAt, planeSpec, readLocus, rowAt, valueNear } from "./locus";
import { ModeTable } from "./ModeTable";
import { Place } from "./Place";
import { ShapeView } from "./ShapeView";
import { StudyChart } from "./StudyChart";
import { numberField, pickedMode, placed, readWindow, withRange } from "./state";
import { type StudyAnalysis, isOverPosition } from "./study";
import { useArrays } from "./useArrays";
import { shapeOf, useShapes } from "./useShapes";
import { ZoneTable } from "./ZoneTable";

const PLANE = { x: "growth", y: "frequency" } as const;

export function LocusView({ analysis }: { readonly analysis: StudyAnalysis }) {
  const { store } = useApp();
  const view = useView(store);
  const live = useArrays(analysis.name, locusVariables(analysis));
  const locus = useMemo(() => (live.arrays ? readLocus(analysis, live.arrays) : null), [analysis, live.arrays]);
  if (!locus) return <Busy live={live} words="Reading the locus…" />;
  const at = numberField(view, "at") ?? homePlace(locus);
  return <Drawn analysis={analysis} locus={locus} at={at} />;
}

interface DrawnProps {
  readonly analysis: StudyAnalysis;
  readonly locus: Locus;
  readonly at: number;
}

function Drawn({ analysis, locus, at }: DrawnProps) {
  const { store } = useApp();
  const view = useView(store);
  const { name } = analysis;
  const frequencies = useMemo(() => frequencySpec(locus, name), [locus, name]);
  const growth = useMemo(() => growthSpec(locus, name), [locus, name]);
  const row = rowAt(locus, at);
  const plane = useMemo(() => planeSpec(locus, name, locus.along[row] as number), [locus, name, row]);
  const [first, last] = [locus.along[0] as number, locus.along.at(-1) as number];
  const range = [Math.min(first, last), Math.max(first, last)] as const;
  const move = (value: number, keep: Keep = "push") => {
    const within = Math.min(Math.max(value, range[0]), range[1]);
    store.update((view) => withFields(view, { at: String(within), mode: undefined }), keep);
  };
  const onPick = (cursor: Cursor) => move(placed(cursor.x, range));
  const onPlane = ({ x, y }: Cursor) => {
    const window = readWindow(view, plane, PLANE);
    move(valueNear(locus, x, y, window.x[1] - window.x[0], window.y[1] - window.y[0]));
  };
  const everything = () => store.update((view) => withRange(view, "growth", allGrowth(locus)));
  return (
    <>
      <Place axis={locus.axis} unit={locus.unit} at={at} range={range} step={(range[1] - range[0]) / 1000} onMove={(value, keep) => move(keep ? placed(value, range) : value, keep)} />
      <div class="study-grid locus-charts">
        <div>
          <StudyChart spec={frequencies} names={{ x: "along", y: "frequency" }} height={380} mark={at} onPick={onPick} />
          <StudyChart spec={growth} names={{ x: "along", y: "rate" }} height={260} mark={at} onPick={onPick} />
        </div>
        <StudyChart
          spec={plane}
          names={PLANE}
          height={700}
          onPick={onPlane}
          tools={
            <button type="button" onClick={everything}>
              All growth rates
            </button>
          }
        />
      </div>
      <ZoneTable analysis={analysis.name} zones={locus.zones} unit={locus.unit} at={at} onMove={move} />
      <ModesHere analysis={analysis} locus={locus} at={at} />
    </>
  );
}

function allGrowth(locus: Locus): readonly [number, number] | undefined {
  const [low, high] = locus.growth.reduce(([low, high], value) => [value < low ? value : low, value > high ? value : high], [0, 0]);
  return low < high ? [low - 0.02 * (high - low), high + 0.05 * (high - low)] : undefined;
}

/** The modes at the place, with their shapes where the study can tell them. */
function ModesHere({ analysis, locus, at }: DrawnProps) {
  const { store } = useApp();
  const view = useView(store);
  // a place is a position of the contact: of other keys the server knows no shapes
  const hasShapes = analysis.kind === "locus" && isOverPosition(analysis);
  const { shapes, error, busy, cancel } = useShapes(analysis.name, hasShapes ? at : null, locus.branches);
  const here = shapes?.at === at ? shapes : null;
  const modes = here
    ? here.eigenvalues.map(([growth, omega]) => ({ growth, frequency: omega / (2 * Math.PI), verdict: undefined }))
    : modesAt(locus, at);
  const fastest = modes.reduce((best, mode, index) => (mode.growth > (modes[best]?.growth ?? Number.NEGATIVE_INFINITY) ? index : best), 0);
  const mode = pickedMode(view, modes.length, fastest);
  const swing = useMemo(() => {
    const shape = shapes ? shapeOf(shapes, mode) : null;
    return shapes && shape && shape.length > 0 ? swingOf(shapes.body, shape, true) : null;
  }, [shapes, mode]);
  const note = here ? "" : ", of the nearest stored one";
  return (
    <div class="shape-columns">
      <ModeTable
        title={`Eigenvalues at ${brief(at, 6)}${locus.unit === "1" ? "" : ` ${locus.unit}`}${note}`}
        modes={modes}
        picked={mode}
        onPick={(index) => store.update((view) => withFields(view, { mode: String(index + 1) }))}
        dataKey={here ? "shapes" : "locus"}
      />
      <div class="shape-side">
        <ErrorNote error={error} />
        {!hasShapes && <p>Shapes are computed for loci over the position of the contact.</p>}
        {busy && (
          <p role="status">
            Computing the shapes…{" "}
            <button type="button" onClick={cancel}>
              Cancel
            </button>
          </p>
        )}
        {shapes && swing && (
          <div class={here ? "" : "stale"}>
            <ShapeView title={`Mode ${mode + 1} of ${analysis.name}`} body={shapes.body} swing={swing} motion={{ frequency: modes[mode]?.frequency ?? null, growth: modes[mode]?.growth ?? null }} unit="" />
          </div>
        )}
      </div>
    </div>
  );
}
