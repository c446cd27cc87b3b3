import { h } from './dom';

/** What `make` makes; null, and a hint in `box`, where the browser does not draw in 3D: all else is
 * of use without. */
export function withWebgl<T>(box: HTMLElement, make: () => T): T | null {
  try {
    return make();
  } catch (error) {
    if (!/webgl/i.test(String(error))) throw error;
    const hint =
      'This browser does not draw in 3D (WebGL). Try another one, or switch hardware acceleration on.';
    box.replaceChildren(h('p', { class: 'no-webgl' }, hint));
    return null;
  }
}
