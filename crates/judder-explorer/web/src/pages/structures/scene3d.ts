/** The picture of a body in space, drawn with WebGL: the only file that needs three. */

import {
  BufferAttribute,
  BufferGeometry,
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
import { type Theme, INK, shade } from "../../chart/palette";
import { type Body, DISPLACEMENT, type Swing, basis, placesAt } from "./body";
import { LARGEST_SCALE, type Look } from "./state";

export interface Still {
  readonly look: Look;
  readonly zoom: number;
  readonly phase: number;
  /** By how much larger than its numbers the shape is drawn. */
  readonly factor: number;
}

/** How the body at rest looks. */
const FAINT = { transparent: true, opacity: 0.45 } as const;

export class BodyScene {
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new OrthographicCamera(-1, 1, 1, -1, 0, 10);
  private body: Body | undefined;
  private swing: Swing | undefined;
  private moved = new BufferAttribute(new Float32Array(0), 3);
  private readonly geometries: BufferGeometry[] = [];
  // materials live as long as the picture: a new one would compile its program anew, a second or more without a graphics card
  private readonly looks = {
    rest: { lines: new LineBasicMaterial(FAINT), points: new PointsMaterial({ ...FAINT, size: 2, sizeAttenuation: false }) },
    moved: { lines: new LineBasicMaterial({ vertexColors: true }), points: new PointsMaterial({ vertexColors: true, size: 4, sizeAttenuation: false }) },
  };

  /** Throws where the browser has no WebGL. */
  constructor(readonly canvas: HTMLCanvasElement) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
  }

  show(body: Body, swing: Swing, theme: Theme): void {
    this.clear();
    [this.body, this.swing] = [body, swing];
    const count = body.points.length / 3;
    const rest = new BufferAttribute(Float32Array.from(body.points), 3);
    this.moved = new BufferAttribute(Float32Array.from(body.points), 3).setUsage(DynamicDrawUsage);
    const colours = new Float32Array(3 * count);
    const colour = new Color();
    for (let i = 0; i < count; i += 1) {
      const [red, green, blue] = shade(swing.reach[i] as number, theme);
      colour.setRGB(red / 255, green / 255, blue / 255, "srgb").toArray(colours, 3 * i);
    }
    this.looks.rest.lines.color.set(INK[theme].quiet);
    this.looks.rest.points.color.set(INK[theme].quiet);
    this.scene.add(this.part(rest, body.lines, null));
    this.scene.add(this.part(this.moved, body.lines, new BufferAttribute(colours, 3)));
  }

  private part(places: BufferAttribute, lines: Uint32Array, colours: BufferAttribute | null): Object3D {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", places);
    if (colours) geometry.setAttribute("color", colours);
    this.geometries.push(geometry);
    const look = this.looks[colours ? "moved" : "rest"];
    if (lines.length > 0) geometry.setIndex(new BufferAttribute(lines, 1));
    const object = lines.length > 0 ? new LineSegments(geometry, look.lines) : new Points(geometry, look.points);
    // the box of what moves would have to be found anew in every picture
    object.frustumCulled = false;
    return object;
  }

  draw({ look, zoom, phase, factor }: Still): void {
    const { body, swing } = this;
    if (!body || !swing) return;
    placesAt(body, swing, phase, factor, this.moved.array as Float32Array);
    this.moved.needsUpdate = true;
    this.place(body, look, zoom);
    this.renderer.render(this.scene, this.camera);
  }

  private place(body: Body, look: Look, zoom: number): void {
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
    for (const geometry of this.geometries.splice(0)) geometry.dispose();
  }

  close(): void {
    this.clear();
    for (const { lines, points } of Object.values(this.looks)) {
      lines.dispose();
      points.dispose();
    }
    this.renderer.dispose();
  }
}
