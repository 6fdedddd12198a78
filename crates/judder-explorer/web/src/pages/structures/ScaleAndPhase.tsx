/** How large the shape is drawn, at which moment of its swing, and from where it is seen. */

import type { Keep } from "../../state/store";
import { Slider } from "../../ui/Slider";
import { LARGEST_SCALE, type Look } from "./state";

interface ScaleAndPhaseProps {
  readonly scale: number;
  readonly onScale: (scale: number, keep: Keep) => void;
  /** Null where nothing swings. */
  readonly phase: { readonly at: number; readonly playing: boolean; readonly onMove: (phase: number) => void } | null;
  readonly look: Look;
  readonly onLook: (look: Look, keep: Keep) => void;
}

const ANGLES = [
  ["azimuth", "Around", 180],
  ["elevation", "Above", 90],
] as const;

export function ScaleAndPhase({ scale, onScale, phase, look, onLook }: ScaleAndPhaseProps) {
  const degrees = phase ? Math.round((phase.at * 180) / Math.PI) % 360 : 0;
  return (
    <div class="shape-sliders">
      <Named name="Scale" range={[0, LARGEST_SCALE, 0.05]} value={scale} shown={`× ${scale}`} onMove={onScale} />
      {phase && (
        <Named
          name="Phase"
          spoken={phase.playing ? "Phase (stops the motion)" : "Phase"}
          range={[0, 359, 1]}
          value={degrees}
          shown={`${degrees}°`}
          onMove={(degrees) => phase.onMove((degrees * Math.PI) / 180)}
        />
      )}
      {ANGLES.map(([angle, name, most]) => (
        <Named key={angle} name={name} range={[-most, most, 5]} value={look[angle]} shown={`${look[angle]}°`} onMove={(value, keep) => onLook({ ...look, [angle]: value }, keep)} />
      ))}
    </div>
  );
}

interface NamedProps {
  readonly name: string;
  /** Its name for a screen reader, where that says more. */
  readonly spoken?: string;
  /** From, to, in steps of. */
  readonly range: readonly [number, number, number];
  readonly value: number;
  readonly shown: string;
  readonly onMove: (value: number, keep: Keep) => void;
}

function Named({ name, spoken = name, range: [from, to, step], value, shown, onMove }: NamedProps) {
  return (
    <label>
      <span>{name}</span>
      <Slider spoken={spoken} from={from} to={to} step={step} value={value} onMove={onMove} />
      <output>{shown}</output>
    </label>
  );
}
