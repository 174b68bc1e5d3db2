// SPDX-License-Identifier: BSD-3-Clause
import { Color, NearestFilter, Scene, Vector3, WebGLRenderTarget, type PerspectiveCamera, type WebGLRenderer } from "three";
import type { Run } from "../payload/run";
import { Faces, Lines } from "./geometry";
import type { ModelView } from "./model_view";

export interface Pick {
  cell: number;
  /** corner of the face that is nearest to the place */
  node: number;
  /** nodes of its outline, by pairs */
  outline: number[];
}

/** Pixels around the place that are looked at: a finger and a beam of one pixel must meet. */
const reach = 4;

/** Finds what is seen at a place of the canvas by drawing the numbers of faces into a small picture. */
export class Picker {
  private readonly scene = new Scene();
  private readonly size = 2 * reach + 1;
  private readonly target: WebGLRenderTarget;

  constructor(
    private readonly run: Run,
    private readonly view: ModelView,
  ) {
    this.scene.add(view.pickGroup);
    this.scene.background = new Color(0, 0, 0);
    this.target = new WebGLRenderTarget(this.size, this.size, { magFilter: NearestFilter, minFilter: NearestFilter });
  }

  /** x and y in pixels of the page from the canvas' upper left corner. */
  pick(renderer: WebGLRenderer, camera: PerspectiveCamera, x: number, y: number, frame: number, share: number): Pick | null {
    const width = renderer.domElement.clientWidth;
    const height = renderer.domElement.clientHeight;
    camera.setViewOffset(width, height, x - reach, y - reach, this.size, this.size);
    renderer.setRenderTarget(this.target);
    renderer.render(this.scene, camera);
    const pixels = new Uint8Array(4 * this.size * this.size);
    renderer.readRenderTargetPixels(this.target, 0, 0, this.size, this.size, pixels);
    renderer.setRenderTarget(null);
    camera.clearViewOffset();
    const face = this.nearest(pixels);
    if (face < 0) return null;
    const corners = this.corners(face);
    const project = (node: number): [number, number] => {
      const at = this.view.toWorld(this.position(node, frame, share)).project(camera);
      return [((at.x + 1) / 2) * width, ((1 - at.y) / 2) * height];
    };
    let best = corners[0];
    let least = Infinity;
    for (const node of corners) {
      const [px, py] = project(node);
      const distance = Math.hypot(px - x, py - y);
      if (distance < least) [best, least] = [node, distance];
    }
    const mesh = this.run.mesh;
    const line = face >= mesh.faceCount;
    const cell = line ? new Lines(mesh).cell(face - mesh.faceCount) : new Faces(mesh).cell(face);
    const outline = line ? corners : corners.flatMap((node, i) => [node, corners[(i + 1) % corners.length]]);
    return { cell, node: best, outline };
  }

  private nearest(pixels: Uint8Array): number {
    let face = -1;
    let least = Infinity;
    for (let row = 0; row < this.size; ++row)
      for (let column = 0; column < this.size; ++column) {
        const at = 4 * (row * this.size + column);
        const number = pixels[at] + 256 * pixels[at + 1] + 65536 * pixels[at + 2];
        const distance = Math.hypot(row - reach, column - reach);
        if (number > 0 && distance < least) [face, least] = [number - 1, distance];
      }
    return face;
  }

  private corners(face: number): number[] {
    const mesh = this.run.mesh;
    if (face >= mesh.faceCount) {
      const lines = new Lines(mesh);
      return [0, 1].map((end) => lines.node(face - mesh.faceCount, end));
    }
    const faces = new Faces(mesh);
    return Array.from({ length: faces.corners(face) }, (_, corner) => faces.node(face, corner));
  }

  private position(node: number, frame: number, share: number): [number, number, number] {
    const a = new Vector3(...this.run.position(frame, node));
    const b = new Vector3(...this.run.position(Math.min(frame + 1, this.run.frames - 1), node));
    return a.lerp(b, share).toArray();
  }
}
