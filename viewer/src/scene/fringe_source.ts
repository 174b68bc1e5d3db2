// SPDX-License-Identifier: BSD-3-Clause
import type { Run } from "../payload/run";

/** Stands for "no value" in textures. */
export const nothing = 3e38;

/** A scalar over the run, of each node or each cell. */
export interface FringeSource {
  name: string;
  byNode: boolean;
  /** over the run */
  range(): [number, number];
  frameRange(frame: number): [number, number];
  fill(frame: number, values: Float32Array): void;
  /** not a number where there is no value */
  at(frame: number, item: number): number;
}

class StoredField implements FringeSource {
  readonly byNode: boolean;

  constructor(
    private readonly run: Run,
    readonly name: string,
  ) {
    this.byNode = run.fieldMeta(name)!.by_node;
  }

  range(): [number, number] {
    const meta = this.run.fieldMeta(this.name)!;
    return [meta.low, meta.high];
  }

  frameRange(frame: number): [number, number] {
    const field = this.run.field(this.name);
    const codes = field.frames[frame];
    let low = 65535;
    let high = 0;
    for (let item = 0; item < codes.length; ++item) {
      if (codes[item] === 0 || (!this.byNode && frame >= this.run.death[item])) continue;
      low = Math.min(low, codes[item]);
      high = Math.max(high, codes[item]);
    }
    return high === 0 ? [0, 0] : [field.scale.value(low), field.scale.value(high)];
  }

  fill(frame: number, values: Float32Array): void {
    const field = this.run.field(this.name);
    const codes = field.frames[frame];
    const { low, step } = field.scale;
    for (let item = 0; item < codes.length; ++item)
      values[item] = codes[item] === 0 ? nothing : low + step * (codes[item] - 1);
  }

  at(frame: number, item: number): number {
    const field = this.run.field(this.name);
    return field.scale.value(field.frames[frame][item]);
  }
}

/** Displacement since the first frame, its size or one of its components. */
class Displacement implements FringeSource {
  readonly byNode = true;
  private known: [number, number] | null = null;

  constructor(
    private readonly run: Run,
    readonly name: string,
    private readonly axis: number | null,
  ) {}

  at(frame: number, node: number): number {
    const now = this.run.positions[frame];
    const start = this.run.positions[0];
    const along = (axis: number) => (now[4 * node + axis] - start[4 * node + axis]) * this.run.axes[axis].step;
    return this.axis === null ? Math.hypot(along(0), along(1), along(2)) : along(this.axis);
  }

  fill(frame: number, values: Float32Array): void {
    for (let node = 0; node < this.run.meta.nodes; ++node) values[node] = this.at(frame, node);
  }

  frameRange(frame: number): [number, number] {
    let low = Infinity;
    let high = -Infinity;
    for (let node = 0; node < this.run.meta.nodes; ++node) {
      const value = this.at(frame, node);
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
    return low <= high ? [low, high] : [0, 0];
  }

  range(): [number, number] {
    if (!this.known) {
      this.known = [Infinity, -Infinity];
      for (let frame = 0; frame < this.run.frames; ++frame) {
        const [low, high] = this.frameRange(frame);
        this.known = [Math.min(this.known[0], low), Math.max(this.known[1], high)];
      }
    }
    return this.known;
  }
}

/** All that can be shown, the most asked for first. */
export function fringeSources(run: Run): FringeSource[] {
  const stored = run.meta.fields.map((field) => new StoredField(run, field.name));
  const moved = ["", "_x", "_y", "_z"].map((end, i) => new Displacement(run, "displacement" + end, i === 0 ? null : i - 1));
  const order = ["plastic_strain", "von_mises", "von_mises_mid", "thickness", "pressure"];
  const rank = (source: FringeSource) => {
    const place = order.indexOf(source.name);
    return place >= 0 ? place : source.byNode ? 20 : 30;
  };
  return [...stored, ...moved].sort((a, b) => rank(a) - rank(b));
}
