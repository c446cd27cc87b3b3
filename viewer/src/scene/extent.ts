import { FIELD_OF_VIEW } from './orbit';

/** More than one leaves a margin. */
const MARGIN = 1.08;

/** What has to be in sight. */
export class Extent {
  private readonly known = new Map<number, number>();

  /** Points in the viewer's coordinates. */
  constructor(private readonly places: ArrayLike<number>[]) {}

  /** From how far away all is within a view of this width over height. */
  distance(aspect: number): number {
    const known = this.known.get(aspect);
    if (known !== undefined) return known;
    const up = Math.tan((FIELD_OF_VIEW * Math.PI) / 360) / MARGIN;
    let distance = 0;
    for (const place of this.places) {
      for (let i = 0; i < place.length; i += 3) {
        const away = Math.max(Math.abs(place[i]!) / aspect, Math.abs(place[i + 1]!)) / up;
        distance = Math.max(distance, away + place[i + 2]!);
      }
    }
    this.known.set(aspect, distance);
    return distance;
  }
}
