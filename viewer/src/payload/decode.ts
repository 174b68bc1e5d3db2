// SPDX-License-Identifier: BSD-3-Clause
// The inverse of crumple/report/packing.cpp and quantiser.cpp.
import { unzlibSync } from "fflate";

export function bytesOfBase64(text: string): Uint8Array {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

export function inflated(text: string): Uint8Array {
  return unzlibSync(bytesOfBase64(text));
}

/** Integers that were written as differences in groups of seven bits; beyond 32 bits they are exact to 2^53. */
export function unpackIntegers(bytes: Uint8Array): number[] {
  const values: number[] = [];
  let before = 0;
  for (let i = 0; i < bytes.length; ) {
    let folded = 0;
    let weight = 1;
    let byte: number;
    do {
      byte = bytes[i++];
      folded += (byte & 127) * weight;
      weight *= 128;
    } while (byte & 128);
    before += folded % 2 === 0 ? folded / 2 : -(folded + 1) / 2;
    values.push(before);
  }
  return values;
}

export type Codes = Uint8Array | Uint16Array;

/** Frames of one quantity, to be decoded in their order. */
export class FrameUnpacker {
  private before: Codes | null = null;
  private beforeThat: Codes | null = null;

  constructor(
    private readonly count: number,
    private readonly bits: 8 | 16,
  ) {}

  /** Bytes that a frame takes. */
  get size(): number {
    return 1 + this.count * (this.bits / 8);
  }

  next(bytes: Uint8Array, start = 0): Codes {
    const { count, bits } = this;
    const codes: Codes = bits === 8 ? new Uint8Array(count) : new Uint16Array(count);
    const prediction = bytes[start];
    const neighbour = (prediction & 4) !== 0;
    const inTime = prediction & 3;
    const low = start + 1;
    const high = low + count;
    const before = this.before;
    const beforeThat = this.beforeThat;
    let left = 0;
    for (let i = 0; i < count; ++i) {
      const folded = bits === 8 ? bytes[low + i] : bytes[low + i] | (bytes[high + i] << 8);
      let rest = (folded >>> 1) ^ -(folded & 1);
      if (neighbour) rest += left;
      left = rest;
      if (inTime === 1) rest += before![i];
      else if (inTime === 2) rest += 2 * before![i] - beforeThat![i];
      codes[i] = rest; // wraps around as the writer does
    }
    this.beforeThat = before;
    this.before = codes;
    return codes;
  }
}

/** What a code stands for: code 0 is no value, the others divide the range evenly. */
export class Scale {
  readonly step: number;

  constructor(
    readonly low: number,
    readonly high: number,
    readonly bits: 8 | 16,
  ) {
    this.step = (high - low) / (2 ** bits - 2);
  }

  value(code: number): number {
    return code === 0 ? NaN : this.low + this.step * (code - 1);
  }
}
