/** The panels of a described figure as charts. */

import { type AreaStyle, type LineRole, PIXELS_PER_POINT } from "../chart/palette";
import { MEANINGS } from "../chart/meanings";
import type { ChartSpec, Layer as ChartLayer } from "../chart/spec";
import type { Axis, ClassMap, Figure, Layer, Line, Numbers, Panel, Role, Swing } from "./described";

/** Diameters of markers, in pixels. */
const [USUAL, CROWDED] = [7, 3];

/** Strokes of areas that are never plain, as drawings have them. */
const PATTERNS: Record<string, Partial<AreaStyle>> = {
  unresolved: { colour: MEANINGS.ground, stroke: MEANINGS.areas.unresolved, pattern: "rising" },
  knock: { stroke: MEANINGS.quiet, pattern: "falling" },
  "knock-unknown": { stroke: MEANINGS.quiet, pattern: "dots" },
  "within-law": { stroke: MEANINGS.quiet, pattern: "crossed" },
  "turning-normal": { stroke: MEANINGS.quiet, pattern: "falling" },
  "convected-slip": { stroke: MEANINGS.quiet, pattern: "dots" },
  "across-slip": { stroke: MEANINGS.quiet, pattern: "crossed" },
  "unknown-growth": { stroke: MEANINGS.quiet, pattern: "rising" },
};

/** What is shown: the phase of what swings, and the labels whose layers are hidden. */
export interface View {
  readonly phase: number;
  readonly hidden: ReadonlySet<string>;
}

export function specOf(figure: Figure, panel: Panel, { phase, hidden }: View): ChartSpec {
  const layers = panel.layers.map((layer) => layerOf(layer, phase)).filter((layer) => layer.label === "" || !hidden.has(layer.label));
  return {
    title: panel.title ? `${figure.title}: ${panel.title}` : figure.title,
    x: axisOf(panel.x),
    y: axisOf(panel.y),
    layers,
    explained: true,
    ...(panel.second ? { second: panel.second } : {}),
  };
}

export function swings(panel: Panel): boolean {
  return panel.layers.some((layer) => "line" in layer && layer.line.swing);
}

function axisOf({ label, scale, range, names }: Axis): ChartSpec["x"] {
  return { label, scale, range, ...(names ? { names } : {}) };
}

/** A layer of a chart. */
export function layerOf(layer: Layer, phase = 0): ChartLayer {
  if ("line" in layer) {
    const { style } = layer.line;
    return { kind: "line", label: layer.line.label, ...placed(layer.line, phase), role: lineRole(style.role), dash: style.dash, width: PIXELS_PER_POINT * style.width };
  }
  if ("points" in layer) return pointsOf(layer.points);
  if ("classes" in layer) return classesOf(layer.classes);
  if ("values" in layer) {
    const { x, y, z, bar, colours } = layer.values;
    return { kind: "values", label: bar.label, x, y, values: z, colours, scale: bar.scale, range: bar.range, gaps: areaStyle("unresolved") };
  }
  if ("rule" in layer) {
    const { direction, value, label } = layer.rule;
    return { kind: "rule", label: "", across: direction === "vertical" ? "x" : "y", at: value, role: "reference", caption: label };
  }
  if ("region" in layer) {
    const { label, x, y, role } = layer.region;
    return { kind: "region", label, x, y, style: areaStyle(role) };
  }
  return { kind: "note", label: "", ...layer.note };
}

function pointsOf({ label, x, y, style, sizes }: Line): ChartLayer {
  const { role, marker, crowded } = style;
  return { kind: "points", label, x, y, role: lineRole(role), marker, crowded, size: crowded ? CROWDED : USUAL, ...(sizes ? { sizes } : {}) };
}

function classesOf({ x, y, codes, classes }: ClassMap): ChartLayer {
  const areas = classes.map(({ label, role }) => ({ name: label, ...areaStyle(role), always: true }));
  return { kind: "classes", label: "", x, y, codes: Uint8Array.from(codes), classes: areas };
}

function lineRole(role: Role): LineRole {
  if (typeof role !== "string") return "graded" in role ? { graded: role.graded.index, of: role.graded.count } : role;
  return role in MEANINGS.lines ? (role as keyof typeof MEANINGS.lines) : "reference";
}

function areaStyle(role: Role): AreaStyle {
  const areas: Readonly<Record<string, string>> = MEANINGS.areas;
  const colour = (typeof role === "string" && areas[role]) || MEANINGS.quiet;
  return { colour, pattern: "none", letter: "", ...(typeof role === "string" ? PATTERNS[role] : {}) };
}

/** Where the points of a line stand at a phase. */
function placed({ x, y, swing }: Line, phase: number): { x: Numbers; y: Numbers } {
  if (!swing || phase === 0) return { x, y };
  return { x: swung(x, swing.x, phase), y: swung(y, swing.y, phase) };
}

function swung(drawn: Numbers, [a, b]: Swing["x"], phase: number): Numbers {
  const [cosine, sine] = [Math.cos(phase) - 1, Math.sin(phase)];
  return Float64Array.from({ length: drawn.length }, (_, k) => (drawn[k] as number) + (a[k] as number) * cosine - (b[k] as number) * sine);
}
