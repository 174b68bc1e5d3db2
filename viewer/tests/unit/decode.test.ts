// SPDX-License-Identifier: BSD-3-Clause
import { zlibSync } from "fflate";
import { describe, expect, it } from "vitest";
import { FrameUnpacker, inflated, Scale, unpackIntegers } from "../../src/payload/decode";

/** Packs as crumple/report/packing.cpp does. */
function pack(codes: number[], bits: 8 | 16, prediction: number, before: number[], beforeThat: number[]): Uint8Array {
  const size = 2 ** bits;
  const bytes = new Uint8Array(1 + codes.length * (bits / 8));
  bytes[0] = prediction;
  let left = 0;
  codes.forEach((code, i) => {
    let rest = code;
    if ((prediction & 3) === 1) rest -= before[i];
    if ((prediction & 3) === 2) rest -= 2 * before[i] - beforeThat[i];
    const own = prediction & 4 ? rest - left : rest;
    left = rest;
    let wrapped = ((own % size) + size) % size;
    if (wrapped >= size / 2) wrapped -= size;
    const folded = wrapped >= 0 ? 2 * wrapped : -2 * wrapped - 1;
    bytes[1 + i] = folded & 255;
    if (bits === 16) bytes[1 + codes.length + i] = folded >> 8;
  });
  return bytes;
}

describe("frames", () => {
  for (const bits of [8, 16] as const)
    it(`of ${bits} bits come back for every prediction`, () => {
      const count = 300;
      const unpacker = new FrameUnpacker(count, bits);
      let before: number[] = [];
      let beforeThat: number[] = [];
      let seed = 7;
      [0, 4, 1, 5, 2, 6, 2, 5].forEach((prediction, frame) => {
        const codes = Array.from({ length: count }, () => (seed = (seed * 16807) % 2147483647) % 2 ** bits);
        if (frame === 6) codes.fill(2 ** bits - 1);
        expect([...unpacker.next(pack(codes, bits, prediction, before, beforeThat))]).toEqual(codes);
        [beforeThat, before] = [before, codes];
      });
    });

  it("lie behind each other in one array", () => {
    const unpacker = new FrameUnpacker(2, 16);
    const bytes = new Uint8Array([9, 9, ...pack([500, 70], 16, 0, [], [])]);
    expect([...unpacker.next(bytes, 2)]).toEqual([500, 70]);
    expect(unpacker.size).toBe(5);
  });
});

describe("integers", () => {
  it("come back, those beyond 32 bits as well", () => {
    // 5, 4, 68, and then up to the largest exact integer.
    expect(unpackIntegers(new Uint8Array([0x0a, 0x01, 0x80, 0x01]))).toEqual([5, 4, 68]);
    const large = 2 ** 53 - 1;
    const bytes: number[] = [];
    let folded = 2n * BigInt(large);
    for (; folded > 127n; folded >>= 7n) bytes.push(Number(128n | (folded & 127n)));
    bytes.push(Number(folded), 0x01);
    expect(unpackIntegers(new Uint8Array(bytes)).map((value) => Math.abs(value - large) <= 2)).toEqual([true, true]);
  });

  it("of nothing are nothing", () => expect(unpackIntegers(new Uint8Array())).toEqual([]));
});

describe("values", () => {
  it("divide the range evenly; code 0 is none", () => {
    const scale = new Scale(-2, 6, 8);
    expect(scale.value(0)).toBeNaN();
    expect(scale.value(1)).toBe(-2);
    expect(scale.value(255)).toBeCloseTo(6, 12);
  });

  it("unpack from base64", () => {
    const text = "some text, some text, some text";
    const base64 = btoa(String.fromCharCode(...zlibSync(new TextEncoder().encode(text))));
    expect(new TextDecoder().decode(inflated(base64))).toBe(text);
  });
});
