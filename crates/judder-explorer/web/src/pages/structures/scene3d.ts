/** The picture of a body in space, drawn with WebGL: the only file that needs three. */

import {
  BufferAttribute,
  BufferGeometry,
  CanvasTexture,
  Color,
  DynamicDrawUsage,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  type Object3D,
  OrthographicCamera,
  Points,
  PointsMaterial,
  Scene,
  WebGLRenderer,
} from "three";
import { type Rgb, type Theme, INK, bodyGrey, rgb, shade } from "../../chart/palette";
import { type Body, DISPLACEMENT, type Swing, basis, placesAt } from "./body";
import type { Marks } from "./marks";
import { LARGEST_SCALE, type Look } from "./state";

export interface Still {
  readonly look: Look;
  readonly zoom: number;
  readonly phase: number;
  /** By how much larger than its numbers the shape is drawn. */
  readonly factor: number;
}

/** How the body at rest looks: where the moved one is grey too, fainter. */
const FAINT = { transparent: true, opacity: 0.45, vertexColors: true } as const;
const FAINTER = 0.22;

export class BodyScene {
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new OrthographicCamera(-1, 1, 1, -1, 0, 10);
  private body: Body | undefined;
  private swing: Swing | undefined;
  private moved = new BufferAttribute(new Float32Array(0), 3);
  private marks: { readonly of: Marks; readonly places: BufferAttribute } | undefined;
  private readonly geometries: BufferGeometry[] = [];
  // materials live as long as the picture: a new one would compile its program anew, a second or more without a graphics card
  private readonly looks = {
    rest: { lines: new LineBasicMaterial(FAINT), points: new PointsMaterial({ ...FAINT, size: 2, sizeAttenuation: false }) },
    mesh: new LineBasicMaterial(FAINT),
    moved: { lines: new LineBasicMaterial({ vertexColors: true }), points: new PointsMaterial({ vertexColors: true, size: 4, sizeAttenuation: false }) },
    closed: markMaterial(true),
    open: markMaterial(false),
  };

