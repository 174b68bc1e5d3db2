// SPDX-License-Identifier: BSD-3-Clause
import { Color, PerspectiveCamera, Quaternion, Scene, Sphere, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { ModelView } from "./model_view";

export type ViewName = "iso" | "+x" | "-x" | "+y" | "-y" | "+z" | "-z";

export interface Sight {
  eye: Vector3;
  target: Vector3;
  up: Vector3;
}

/** Where the eye is, and what is up. */
const views: Record<ViewName, [number[], number[]]> = {
  iso: [[1, -1.35, 0.8], [0, 0, 1]],
  "+x": [[1, 0, 0], [0, 0, 1]],
  "-x": [[-1, 0, 0], [0, 0, 1]],
  "+y": [[0, 1, 0], [0, 0, 1]],
  "-y": [[0, -1, 0], [0, 0, 1]],
  "+z": [[0, 0, 1], [0, 1, 0]],
  "-z": [[0, 0, -1], [0, 1, 0]],
};

/** Ball around the run's box in the world of ModelView. */
export const wholeRun = new Sphere(new Vector3(), 0.5);

/** Canvas, camera and mouse; draws when something has changed. */
export class Viewport {
  readonly renderer: WebGLRenderer;
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(26, 1, 0.01, 100);
  readonly controls: OrbitControls;
  /** called at every frame of the screen with the seconds since the last */
  beforeFrame: (seconds: number) => void = () => {};
  afterDraw: () => void = () => {};
  private stale = true;
  private last = 0;

  constructor(
    readonly host: HTMLElement,
    view: ModelView,
  ) {
    this.renderer = new WebGLRenderer({ antialias: true, powerPreference: "high-performance" });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.domElement.tabIndex = 0;
    this.renderer.domElement.setAttribute("aria-label", "deformed model; drag turns it, wheel zooms, click picks");
    host.append(this.renderer.domElement);
    this.scene.add(view.group);
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.enableDamping = false;
    this.controls.zoomToCursor = true;
    this.controls.minDistance = 0.02;
    this.controls.maxDistance = 20;
    this.controls.addEventListener("change", () => this.invalidate());
    new ResizeObserver(() => this.resize()).observe(host);
    this.resize();
    this.setView("iso", wholeRun);
    requestAnimationFrame((now) => this.tick(now));
  }

  invalidate(): void {
    this.stale = true;
  }

  setGround(colour: string): void {
    this.scene.background = new Color(colour);
    this.invalidate();
  }

  /** Looks at a ball from a side. */
  setView(name: ViewName, ball: Sphere): void {
    const [from, up] = views[name];
    this.camera.up.set(up[0], up[1], up[2]);
    this.controls.target.copy(ball.center);
    const way = new Vector3(from[0], from[1], from[2]).setLength(Math.max(ball.radius, 1e-3) * this.fitFactor());
    this.camera.position.copy(ball.center).add(way);
    this.camera.lookAt(ball.center);
    this.alignControls();
    this.controls.update();
    this.invalidate();
  }

  /** What is looked at and from where, in the coordinates of the world. */
  get sight(): Sight {
    const { position, up } = this.camera;
    return { eye: position.clone(), target: this.controls.target.clone(), up: up.clone() };
  }

  set sight({ eye, target, up }: Sight) {
    this.camera.up.copy(up);
    this.camera.position.copy(eye);
    this.controls.target.copy(target);
    this.camera.lookAt(target);
    this.alignControls();
    this.controls.update();
    this.invalidate();
  }

  /** Distance from which a ball fills the picture, in its radii. */
  private fitFactor(): number {
    const half = (this.camera.fov * Math.PI) / 360;
    const narrow = Math.min(1, this.camera.aspect);
    return 0.94 / Math.sin(Math.atan(Math.tan(half) * narrow));
  }

  /** OrbitControls reads camera.up when it is made: a later change is handed over as the rotation it keeps. */
  private alignControls(): void {
    const turn = new Quaternion().setFromUnitVectors(this.camera.up, new Vector3(0, 1, 0));
    Object.assign(this.controls, { _quat: turn, _quatInverse: turn.clone().invert() });
  }

  private resize(): void {
    const width = Math.max(1, this.host.clientWidth);
    const height = Math.max(1, this.host.clientHeight);
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  draw(): void {
    this.stale = false;
    this.renderer.render(this.scene, this.camera);
    this.afterDraw();
  }

  private tick(now: number): void {
    requestAnimationFrame((next) => this.tick(next));
    const seconds = Math.min(0.25, (now - this.last) / 1000);
    this.last = now;
    this.beforeFrame(seconds);
    if (this.stale) this.draw();
  }
}
