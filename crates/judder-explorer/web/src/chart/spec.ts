/** What a chart shows: axes and layers, in the values of the data. */

import type { AreaStyle, ColourMap, Dash, LineRole, Marker } from "./palette";
import type { Range, Scale } from "./scale";

export interface Axis {
  /** Markup, with the unit in brackets: `"Growth rate Re $λ$ (s^{−1})"`. */
  readonly label: string;
  readonly scale: Scale;
  /** What is shown at first; left out, what the layers need. */
  readonly range?: Range;
  /** The header of exported columns; left out, the label as plain text. */
  readonly name?: string;
  /** What stands at these values, ascending, in the place of numbers. */
  readonly names?: readonly (readonly [value: number, name: string])[];
}

/** A second quantity along the horizontal axis: the value above each abscissa, straight between them; both run one way. */
export interface SecondAxis {
  readonly label: string;
  readonly x: ArrayLike<number>;
  readonly value: ArrayLike<number>;
}

interface Common {
  /** In the legend; an empty label leaves the layer out of it. */
  readonly label: string;
  /** What it is called in exported data; left out, the label as plain text. */
  readonly name?: string;
  /** Only helps the eye: not part of exported data, as rules without a label. */
  readonly scenery?: boolean;
}

/** What else is known of each point of a layer: a further column of exported data. */
interface Along {
  readonly name: string;
  readonly values: ArrayLike<number>;
}

/** Points of data; NaN interrupts a line through them. */
interface Curve extends Common {
  readonly x: ArrayLike<number>;
  readonly y: ArrayLike<number>;
  readonly role: LineRole;
}

export interface LineLayer extends Curve {
  readonly kind: "line";
  /** Markers at the points too. */
  readonly marked?: boolean;
  readonly dash?: Dash;
  /** In pixels; left out, that of the role. */
  readonly width?: number;
  readonly along?: Along;
}

export interface PointsLayer extends Curve {
  readonly kind: "points";
  /** Diameter in pixels; 8 where left out. */
  readonly size?: number;
  /** Only outlines: thresholds of another system, a state before. */
  readonly hollow?: boolean;
  /** Left out, that of the role. */
  readonly marker?: Marker;
  /** Without rims, which would hide each other. */
  readonly crowded?: boolean;
  /** Diameters over `size`, one a point. */
  readonly sizes?: ArrayLike<number>;
}

/** Stretches of the x axis (or of the y axis), such as contact states. */
export interface BandsLayer extends Common {
  readonly kind: "bands";
  readonly across?: "x" | "y";
  readonly from: ArrayLike<number>;
  readonly to: ArrayLike<number>;
  readonly style: AreaStyle;
}

/** What lies between two curves. */
export interface AreaLayer extends Common {
  readonly kind: "area";
  readonly x: ArrayLike<number>;
  readonly lower: ArrayLike<number>;
  readonly upper: ArrayLike<number>;
  readonly style: AreaStyle;
}

/** A straight line at one value. */
export interface RuleLayer extends Common {
  readonly kind: "rule";
  readonly across: "x" | "y";
  readonly at: number;
  readonly role: LineRole;
  /** Stands along the line. */
  readonly caption?: string;
}

/** A rectangle; without an end, the whole width or height. */
export interface RegionLayer extends Common {
  readonly kind: "region";
  readonly x: Range | null;
  readonly y: Range | null;
  readonly style: AreaStyle;
}

/** A text whose left end stands at a place. */
interface NoteLayer extends Common {
  readonly kind: "note";
  readonly x: number;
  readonly y: number;
  readonly text: string;
}

interface AreaClass extends AreaStyle {
  readonly name: string;
  /** What the legend says; the name where left out. */
  readonly legend?: string;
  /** Whether the pattern is drawn even where the layer is not hatched. */
  readonly always?: boolean;
}

/** A map over x and y, which are centres of cells, ascending; what stands in the cells is row-major with y as rows. */
interface CellsLayer extends Common {
  readonly x: ArrayLike<number>;
  readonly y: ArrayLike<number>;
}

export interface ClassesLayer extends CellsLayer {
  readonly kind: "classes";
  readonly codes: Uint8Array;
  readonly classes: readonly AreaClass[];
  readonly hatched?: boolean;
  readonly letters?: boolean;
}

/** A map of values, with a bar. */
export interface ValuesLayer extends CellsLayer {
  readonly kind: "values";
  /** NaN stays ground. */
  readonly values: ArrayLike<number>;
  readonly colours: ColourMap;
  readonly scale: Scale;
  /** Left out: that of the values. */
  readonly range?: Range;
  /** How cells without a value are drawn; left out, not at all. */
  readonly gaps?: AreaStyle;
}

export type Layer = LineLayer | PointsLayer | BandsLayer | AreaLayer | RuleLayer | RegionLayer | NoteLayer | ClassesLayer | ValuesLayer;
export type RasterLayer = ClassesLayer | ValuesLayer;

export interface ChartSpec {
  /** What the chart is, in words: its accessible name and the name of exported files. */
  readonly title: string;
  readonly x: Axis;
  readonly y: Axis;
  /** Drawn in this order; rasters lie below all others. */
  readonly layers: readonly Layer[];
  /** One unit is as long across as up (complex planes of equal units, shapes). */
  readonly equal?: boolean;
  readonly second?: SecondAxis;
  /** Whether the legend stands elsewhere. */
  readonly explained?: boolean;
}

export function isRaster(layer: Layer): layer is RasterLayer {
  return layer.kind === "classes" || layer.kind === "values";
}