  /** Throws where the browser has no WebGL. */
  constructor(readonly canvas: HTMLCanvasElement) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
  }

  /** Colours tell displacements or, where there are marks, what these carry: the body is grey then. */
  show(body: Body, swing: Swing, theme: Theme, marks: Marks | null): void {
    this.clear();
    [this.body, this.swing] = [body, swing];
    const count = body.points.length / 3;
    const rest = new BufferAttribute(Float32Array.from(body.points), 3);
    this.moved = new BufferAttribute(Float32Array.from(body.points), 3).setUsage(DynamicDrawUsage);
    const greys = coloured(count, (i) => bodyGrey(body.part[i] as number, body.parts.length, theme));
    const colours = marks ? greys : coloured(count, (i) => shade(swing.reach[i] as number, theme));
    for (const material of Object.values(this.looks.rest)) material.opacity = marks ? FAINTER : FAINT.opacity;
    this.add(rest, body.lines, greys, this.looks.rest);
    this.add(this.moved, body.lines, colours, this.looks.moved);
    if (body.mesh.length > 0) this.place(new LineSegments(this.geometry(this.moved, colours, body.mesh), this.looks.mesh));
    if (marks) this.mark(marks, theme);
  }

  private add(places: BufferAttribute, lines: Uint32Array, colours: BufferAttribute, look: { readonly lines: LineBasicMaterial; readonly points: PointsMaterial }): void {
    const geometry = this.geometry(places, colours, lines);
    this.place(lines.length > 0 ? new LineSegments(geometry, look.lines) : new Points(geometry, look.points));
  }

  /** Contact points, seen through all bodies. */
  private mark(marks: Marks, theme: Theme): void {
    const count = marks.shares.length;
    const places = new BufferAttribute(new Float32Array(3 * count), 3).setUsage(DynamicDrawUsage);
    const colours = coloured(count, (i) => (marks.open[i] ? rgb(INK[theme].ink) : shade(marks.shares[i] as number, theme)));
    this.marks = { of: marks, places };
    for (const [isOpen, material] of [[true, this.looks.open], [false, this.looks.closed]] as const) {
      const own = Uint32Array.from(Array.from(marks.open.keys()).filter((i) => marks.open[i] === isOpen));
      if (own.length > 0) this.place(new Points(this.geometry(places, colours, own), material)).renderOrder = 1;
    }
  }

  /** Points, or ends of lines, of those by their indices; all of them where there are none. */
  private geometry(places: BufferAttribute, colours: BufferAttribute, indices: Uint32Array): BufferGeometry {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", places);
    geometry.setAttribute("color", colours);
    if (indices.length > 0) geometry.setIndex(new BufferAttribute(indices, 1));
    this.geometries.push(geometry);
    return geometry;
  }

  private place(object: Object3D): Object3D {
    // the box of what moves would have to be found anew in every picture
    object.frustumCulled = false;
    this.scene.add(object);
    return object;
  }

  draw({ look, zoom, phase, factor }: Still): void {
    const { body, swing } = this;
    if (!body || !swing) return;
    placesAt(body, swing, phase, factor, this.moved.array as Float32Array);
    this.moved.needsUpdate = true;
    if (this.marks) {
      this.marks.of.placesAt(swing, phase, factor, this.marks.places.array as Float32Array);
      this.marks.places.needsUpdate = true;
    }
    this.aim(body, look, zoom);
    this.renderer.render(this.scene, this.camera);
  }

  private aim(body: Body, look: Look, zoom: number): void {
    const { right, up, towards } = basis(look);
    const distance = 2 * body.diagonal * (1 + LARGEST_SCALE * DISPLACEMENT);
    const ratio = this.canvas.width / Math.max(this.canvas.height, 1);
    // the whole body is in sight from everywhere, and as large as its own sides allow
    const half = (direction: typeof right) => {
      let most = 0;
      for (let i = 0; i < body.points.length; i += 3) {
        const at = direction.reduce((sum, part, k) => sum + part * ((body.points[i + k] as number) - (body.centre[k] as number)), 0);
        most = Math.max(most, Math.abs(at));
      }
      return most + 1.5 * DISPLACEMENT * body.diagonal;
    };
    const high = Math.max(half(up), half(right) / ratio) / zoom;
    Object.assign(this.camera, { left: -high * ratio, right: high * ratio, top: high, bottom: -high, near: 0, far: 2 * distance });
    const [x, y, z] = body.centre.map((middle, k) => middle + distance * (towards[k] as number)) as [number, number, number];
    this.camera.position.set(x, y, z);
    const turn = new Matrix4().set(
      right[0], up[0], towards[0], 0,
      right[1], up[1], towards[1], 0,
      right[2], up[2], towards[2], 0,
      0, 0, 0, 1,
    );
    this.camera.quaternion.setFromRotationMatrix(turn);
    this.camera.updateProjectionMatrix();
  }

  resize(width: number, height: number): void {
    this.renderer.setPixelRatio(Math.min(globalThis.devicePixelRatio || 1, 2));
    this.renderer.setSize(width, height, false);
  }

  private clear(): void {
    this.scene.clear();
    this.marks = undefined;
    for (const geometry of this.geometries.splice(0)) geometry.dispose();
  }

  close(): void {
    this.clear();
    const { rest, mesh, moved, closed, open } = this.looks;
    for (const material of [rest.lines, rest.points, mesh, moved.lines, moved.points, closed, open]) material.dispose();
    for (const { map } of [closed, open]) map?.dispose();
    this.renderer.dispose();
  }
}

function coloured(count: number, colourOf: (i: number) => Rgb): BufferAttribute {
  const colours = new Float32Array(3 * count);
  const colour = new Color();
  for (let i = 0; i < count; i += 1) {
    const [red, green, blue] = colourOf(i);
    colour.setRGB(red / 255, green / 255, blue / 255, "srgb").toArray(colours, 3 * i);
  }
  return new BufferAttribute(colours, 3);
}

/** The size of a contact point, and of the picture from which it is made, in pixels. */
const MARK = { shown: 11, drawn: 64 } as const;

/** Round points, filled or hollow, in front of everything. */
function markMaterial(isFilled: boolean): PointsMaterial {
  const picture = document.createElement("canvas");
  picture.width = picture.height = MARK.drawn;
  const pen = picture.getContext("2d");
  if (pen) {
    [pen.fillStyle, pen.strokeStyle, pen.lineWidth] = ["#ffffff", "#ffffff", 0.16 * MARK.drawn];
    pen.arc(MARK.drawn / 2, MARK.drawn / 2, 0.38 * MARK.drawn, 0, 2 * Math.PI);
    if (isFilled) pen.fill();
    pen.stroke();
  }
  return new PointsMaterial({ map: new CanvasTexture(picture), vertexColors: true, size: MARK.shown, sizeAttenuation: false, transparent: true, depthTest: false });
}
