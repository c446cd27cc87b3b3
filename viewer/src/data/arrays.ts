import type { ArrayEntry } from './manifest';

export type Arrays = (name: string) => Uint32Array;

export const unzigzag = (value: number): number => (value >>> 1) ^ -(value & 1);

function decodeBase64(text: string): Uint8Array<ArrayBuffer> {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

async function inflate(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array> {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Puts together the bytes of each value, stored plane by plane from the lowest. */
function fromPlanes(bytes: Uint8Array, entry: ArrayEntry, start: number): Uint32Array {
  const values = new Uint32Array(entry.count);
  for (let plane = 0; plane < entry.planes; ++plane) {
    const offset = start + plane * entry.count;
    for (let i = 0; i < entry.count; ++i) values[i]! |= bytes[offset + i]! << (8 * plane);
  }
  return values;
}

function sumUp(differences: Uint32Array): void {
  let value = 0;
  for (let i = 0; i < differences.length; ++i) {
    value = (value + unzigzag(differences[i]!)) >>> 0;
    differences[i] = value;
  }
}

/** Unpacks what an `ArrayPacker` (results/page/array_packer.h) packed; arrays are decoded on demand. */
export async function unpack(text: string, directory: ArrayEntry[]): Promise<Arrays> {
  const bytes = await inflate(decodeBase64(text.trim()));
  const places = new Map<string, { entry: ArrayEntry; start: number }>();
  let start = 0;
  for (const entry of directory) {
    places.set(entry.name, { entry, start });
    start += entry.count * entry.planes;
  }
  if (start !== bytes.length) throw new Error('the data of this page is incomplete');
  return (name) => {
    const place = places.get(name);
    if (!place) throw new Error(`this page has no data named ${name}`);
    const values = fromPlanes(bytes, place.entry, place.start);
    if (place.entry.delta) sumUp(values);
    return values;
  };
}
