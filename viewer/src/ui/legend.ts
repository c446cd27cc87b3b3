import { css } from '../color/oklab';
import type { Range } from '../color/paint';
import { h } from './dom';
import { number } from './format';

const STEPS = 16;

/** How to read the colours, and their scale. */
export class Legend {
  readonly element = h('div', { class: 'legend', 'aria-live': 'polite' });

  show(help: string, range: Range | null): void {
    this.element.replaceChildren();
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
    this.element.append(h('p', {}, help));
  }
}
