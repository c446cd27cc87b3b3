import { deflateSync } from 'node:zlib';
import { describe, expect, it } from 'vitest';
import { unpack, unzigzag } from '../../src/data/arrays';
import type { ArrayEntry } from '../../src/data/manifest';

const pack = (bytes: number[]): string => deflateSync(Uint8Array.from(bytes)).toString('base64');

const entry = (name: string, count: number, planes: number, delta = false): ArrayEntry => ({
  name,
  count,
  planes,
  bytes: planes,
  delta,
});

describe('unzigzag', () => {
  it('undoes the interleaving of signs', () => {
    expect([0, 1, 2, 3, 4].map(unzigzag)).toEqual([0, -1, 1, -2, 2]);
    expect(unzigzag(0xffffffff)).toBe(-0x80000000);
  });
});

// The same bytes as in tests/tools/array_packer_test.cpp.
describe('unpack', () => {
  it('puts planes of bytes together', async () => {
    const arrays = await unpack(pack([2, 4, 1, 3, 7]), [entry('a', 2, 2), entry('b', 1, 1)]);
    expect([...arrays('a')]).toEqual([0x0102, 0x0304]);
    expect([...arrays('b')]).toEqual([7]);
  });

  it('sums up differences', async () => {
    const packed = pack([0xfe, 0xfd, 0xff, 0xff, 0x01, 0x01]);
    const arrays = await unpack(packed, [entry('a', 2, 3, true)]);
    expect([...arrays('a')]).toEqual([65535, 0]);
  });

  it('keeps numbers of 32 bits positive', async () => {
    const arrays = await unpack(pack([255, 255, 255, 255]), [entry('a', 1, 4)]);
    expect(arrays('a')[0]).toBe(0xffffffff);
  });

  it('refuses data that are cut off, and names it does not know', async () => {
    await expect(unpack(pack([1, 2]), [entry('a', 3, 1)])).rejects.toThrow('incomplete');
    const arrays = await unpack(pack([1]), [entry('a', 1, 1)]);
    expect(() => arrays('b')).toThrow('no data named b');
  });
});
