// SPDX-License-Identifier: BSD-3-Clause
import { BufferAttribute, BufferGeometry, Float32BufferAttribute, Uint32BufferAttribute } from "three";
import type { Mesh } from "../payload/run";

/** What geometry needs to know of the cells. */
export interface CellFacts {
  /** place of each cell's part in the list of parts */
  part: Uint32Array;
  death: Int32Array;
  frames: number;
}

class Vertices {
  readonly items: Uint32Array;
  readonly life: Float32Array;
  private count = 0;

  constructor(count: number) {
    this.items = new Uint32Array(4 * count);
    this.life = new Float32Array(2 * count);
  }

  add(node: number, cell: number, part: number, face: number, birth: number, death: number): void {
    this.items.set([node, cell, part, face], 4 * this.count);
    this.life.set([birth, death], 2 * this.count);
    ++this.count;
  }

  geometry(): BufferGeometry {
    const geometry = new BufferGeometry();
    geometry.setAttribute("items", new Uint32BufferAttribute(this.items, 4));
    geometry.setAttribute("life", new Float32BufferAttribute(this.life, 2));
    geometry.setDrawRange(0, this.count);
    return geometry;
  }
}

/** Access to the columns of Run's face list. */
export class Faces {
  readonly count: number;
  constructor(private readonly mesh: Mesh) {
    this.count = mesh.faceCount;
  }
  node(face: number, corner: number): number {
    return this.mesh.faces[corner * this.count + face];
  }
  cell(face: number): number {
    return this.mesh.faces[4 * this.count + face];
  }
  behind(face: number): number {
    return this.mesh.faces[5 * this.count + face];
  }
  corners(face: number): number {
    return this.node(face, 3) === this.node(face, 2) ? 3 : 4;
  }
}

export class Lines {
  readonly count: number;
  constructor(private readonly mesh: Mesh) {
    this.count = mesh.lineCount;
  }
  node(line: number, end: number): number {
    return this.mesh.lines[end * this.count + line];
  }
  cell(line: number): number {
    return this.mesh.lines[2 * this.count + line];
  }
}

function birthOf(faces: Faces, face: number, facts: CellFacts): number {
  const behind = faces.behind(face);
  return behind < 0 ? 0 : facts.death[behind];
}

export function faceGeometry(mesh: Mesh, facts: CellFacts): BufferGeometry {
  const faces = new Faces(mesh);
  let corners = 0;
  let triangles = 0;
  for (let face = 0; face < faces.count; ++face) {
    corners += faces.corners(face);
    triangles += faces.corners(face) - 2;
  }
  const vertices = new Vertices(corners);
  const index = new Uint32Array(3 * triangles);
  let vertex = 0;
  let at = 0;
  for (let face = 0; face < faces.count; ++face) {
    const cell = faces.cell(face);
    const count = faces.corners(face);
    for (let corner = 0; corner < count; ++corner)
      vertices.add(faces.node(face, corner), cell, facts.part[cell], face, birthOf(faces, face, facts), facts.death[cell]);
    for (let corner = 2; corner < count; ++corner) {
      index[at++] = vertex;
      index[at++] = vertex + corner - 1;
      index[at++] = vertex + corner;
    }
    vertex += count;
  }
  const geometry = vertices.geometry();
  geometry.setDrawRange(0, Infinity);
  geometry.setIndex(new BufferAttribute(index, 1));
  return geometry;
}

export function lineGeometry(mesh: Mesh, facts: CellFacts): BufferGeometry {
  const lines = new Lines(mesh);
  const vertices = new Vertices(2 * lines.count);
  for (let line = 0; line < lines.count; ++line) {
    const cell = lines.cell(line);
    for (const end of [0, 1])
      vertices.add(lines.node(line, end), cell, facts.part[cell], mesh.faceCount + line, 0, facts.death[cell]);
  }
  return vertices.geometry();
}

/** Edges of all faces. What two lasting faces of a part share is drawn once; faces that come or go keep their
 * own, since an edge must stay as long as one of its faces is there. */
export function edgeGeometry(mesh: Mesh, facts: CellFacts, nodes: number): BufferGeometry {
  const faces = new Faces(mesh);
  const parts = 1 + facts.part.reduce((most, part) => Math.max(most, part), 0);
  const known = new Set<number>();
  const chosen: number[] = []; // face and corner of each edge
  for (let face = 0; face < faces.count; ++face) {
    const cell = faces.cell(face);
    const count = faces.corners(face);
    const lasting = facts.death[cell] >= facts.frames && faces.behind(face) < 0;
    for (let corner = 0; corner < count; ++corner) {
      const a = faces.node(face, corner);
      const b = faces.node(face, (corner + 1) % count);
      if (a === b) continue;
      if (lasting) {
        const key = (Math.min(a, b) * nodes + Math.max(a, b)) * parts + facts.part[cell];
        if (known.has(key)) continue;
        known.add(key);
      }
      chosen.push(face, corner);
    }
  }
  const vertices = new Vertices(chosen.length);
  for (let i = 0; i < chosen.length; i += 2) {
    const face = chosen[i];
    const cell = faces.cell(face);
    const count = faces.corners(face);
    for (const corner of [chosen[i + 1], (chosen[i + 1] + 1) % count])
      vertices.add(faces.node(face, corner), cell, facts.part[cell], face, birthOf(faces, face, facts), facts.death[cell]);
  }
  return vertices.geometry();
}

/** Marks of picked nodes or the outline of a picked element: given nodes, seen in all frames. */
export function markGeometry(nodes: number[], part: number): BufferGeometry {
  const vertices = new Vertices(nodes.length);
  for (const node of nodes) vertices.add(node, 0, part, 0, 0, 1e9);
  return vertices.geometry();
}
