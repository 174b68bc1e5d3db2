// SPDX-License-Identifier: BSD-3-Clause
import {
  DataTexture,
  FloatType,
  NearestFilter,
  RedFormat,
  RGBAIntegerFormat,
  UnsignedShortType,
  type PixelFormat,
  type TextureDataType,
} from "three";

const width = 1024;

function makeTexture(
  array: Uint16Array | Float32Array,
  format: PixelFormat,
  type: TextureDataType,
  internal: "RGBA16UI" | "R32F",
): DataTexture {
  const perTexel = internal === "RGBA16UI" ? 4 : 1;
  const texture = new DataTexture(array, width, array.length / perTexel / width, format, type);
  texture.internalFormat = internal;
  texture.minFilter = NearestFilter;
  texture.magFilter = NearestFilter;
  texture.generateMipmaps = false;
  texture.needsUpdate = true;
  return texture;
}

const padded = (items: number): number => Math.max(1, Math.ceil(items / width)) * width;

/** Codes of the nodes' positions in one frame. */
export class PositionTexture {
  readonly texture: DataTexture;
  private readonly array: Uint16Array;
  private frame = -1;

  constructor(nodes: number) {
    this.array = new Uint16Array(4 * padded(nodes));
    this.texture = makeTexture(this.array, RGBAIntegerFormat, UnsignedShortType, "RGBA16UI");
  }

  holds(frame: number): boolean {
    return this.frame === frame;
  }

  set(frame: number, codes: Uint16Array): void {
    if (this.frame === frame) return;
    this.array.set(codes);
    this.frame = frame;
    this.texture.needsUpdate = true;
  }
}

/** A number per node or cell. */
export class ValueTexture {
  readonly texture: DataTexture;
  readonly array: Float32Array;

  constructor(items: number) {
    this.array = new Float32Array(padded(items));
    this.texture = makeTexture(this.array, RedFormat, FloatType, "R32F");
  }

  changed(): void {
    this.texture.needsUpdate = true;
  }
}
