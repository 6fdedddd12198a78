/** How large the shape is drawn, at which moment of its swing, and from where it is seen. */

import { LARGEST_SCALE, type Look } from "./state";

interface ScaleAndPhaseProps {
  readonly scale: number;
  readonly onScale: (scale: number, keep: "drag" | "push") => void;
  readonly phase: number;
  readonly onPhase: (phase: number) => void;
  readonly playing: boolean;
  readonly look: Look;
  readonly onLook: (look: Look, keep: "drag" | "push") => void;
}

const ANGLES = [
  ["azimuth", "Around", 180],
  ["elevation", "Above", 90],
] as const;

const number = (event: Event) => Number((event.currentTarget as HTMLInputElement).value);

export function ScaleAndPhase({ scale, onScale, phase, onPhase, playing, look, onLook }: ScaleAndPhaseProps) {
  const degrees = Math.round((phase * 180) / Math.PI) % 360;
  return (
    <div class="shape-sliders">
      <label>
        <span>Scale</span>
        <input
          type="range"
          min={0}
          max={LARGEST_SCALE}
          step={0.05}
          value={scale}
          onInput={(event) => onScale(number(event), "drag")}
          onChange={(event) => onScale(number(event), "push")}
        />
        <output>× {scale}</output>
      </label>
      <label>
        <span>Phase</span>
        <input type="range" min={0} max={359} step={1} value={degrees} onInput={(event) => onPhase((number(event) * Math.PI) / 180)} aria-label={playing ? "Phase (stops the motion)" : "Phase"} />
        <output>{degrees}°</output>
      </label>
      {ANGLES.map(([name, words, most]) => (
        <label key={name}>
          <span>{words}</span>
          <input
            type="range"
            min={-most}
            max={most}
            step={5}
            value={look[name]}
            onInput={(event) => onLook({ ...look, [name]: number(event) }, "drag")}
            onChange={(event) => onLook({ ...look, [name]: number(event) }, "push")}
          />
          <output>{look[name]}°</output>
        </label>
      ))}
    </div>
  );
}
