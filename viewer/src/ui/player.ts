import type { PairStore } from '../state';
import { h } from './dom';

const DURATION = 2000;

/** A button that moves the source to the target's pose, or back, and stops when clicked again or
 * when the pose is changed otherwise. */
export function playButton(store: PairStore): HTMLElement {
  const button = h('button', { type: 'button', id: 'play', click: () => toggle() }, 'Play');
  let frame = 0;
  let shown = NaN;

  const stop = () => {
    cancelAnimationFrame(frame);
    frame = 0;
    button.textContent = 'Play';
  };
  const start = () => {
    const from = store.state.morph;
    const to = from < 0.5 ? 1 : 0;
    const begun = performance.now();
    const step = (now: number) => {
      const share = Math.min(1, Math.max(0, (now - begun) / DURATION));
      shown = from + (to - from) * share * share * (3 - 2 * share);
      frame = requestAnimationFrame(step);
      store.set({ morph: shown });
      if (share === 1) stop();
    };
    button.textContent = 'Stop';
    frame = requestAnimationFrame(step);
  };
  const toggle = () => (frame ? stop() : start());
  store.listen(({ morph }, changed) => {
    if (frame && changed.has('morph') && morph !== shown) stop();
  });
  return button;
}
