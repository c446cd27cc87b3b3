import type { Colors } from '../color/coloring';
import { css } from '../color/oklab';
import type { Coloring } from '../state';
import { helpOf } from './controls';
import { h } from './dom';
import { number } from './format';

const STEPS = 16;

/** How to read the colours, and their scale. */
export class Legend {
  readonly element = h('div', { class: 'legend', 'aria-live': 'polite' });

  show(coloring: Coloring, colors: Colors | null): void {
    this.element.replaceChildren();
    const range = colors?.range;
    if (range) {
      const stops = Array.from({ length: STEPS + 1 }, (_, i) => css(range.scale(i / STEPS)));
      this.element.append(
        h(
          'div',
          { class: 'scale' },
          h('span', {}, number(range.low)),
          h('i', { style: `background:linear-gradient(90deg,${stops.join(',')})` }),
          h('span', {}, (range.open ? '≥ ' : '') + number(range.high)),
        ),
      );
    }
    this.element.append(h('p', {}, helpOf(coloring)));
  }
}
