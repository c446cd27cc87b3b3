import { NONE, type Result } from '../data/result';
import type { State } from '../state';
import { h } from './dom';
import { number } from './format';

const HINT =
  'Point at a shape to see where a vertex goes; click to keep it. Drag to turn, wheel or pinch to zoom, Shift and drag to shift; arrow keys, + − and 0 do it too.';

/** The vertex under the pointer or clicked on, its partner and their numbers. */
export function describePoint(result: Result, state: State): string {
  const point = state.hovered ?? state.selected;
  if (!point) return HINT;
  const map = result.map(state.map);
  const { numbers } = result.shape(point.side);
  const own = `${point.side} vertex ${numbers[point.vertex]}`;
  const partner = (point.side === 'source' ? map.partner : map.back)[point.vertex]!;
  if (partner === NONE) return `${own} has no match.`;
  const other = point.side === 'source' ? 'target' : 'source';
  const source = point.side === 'source' ? point.vertex : partner;
  const parts = [`${own} ↔ ${other} vertex ${result.shape(other).numbers[partner]}`];
  parts.push(`d_iso ${number(map.dIso[source]!)}`);
  if (map.error) parts.push(`ground-truth error ${number(map.error[source]!)} of √area`);
  return parts.join('  ·  ');
}

export class PointPanel {
  readonly element = h('p', { class: 'point', id: 'point', role: 'status' });

  show(result: Result, state: State): void {
    this.element.textContent = describePoint(result, state);
    this.element.classList.toggle('hint', !(state.hovered ?? state.selected));
  }
}
