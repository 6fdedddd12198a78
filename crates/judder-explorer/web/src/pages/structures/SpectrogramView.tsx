/** A spectrogram with the unstable zones of the locus over it. */

import { useMemo } from "preact/hooks";
import { useView } from "../../state/store";
import { withFields } from "../../state/view";
import { useApp } from "../../ui/app";
import { Value } from "../../ui/Value";
import { Busy } from "./Busy";
import { positionAt, timeAt } from "./motion";
import { type Over, levelsCsv, readLevels, spectrogramSpec, spectrogramVariables, toldOfLevels } from "./spectrogram";
import { StudyChart } from "./StudyChart";
import { numberField, placed } from "./state";
import { type StudyAnalysis, variable } from "./study";
import { useArrays } from "./useArrays";

const PEAK = [
  ["peak_level_db", "Peak level", "dB"],
  ["peak_frequency_hz", "at the frequency", "Hz"],
  ["peak_time_s", "at the time", "s"],
  ["peak_position_m", "at the position", "m"],
  ["resolution_hz", "Resolution", "Hz"],
] as const;

export function SpectrogramView({ analysis }: { readonly analysis: StudyAnalysis }) {
  const { store } = useApp();
  const view = useView(store);
  const live = useArrays(analysis.name, spectrogramVariables(analysis));
  const levels = useMemo(() => (live.arrays ? readLevels(analysis, live.arrays) : null), [analysis, live.arrays]);
  const placedAt = variable(analysis, "position") !== undefined;
  const over: Over = placedAt && view.fields["over"] === "position" ? "position" : "time";
  const spec = useMemo(() => (levels ? spectrogramSpec(analysis, levels, over) : null), [analysis, levels, over]);
  if (!levels || !spec) return <Busy live={live} words="Reading the levels…" />;
  const at = numberField(view, "at");
  const mark = at === undefined ? null : over === "position" || !placedAt ? at : timeAt(levels.motion, at);
  const onPick = ({ x }: { readonly x: number }) => {
    const next = over === "position" || !placedAt ? x : positionAt(levels.motion, x);
    const along = placedAt ? levels.position : levels.time;
    store.update((view) => withFields(view, { at: String(placed(next, [along[0] ?? 0, along.at(-1) ?? 1])) }));
  };
  return (
    <>
      {placedAt && (
        <div role="group" aria-label="Over" class="study-choice">
          {(["time", "position"] as const).map((one) => (
            <button type="button" key={one} aria-pressed={over === one} onClick={() => store.update((view) => withFields(view, { over: one === "time" ? undefined : one }))}>
              Over {one}
            </button>
          ))}
        </div>
      )}
      <StudyChart
        spec={spec}
        names={{ x: over === "time" ? "time" : "along", y: "frequency" }}
        height={520}
        mark={mark}
        onPick={onPick}
        dataOf={(window) => levelsCsv(spec, levels, over, window)}
        note={toldOfLevels(levels)}
      />
      <dl class="values study-values">
        {PEAK.filter(([name]) => typeof analysis.scalars[name] === "number").map(([name, words, unit]) => (
          <Value key={name} name={words} dataKey={`${analysis.name}.${name}`} value={analysis.scalars[name] as number} unit={unit} />
        ))}
      </dl>
    </>
  );
}
