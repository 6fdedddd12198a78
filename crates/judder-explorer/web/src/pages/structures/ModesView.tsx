/** Modes at rest, and eigenvalues of a region: a table, the complex plane, shapes in space where they are stored, and what makes them grow. */

import { useMemo } from "preact/hooks";
import type { ChartSpec } from "../../chart/spec";
import { useView } from "../../state/store";
import { withFields } from "../../state/view";
import { useApp } from "../../ui/app";
import { ErrorNote } from "../../ui/ErrorNote";
import { Busy } from "./Busy";
import { swingOf } from "./body";
import { Completeness } from "./Completeness";
import { GenericCharts } from "./GenericView";
import { GrowthPanel } from "./GrowthPanel";
import { ModeTable } from "./ModeTable";
import { ShapeView } from "./ShapeView";
import { StudyChart } from "./StudyChart";
import { pickedMode } from "./state";
import { type StudyAnalysis, variable } from "./study";
import { type Arrays, numbers, useArrays } from "./useArrays";
import { BODY, SHAPE, hasShapes, useBody } from "./useBody";
import { verdictOf, verdictsOf } from "./verdicts";

interface ModeNumbers {
  readonly frequency: number;
  readonly growth: number | null;
  readonly dampingRatio?: number | undefined;
  readonly verdict?: string | undefined;
}

/** The modes of an analysis: of eigenvalues, or of natural frequencies alone. */
function readModes(arrays: Arrays): readonly ModeNumbers[] {
  const pairs = numbers(arrays, "eigenvalue");
  const [verdicts, dampingRatios] = [verdictsOf(arrays), numbers(arrays, "damping_ratio")];
  if (pairs.length > 0) {
    return Array.from({ length: pairs.length / 2 }, (_, k) => ({
      growth: pairs[2 * k] as number,
      frequency: (pairs[2 * k + 1] as number) / (2 * Math.PI),
      dampingRatio: dampingRatios[k],
      verdict: verdicts[k],
    }));
  }
  return Array.from(numbers(arrays, "frequency"), (frequency) => ({ frequency, growth: null }));
}

const TABLE = ["eigenvalue", "frequency", "verdict", "damping_ratio"];

export function ModesView({ analysis }: { readonly analysis: StudyAnalysis }) {
  const { store } = useApp();
  const view = useView(store);
  const own = TABLE.filter((name) => variable(analysis, name));
  const live = useArrays(analysis.name, own);
  const modes = useMemo(() => (live.arrays ? readModes(live.arrays) : []), [live.arrays]);
  const plane = useMemo(() => planeOf(analysis.name, modes), [analysis.name, modes]);
  if (!live.arrays) return <Busy live={live} words="Reading the modes…" />;
  const mode = pickedMode(view, modes.length);
  const rates = { frequency: modes[mode]?.frequency ?? null, growth: modes[mode]?.growth ?? null };
  return (
    <>
      <Completeness analysis={analysis} />
      <div class="shape-columns">
        <ModeTable
          title={modes.length === 1 ? "One mode" : `${modes.length} modes`}
          modes={modes}
          picked={mode}
          onPick={(index) => store.update((view) => withFields(view, { mode: String(index + 1) }))}
          dataKey={analysis.name}
        />
        <div class="shape-side">
          {hasShapes(analysis) ? (
            <StoredShape analysis={analysis} mode={mode} motion={rates} />
          ) : (
            <p>No shapes are stored: the study does not say where its freedoms lie.</p>
          )}
          <GrowthPanel analysis={analysis} mode={mode + 1} />
          {plane && <StudyChart spec={plane} names={{ x: "growth", y: "frequency" }} height={360} />}
        </div>
      </div>
      <GenericCharts analysis={analysis} without={[...TABLE, ...BODY, SHAPE, "mode"]} />
    </>
  );
}

function planeOf(name: string, modes: readonly ModeNumbers[]): ChartSpec | null {
  if (!modes.some((mode) => mode.growth !== null)) return null;
  const some = (unstable: boolean) => {
    const kept = modes.filter((mode) => (verdictOf(mode.growth ?? 0, mode.verdict) === "unstable") === unstable);
    return { x: kept.map((mode) => mode.growth ?? 0), y: kept.map((mode) => mode.frequency) };
  };
  return {
    title: `Complex plane of ${name}`,
    x: { label: "Growth rate Re $λ$ (s^{−1})", scale: "linear" },
    y: { label: "Frequency Im $λ$/2π (Hz)", scale: "linear" },
    layers: [
      { kind: "rule", label: "", across: "x", at: 0, role: "full-boundary" },
      { kind: "points", label: "stable or marginal", ...some(false), role: { series: 0 }, size: 8 },
      { kind: "points", label: "unstable", ...some(true), role: { series: 3 }, size: 11 },
    ],
  };
}

interface StoredShapeProps {
  readonly analysis: StudyAnalysis;
  readonly mode: number;
  readonly motion: { readonly frequency: number | null; readonly growth: number | null };
}

/** One mode of those that are stored: the others stay where they are. */
function StoredShape({ analysis, mode, motion }: StoredShapeProps) {
  const { body, error } = useBody(analysis);
  const stored = variable(analysis, SHAPE);
  const kept = stored?.shape[0] ?? 0;
  const shape = useArrays(analysis.name, mode < kept ? [SHAPE] : [], { from: mode, to: mode + 1 }, SHAPE);
  const swing = useMemo(() => {
    const array = shape.arrays?.get(SHAPE);
    return body && array ? swingOf(body, numbers(shape.arrays, SHAPE), array.type === "complex") : null;
  }, [body, shape.arrays]);
  if (mode >= kept) return <p>The shape of this mode is not stored: there would be too many.</p>;
  return (
    <>
      <ErrorNote error={error ?? shape.error} />
      {body && swing ? (
        <ShapeView title={`Mode ${mode + 1} of ${analysis.name}`} body={body} swing={swing} motion={motion} unit={stored?.units ?? ""} />
      ) : (
        <p role="status">Reading the shape…</p>
      )}
    </>
  );
}
