// SPDX-License-Identifier: BSD-3-Clause
import { parseBands, type Band } from "./bands";
import { FrameUnpacker, inflated, Scale, unpackIntegers, type Codes } from "./decode";
import { parseHistory, type History } from "./history";
import type { FieldMeta, Meta } from "./meta";

/** Takes packed arrays by name, as the page holds them; null if there is none. */
export type Source = (name: string) => string | null;

/** A face (quadrilateral, or triangle with its last two nodes the same) or a line, by places in Run's arrays. */
export interface Mesh {
  faceCount: number;
  /** first nodes of all faces, second ones, third, fourth, then cells, then cells behind (-1 is none) */
  faces: Int32Array;
  lineCount: number;
  /** first nodes of all lines, second ones, then cells */
  lines: Int32Array;
}

/** A field over the run: codes of every frame. */
export interface Field {
  name: string;
  byNode: boolean;
  scale: Scale;
  frames: Codes[];
}

/** Yields so that the page can show how far it is. */
const pause = (): Promise<void> => new Promise((resolve) => setTimeout(resolve, 0));

/** A run's result, unpacked. Positions are there from the start, fields come when they are asked for. */
export class Run {
  readonly mesh: Mesh;
  readonly nodeId: number[];
  readonly elementId: number[];
  readonly part: number[];
  readonly cellType: number[];
  /** first frame in which each cell has failed */
  readonly death: Int32Array;
  readonly axes: Scale[];
  /** by frame: four codes a node (x, y, z and an unused one), as the graphics card takes them */
  readonly positions: Uint16Array[] = [];
  private readonly fields = new Map<string, Field>();
  private readonly histories = new Map<string, History>();
  private readonly bands = new Map<string, Map<string, Band>>();

  constructor(
    readonly meta: Meta,
    private readonly source: Source,
  ) {
    if (meta.format !== 1) throw new Error(`This page shows format 1, the result is in format ${meta.format}.`);
    const integers = (name: string) => unpackIntegers(this.bytes(name));
    this.nodeId = integers("node_id");
    this.elementId = integers("element_id");
    this.part = integers("part");
    this.cellType = integers("type");
    this.death = Int32Array.from(integers("death"));
    this.mesh = {
      faceCount: meta.faces,
      faces: Int32Array.from(integers("faces")),
      lineCount: meta.lines,
      lines: Int32Array.from(integers("lines")),
    };
    this.axes = [0, 1, 2].map((axis) => new Scale(meta.box.low[axis], meta.box.high[axis], 16));
  }

  get frames(): number {
    return this.meta.times.length;
  }

  private bytes(name: string): Uint8Array {
    const text = this.source(name);
    if (text === null) throw new Error(`The page lacks its data ${name}.`);
    return inflated(text);
  }

  private text(name: string): string {
    return new TextDecoder().decode(this.bytes(name));
  }

  async loadPositions(progress: (share: number) => void): Promise<void> {
    const nodes = this.meta.nodes;
    const unpackers = this.axes.map(() => new FrameUnpacker(nodes, 16));
    for (let frame = 0; frame < this.frames; ++frame) {
      const bytes = this.bytes(`position_${frame}`);
      const codes = new Uint16Array(4 * nodes);
      unpackers.forEach((unpacker, axis) => {
        const values = unpacker.next(bytes, axis * unpacker.size);
        for (let node = 0; node < nodes; ++node) codes[4 * node + axis] = values[node];
      });
      this.positions.push(codes);
      if (frame % 8 === 7) {
        progress((frame + 1) / this.frames);
        await pause();
      }
    }
  }

  fieldMeta(name: string): FieldMeta | undefined {
    return this.meta.fields.find((field) => field.name === name);
  }

  field(name: string): Field {
    const known = this.fields.get(name);
    if (known) return known;
    const place = this.meta.fields.findIndex((field) => field.name === name);
    if (place < 0) throw new Error(`There is no field ${name}.`);
    const meta = this.meta.fields[place];
    const unpacker = new FrameUnpacker(meta.by_node ? this.meta.nodes : this.meta.cells, meta.bits);
    const frames: Codes[] = [];
    for (let frame = 0; frame < this.frames; ++frame)
      frames.push(unpacker.next(this.bytes(`field${place}_${frame}`)));
    const field = { name, byNode: meta.by_node, scale: new Scale(meta.low, meta.high, meta.bits), frames };
    this.fields.set(name, field);
    return field;
  }

  /** Position of a node [length]. */
  position(frame: number, node: number): [number, number, number] {
    const codes = this.positions[frame];
    const at = (axis: number) => this.axes[axis].value(codes[4 * node + axis]);
    return [at(0), at(1), at(2)];
  }

  /** A history by the name of its file; null if the run has none. */
  history(file: string): History | null {
    const known = this.histories.get(file);
    if (known) return known;
    const place = this.meta.tables.findIndex((table) => table.name === file);
    if (place < 0) return null;
    const history = parseHistory(this.text(`table${place}`), file.replace(/\.csv$/, ""));
    this.histories.set(file, history);
    return history;
  }

  /** The band of a curve by its name (curveName); null if it has none or this is no run of `crumple scatter`. */
  band(curve: string): Band | null {
    const group = curve.slice(0, curve.indexOf("."));
    const place = this.meta.scatter?.histories.findIndex((history) => history.name === group) ?? -1;
    if (place < 0) return null;
    let bands = this.bands.get(group);
    if (!bands) this.bands.set(group, (bands = parseBands(this.text(`bands${place}`))));
    return bands.get(curve) ?? null;
  }
}
