// SPDX-License-Identifier: BSD-3-Clause
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  Float32BufferAttribute,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  Quaternion,
  Vector3,
} from "three";
import { interpolate } from "../math/numbers";
import { splitBy, type History } from "../payload/history";
import type { Run } from "../payload/run";
import type { ModelView } from "./model_view";

/** Rigid walls: those with a shape move as recorded, infinite planes are drawn as a square with a grid. */
export class Walls {
  readonly group = new Group();
  readonly any: boolean;
  private readonly moving: { object: Group; motion: number[] }[] = [];
  private readonly planes: { object: Group; motion: History }[] = [];
  private readonly faceMaterial = new MeshBasicMaterial({
    transparent: true,
    opacity: 0.22,
    side: DoubleSide,
    depthWrite: false,
    polygonOffset: true,
    polygonOffsetFactor: 2,
    polygonOffsetUnits: 2,
  });
  private readonly lineMaterial = new LineBasicMaterial({ transparent: true, opacity: 0.4 });

  constructor(
    run: Run,
    private readonly view: ModelView,
  ) {
    const walls = run.meta.walls;
    if (walls)
      for (const id of new Set(walls.wall)) {
        const faces = walls.faces.filter((_, i) => walls.wall[i] === id);
        this.addShape(walls.points, faces, walls.motion[String(id)]);
      }
    const motion = run.history("rwmotion.csv");
    const motions = motion ? splitBy(motion, ["wall"]) : null;
    for (const plane of run.meta.run?.plane_walls ?? []) {
      const object = this.addPlane(plane.point, plane.normal);
      const moves = motions?.get(String(plane.id));
      if (moves) this.planes.push({ object, motion: moves });
    }
    this.any = this.group.children.length > 0;
  }

  private addShape(points: number[], faces: number[][], motion: number[]): void {
    const world = new Float32Array(points.length);
    for (let i = 0; i < points.length; i += 3)
      world.set(this.view.toWorld([points[i], points[i + 1], points[i + 2]]).toArray(), i);
    const triangles = faces.flatMap((face) => face.slice(2).flatMap((_, i) => [face[0], face[i + 1], face[i + 2]]));
    const edges = faces.flatMap((face) => face.flatMap((point, i) => [point, face[(i + 1) % face.length]]));
    const object = this.addObject(world, triangles, edges);
    this.moving.push({ object, motion });
  }

  private addPlane(point: number[], normal: number[]): Group {
    const foot = this.view.toWorld(point as [number, number, number]);
    const n = new Vector3(...(normal as [number, number, number])).normalize();
    // The square lies where the middle of the model falls on the plane.
    const middle = n.clone().multiplyScalar(foot.dot(n));
    const turn = new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), n);
    // As large as the model is across the normal, so that a long model is not hidden behind it.
    const across = new Vector3(1, 1, 1).sub(n.clone().multiply(n)).multiply(this.view.extent);
    const half = Math.min(0.45, Math.max(0.1, 0.7 * across.length()));
    const cells = 10;
    const points: number[] = [];
    const edges: number[] = [];
    for (let i = 0; i <= cells; ++i) {
      const at = -half + (2 * half * i) / cells;
      for (const [x, y] of [[at, -half], [at, half], [-half, at], [half, at]]) {
        edges.push(points.length / 3);
        points.push(...new Vector3(x, y, 0).applyQuaternion(turn).add(middle).toArray());
      }
    }
    const last = 4 * cells;
    return this.addObject(Float32Array.from(points), [0, 1, last + 1, 0, last + 1, last], edges);
  }

  private addObject(points: Float32Array, triangles: number[], edges: number[]): Group {
    const object = new Group();
    const position = new Float32BufferAttribute(points, 3);
    const make = (index: number[]) => {
      const geometry = new BufferGeometry();
      geometry.setAttribute("position", position);
      geometry.setIndex(new BufferAttribute(Uint32Array.from(index), 1));
      return geometry;
    };
    object.add(new Mesh(make(triangles), this.faceMaterial), new LineSegments(make(edges), this.lineMaterial));
    this.group.add(object);
    return object;
  }

  setTime(frame: number, share: number, time: number): void {
    for (const { object, motion } of this.moving) {
      const next = Math.min(motion.length / 3 - 1, frame + 1);
      const at = (axis: number) => (motion[3 * frame + axis] * (1 - share) + motion[3 * next + axis] * share) / this.view.diagonal;
      object.position.set(at(0), at(1), at(2));
    }
    for (const { object, motion } of this.planes) {
      const at = (name: string) => interpolate(motion.number["time"], motion.number[name], time) / this.view.diagonal;
      object.position.set(at("ux"), at("uy"), at("uz"));
    }
  }

  setColour(colour: string): void {
    this.faceMaterial.color = new Color(colour);
    this.lineMaterial.color = new Color(colour);
  }
}
