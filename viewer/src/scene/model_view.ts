// SPDX-License-Identifier: BSD-3-Clause
import {
  DataTexture,
  DoubleSide,
  GLSL3,
  Group,
  LinearFilter,
  LineSegments,
  Mesh,
  NearestFilter,
  Points,
  ShaderMaterial,
  Sphere,
  Vector3,
  Vector4,
  type BufferGeometry,
  type IUniform,
  type Object3D,
} from "three";
import { fringeTable, partColour, type Rgb } from "../math/colours";
import type { Run } from "../payload/run";
import { PositionTexture, ValueTexture } from "./frame_textures";
import type { FringeSource } from "./fringe_source";
import { edgeGeometry, faceGeometry, lineGeometry, markGeometry, type CellFacts } from "./geometry";
import { pickFragment, plainFragment, surfaceFragment, vertexShader } from "./shaders";

type Uniforms = Record<string, IUniform>;

/** The model as three draws it. Its world has the middle of the run's box at the origin and the box's diagonal
 * as unit length. */
export class ModelView {
  readonly group = new Group();
  readonly pickGroup = new Group();
  readonly parts: number[];
  readonly diagonal: number;
  readonly centre: Vector3;
  /** of the run's box, in the world's unit */
  readonly extent: Vector3;
  private readonly shared: Uniforms;
  private readonly frames: [PositionTexture, PositionTexture];
  private readonly values: ValueTexture;
  private readonly partTexture: DataTexture;
  private readonly facts: CellFacts;
  private readonly edges: LineSegments;
  private readonly ghost: LineSegments;
  private readonly edgeTint: Vector4 = new Vector4();
  private readonly ghostTint: Vector4 = new Vector4();
  private marks: Object3D[] = [];
  private source: FringeSource | null = null;
  private valueFrame = -1;

  constructor(private readonly run: Run) {
    const low = new Vector3(...(run.meta.box.low as [number, number, number]));
    const high = new Vector3(...(run.meta.box.high as [number, number, number]));
    this.diagonal = high.distanceTo(low) || 1;
    this.extent = high.clone().sub(low).divideScalar(this.diagonal);
    this.centre = low.clone().add(high).multiplyScalar(0.5);
    this.parts = [...new Set(run.part)].sort((a, b) => a - b);
    const place = new Map(this.parts.map((id, i) => [id, i]));
    this.facts = {
      part: Uint32Array.from(run.part, (id) => place.get(id)!),
      death: run.death,
      frames: run.frames,
    };
    this.frames = [new PositionTexture(run.meta.nodes), new PositionTexture(run.meta.nodes)];
    this.values = new ValueTexture(Math.max(run.meta.nodes, run.meta.cells));
    this.partTexture = this.makePartTexture();
    this.shared = this.makeUniforms(low);
    const faces = faceGeometry(run.mesh, this.facts);
    const lines = lineGeometry(run.mesh, this.facts);
    const edges = edgeGeometry(run.mesh, this.facts, run.meta.nodes);
    this.add(new Mesh(faces, this.material(surfaceFragment, { lit: true })), this.group);
    this.add(new LineSegments(lines, this.material(surfaceFragment, { lit: false, depthShift: 2e-4 })), this.group);
    this.edges = this.add(new LineSegments(edges, this.plain(this.edgeTint, { depthShift: 1e-4 })), this.group);
    this.ghost = this.add(new LineSegments(edges, this.ghostMaterial()), this.group);
    this.ghost.visible = false;
    this.add(new Mesh(faces, this.material(pickFragment, {})), this.pickGroup);
    this.add(new LineSegments(lines, this.material(pickFragment, { depthShift: 2e-4 })), this.pickGroup);
    this.setTime(0, 0);
  }

  private add<Kind extends Object3D>(object: Kind, group: Group): Kind {
    // Positions come from textures: three cannot know what is in view.
    object.frustumCulled = false;
    group.add(object);
    return object;
  }

  private makePartTexture(): DataTexture {
    const width = 256;
    const height = Math.ceil(this.parts.length / width);
    const array = new Uint8Array(4 * width * height);
    const texture = new DataTexture(array, width, height);
    texture.minFilter = texture.magFilter = NearestFilter;
    this.parts.forEach((_, i) => {
      array.set([...partColour(i).map((c) => Math.round(255 * c)), 255], 4 * i);
    });
    texture.needsUpdate = true;
    return texture;
  }

  private makeUniforms(low: Vector3): Uniforms {
    const steps = this.run.axes.map((axis) => axis.step / this.diagonal);
    return {
      positions: { value: this.frames[0].texture },
      nextPositions: { value: this.frames[1].texture },
      share: { value: 0 },
      codeStep: { value: new Vector3(...(steps as [number, number, number])) },
      codeOrigin: { value: low.clone().sub(this.centre).divideScalar(this.diagonal) },
      frame: { value: 0 },
      values: { value: this.values.texture },
      valuesByNode: { value: false },
      parts: { value: this.partTexture },
      section: { value: new Vector4(0, 0, 0, 1) },
      fringed: { value: false },
      range: { value: [0, 1] },
      fringe: { value: this.fringeTexture(12) },
      noValue: { value: [0.62, 0.64, 0.66] },
    };
  }

  private fringeTexture(bands: number): DataTexture {
    const texture = new DataTexture(fringeTable(bands), 256, 1);
    texture.minFilter = texture.magFilter = bands > 0 ? NearestFilter : LinearFilter;
    texture.needsUpdate = true;
    return texture;
  }

  private material(fragmentShader: string, own: Record<string, unknown>): ShaderMaterial {
    const uniforms: Uniforms = { depthShift: { value: 0 }, pointSize: { value: 1 }, ...this.shared };
    for (const [name, value] of Object.entries(own)) uniforms[name] = { value };
    return new ShaderMaterial({ glslVersion: GLSL3, vertexShader, fragmentShader, uniforms, side: DoubleSide });
  }

