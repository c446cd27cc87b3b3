import { describe, expect, it } from 'vitest';
import type { State } from '../../src/state';
import { Store } from '../../src/store';

const state: State = {
  coloring: 'map',
  map: 0,
  level: 3,
  layout: 'pair',
  linked: true,
  morph: 0,
  lines: 0,
  worstIso: false,
  worstTruth: false,
  hovered: null,
  selected: null,
};

describe('the store', () => {
  it('tells what changed, and nothing if nothing did', () => {
    const store = new Store(state);
    const changes: string[] = [];
    store.listen((_, changed) => changes.push([...changed].join(' ')));
    store.set({ morph: 0 });
    store.set({ morph: 1, lines: 10, linked: true });
    expect(changes).toEqual(['morph lines']);
    expect(store.state.lines).toBe(10);
  });
});
