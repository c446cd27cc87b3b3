import type { Result } from '../data/result';
import { NONE } from '../data/shape';
import type { Point, State } from '../state';
import { h } from './dom';
import { number } from './format';

const MOUSE_HINT =
  'Point at a shape to see where a vertex goes; click to keep it, Escape lets go. Drag to turn, Shift and drag to shift; the wheel zooms after a click or with Ctrl; arrow keys, + − and 0 do it too.';
const TOUCH_HINT =
  'Tap a shape to see where a vertex goes; tap beside it to let go. One finger turns, two zoom and shift.';

/** How to use the shapes with what the viewer has at hand. */
export const hint = (touch: boolean): string => (touch ? TOUCH_HINT : MOUSE_HINT);

export const hasTouch = (): boolean => matchMedia('(hover: none) and (pointer: coarse)').matches;

/** A vertex, its partner and their numbers. */
export function describePoint(result: Result, state: State, point: Point): string {
  const map = result.map(state.map);
  const { numbers } = result.shape(point.side);
  const own = `${point.side} vertex ${numbers[point.vertex]}`;
  const partner = (point.side === 'source' ? map.partner : map.back)[point.vertex]!;
  if (partner === NONE) return `${own} has no match.`;
  const other = point.side === 'source' ? 'target' : 'source';
  const source = point.side === 'source' ? point.vertex : partner;
  const parts = [`${own} ↔ ${other} vertex ${result.shape(other).numbers[partner]}`];
  parts.push(`d_iso ${number(map.dIso[source]!)}`);
  if (map.confidence) parts.push(`confidence ${number(map.confidence[point.side][point.vertex]!)}`);
  if (map.error) parts.push(`ground-truth error ${number(map.error[source]!)} of √area`);
  return parts.join('  ·  ');
}

/** Tells of the vertex under the pointer or clicked on, or how to point at one. */
export class PointPanel {
  readonly element = h('p', { class: 'point', id: 'point', role: 'status' });

  show(result: Result, state: State): void {
    const point = state.hovered ?? state.selected;
    this.element.textContent = point ? describePoint(result, state, point) : hint(hasTouch());
    this.element.classList.toggle('hint', !point);
  }
}
