/** A figure of a report: a chart for each panel, one legend, and what sets its modes swinging. */

import { useEffect, useMemo, useState } from "preact/hooks";
import { ChartView } from "../chart/ChartView";
import { type Entry, KEY, drawKey, legendEntries } from "../chart/legend";
import { SceneView } from "../chart/SceneView";
import { Label } from "../ui/Label";
import type { Figure } from "./described";
import { type View, layerOf, specOf, swings } from "./specs";

/** Of the picture of one panel, and of one of several, in pixels. */
const [ALONE, ONE_OF_SEVERAL] = [430, 330];
/** What a second axis takes of a picture. */
const SECOND = 40;
/** Of a period of what swings, in milliseconds. */
const PERIOD = 1500;

export function FigureView({ figure }: { readonly figure: Figure }) {
  const { panels } = figure;
  const [hidden, setHidden] = useState<ReadonlySet<string>>(new Set());
  const [phase, playing, play] = usePhase();
  const still: View = useMemo(() => ({ phase: 0, hidden }), [hidden]);
  const specs = useMemo(() => panels.map((panel) => specOf(figure, panel, still)), [figure, still]);
  const now = (index: number) => {
    const panel = panels[index];
    return panel && phase !== 0 && swings(panel) ? specOf(figure, panel, { phase, hidden }) : specs[index];
  };
  const entries = useMemo(() => legendEntries({ layers: panels.flatMap((panel) => panel.layers.map((layer) => layerOf(layer))) }, "light"), [figure]);
  const toggle = (text: string) => setHidden((before) => new Set(before.has(text) ? [...before].filter((one) => one !== text) : [...before, text]));
  const height = panels.length === 1 ? ALONE : ONE_OF_SEVERAL;
  return (
    <>
      {panels.some(swings) && (
        <p class="figure-play">
          <button type="button" aria-pressed={playing} onClick={() => play(!playing)}>
            {playing ? "Stop" : "Swing"}
          </button>
        </p>
      )}
      <div class="panels" style={{ "--columns": Math.min(figure.columns, panels.length) }}>
        {panels.map((panel, index) => (
          <div class="panel" key={index}>
            {(panels.length > 1 || panel.title) && (
              <p class="panel-title">
                {panels.length > 1 && <b>{String.fromCharCode(97 + (index % 26))}</b>} <Label text={panel.title ?? ""} />
              </p>
            )}
            <ChartView
              spec={now(index) as (typeof specs)[number]}
              theme="light"
              name={`${figure.name}-live-${index}`}
              height={panel.second ? height + SECOND : height}
              nearest
              scrolls
            />
          </div>
        ))}
      </div>
      <ul class="figure-legend" aria-label="Legend">
        {entries.map((entry) => (
          <li key={entry.text}>
            <Explained entry={entry} prefix={`${figure.name}-live-0`} shown={!hidden.has(entry.text)} toggle={() => toggle(entry.text)} />
          </li>
        ))}
      </ul>
    </>
  );
}

interface ExplainedProps {
  readonly entry: Entry;
  readonly prefix: string;
  readonly shown: boolean;
  readonly toggle: () => void;
}

/** An entry of the legend; what is not a part of a map can be hidden. */
function Explained({ entry, prefix, shown, toggle }: ExplainedProps) {
  const inner = (
    <>
      <svg width={KEY} height={14} aria-hidden="true">
        <SceneView shapes={drawKey(entry, 0, 7, "light", prefix)} />
      </svg>
      <span>
        <Label text={entry.text} />
      </span>
    </>
  );
  if (entry.opaque) return <span class="legend-entry">{inner}</span>;
  return (
    <button type="button" class="legend-entry" aria-pressed={shown} title={shown ? "Hide" : "Show"} onClick={toggle}>
      {inner}
    </button>
  );
}

/** The phase of what swings, while it does: zero at rest. */
function usePhase(): [number, boolean, (playing: boolean) => void] {
  const [playing, play] = useState(false);
  const [phase, setPhase] = useState(0);
  useEffect(() => {
    if (!playing) return setPhase(0);
    const start = performance.now();
    let frame = requestAnimationFrame(function next(time) {
      setPhase(((2 * Math.PI * (time - start)) / PERIOD) % (2 * Math.PI));
      frame = requestAnimationFrame(next);
    });
    return () => cancelAnimationFrame(frame);
  }, [playing]);
  return [phase, playing, play];
}
