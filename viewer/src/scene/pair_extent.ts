import type { Result } from '../data/result';
import { Extent } from './extent';

/** Both shapes, and the source in each pose that it is bent into. */
export function extentOf(result: Result): Extent {
  const places = [result.source.position, result.target.position];
  for (let k = 0; k < result.numMaps; ++k) places.push(result.map(k).registered);
  return new Extent(places);
}