  private plain(tint: Vector4, own: Record<string, unknown>): ShaderMaterial {
    const material = this.material(plainFragment, { tint, round: false, ...own });
    material.transparent = true;
    material.depthWrite = false;
    return material;
  }

  private ghostMaterial(): ShaderMaterial {
    const start = new PositionTexture(this.run.meta.nodes);
    start.set(0, this.run.positions[0]);
    const material = this.plain(this.ghostTint, {});
    Object.assign(material.uniforms, {
      positions: { value: start.texture },
      share: { value: 0 },
      frame: { value: 0 },
      section: { value: new Vector4(0, 0, 0, 1) },
    });
    return material;
  }

  /** Shows the moment between a frame and the next one; share is 0 to 1. */
  setTime(frame: number, share: number): void {
    const next = Math.min(frame + 1, this.run.frames - 1);
    // Going on by a frame, what was the next one is there already.
    if (this.frames[1].holds(frame)) this.frames.reverse();
    this.frames[0].set(frame, this.run.positions[frame]);
    this.frames[1].set(next, this.run.positions[next]);
    this.shared.positions.value = this.frames[0].texture;
    this.shared.nextPositions.value = this.frames[1].texture;
    this.shared.share.value = share;
    this.shared.frame.value = frame;
    this.showValues(share < 0.5 ? frame : next);
  }

  private showValues(frame: number): void {
    if (!this.source || this.valueFrame === frame) return;
    this.valueFrame = frame;
    this.source.fill(frame, this.values.array);
    this.values.changed();
  }

  /** Colours by a field; null colours by part. */
  setSource(source: FringeSource | null): void {
    this.source = source;
    const frame = Math.max(this.valueFrame, this.shared.frame.value as number);
    this.valueFrame = -1;
    this.shared.fringed.value = source !== null;
    this.shared.valuesByNode.value = source?.byNode ?? false;
    this.showValues(frame);
  }

  setRange(low: number, high: number): void {
    this.shared.range.value = [low, high];
  }

  setBands(bands: number): void {
    (this.shared.fringe.value as DataTexture).dispose();
    this.shared.fringe.value = this.fringeTexture(bands);
  }

  setPartVisible(part: number, visible: boolean): void {
    const array = this.partTexture.image.data as Uint8Array;
    array[4 * part + 3] = visible ? 255 : 0;
    this.partTexture.needsUpdate = true;
  }

  isPartVisible(part: number): boolean {
    return (this.partTexture.image.data as Uint8Array)[4 * part + 3] > 0;
  }

  partColour(part: number): Rgb {
    return partColour(part);
  }

  setEdges(visible: boolean): void {
    this.edges.visible = visible;
  }

  setGhost(visible: boolean): void {
    this.ghost.visible = visible;
  }

  setTints(edge: [number, number, number, number], ghost: [number, number, number, number]): void {
    this.edgeTint.set(...edge);
    this.ghostTint.set(...ghost);
  }

  /** Cuts away what lies on the side of the normal; `at` is a distance from the origin in the world's unit. */
  setSection(normal: Vector3 | null, at = 0): void {
    if (normal) this.shared.section.value.set(normal.x, normal.y, normal.z, at);
    else this.shared.section.value.set(0, 0, 0, 1);
  }

  /** Marks a node by a dot and an element by its outline (pairs of nodes). */
  setMarks(node: number | null, outline: number[], cell: number): void {
    for (const mark of this.marks) {
      this.group.remove(mark);
      (mark as Mesh<BufferGeometry>).geometry.dispose();
    }
    this.marks = [];
    const part = this.facts.part[cell];
    const style = (tint: Vector4, own: Record<string, unknown>) => {
      const material = this.plain(tint, { section: new Vector4(0, 0, 0, 1), ...own });
      material.depthTest = false;
      return material;
    };
    const front = <Kind extends Object3D>(mark: Kind) => {
      mark.renderOrder = 10;
      this.marks.push(this.add(mark, this.group));
    };
    if (outline.length > 0)
      front(new LineSegments(markGeometry(outline, part), style(new Vector4(1, 1, 1, 1), {})));
    if (node !== null) {
      front(new Points(markGeometry([node], part), style(new Vector4(0, 0, 0, 1), { round: true, pointSize: 13 })));
      front(new Points(markGeometry([node], part), style(new Vector4(1, 1, 1, 1), { round: true, pointSize: 9 })));
    }
  }

  /** Ball around all nodes of a frame, in the world of three. */
  ball(frame: number): Sphere {
    const codes = this.run.positions[frame];
    const low = [65535, 65535, 65535];
    const high = [0, 0, 0];
    for (let node = 0; node < this.run.meta.nodes; ++node)
      for (let axis = 0; axis < 3; ++axis) {
        const code = codes[4 * node + axis];
        if (code < low[axis]) low[axis] = code;
        if (code > high[axis]) high[axis] = code;
      }
    const corner = (place: number[]) =>
      this.toWorld(place.map((code, axis) => this.run.axes[axis].value(Math.max(1, code))) as [number, number, number]);
    const ends = [corner(low), corner(high)];
    return new Sphere(ends[0].clone().add(ends[1]).multiplyScalar(0.5), ends[0].distanceTo(ends[1]) / 2);
  }

  /** A point of the world of three in the model. */
  toModel(point: Vector3): [number, number, number] {
    return point.clone().multiplyScalar(this.diagonal).add(this.centre).toArray();
  }

  /** A point of the model in the world of three. */
  toWorld(point: [number, number, number]): Vector3 {
    return new Vector3(...point).sub(this.centre).divideScalar(this.diagonal);
  }
}
