import { svg } from './dom';
import { number } from './format';

const WIDTH = 360;
const HEIGHT = 210;
const LEFT = 48;
const RIGHT = 12;
const TOP = 10;
const BOTTOM = 40;

export interface Axis {
  label: string;
  low: number;
  high: number;
  format?: (value: number) => string;
  /** Only whole numbers are marked. */
  whole?: boolean;
}

/** Round numbers that divide [low, high] into about `count` parts. */
export function ticks(low: number, high: number, count = 4): number[] {
  const span = high - low;
  if (!(span > 0)) return [low];
  const raw = span / count;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = power * ([1, 2, 5, 10].find((factor) => factor * power >= raw) ?? 10);
  const marks: number[] = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * span; ++i)
    marks.push(Number((i * step).toPrecision(12)));
  return marks;
}

/** An empty plot with axes, to which marks are added. */
export class Chart {
  readonly element: SVGElement;

  constructor(
    title: string,
    private readonly x: Axis,
    private readonly y: Axis,
  ) {
    this.element = svg('svg', {
      viewBox: `0 0 ${WIDTH} ${HEIGHT}`,
      role: 'img',
      'aria-label': title,
      class: 'chart',
    });
    this.drawX();
    this.drawY();
  }

  placeX(value: number): number {
    const share = (value - this.x.low) / (this.x.high - this.x.low || 1);
    return LEFT + share * (WIDTH - LEFT - RIGHT);
  }

  placeY(value: number): number {
    const share = (value - this.y.low) / (this.y.high - this.y.low || 1);
    return HEIGHT - BOTTOM - share * (HEIGHT - TOP - BOTTOM);
  }

  line(points: [number, number][]): void {
    const path = points.map(
      ([x, y]) => `${this.placeX(x).toFixed(1)},${this.placeY(y).toFixed(1)}`,
    );
    this.element.append(svg('polyline', { points: path.join(' '), class: 'line' }));
  }

  dot(x: number, y: number, tooltip: string, highlighted = false): SVGElement {
    const mark = svg(
      'circle',
      {
        cx: this.placeX(x),
        cy: this.placeY(y),
        r: highlighted ? 6 : 3.5,
        class: highlighted ? 'dot highlighted' : 'dot',
      },
      svg('title', {}, tooltip),
    );
    this.element.append(mark);
    return mark;
  }

  bar(from: number, to: number, height: number, tooltip: string): void {
    const x = this.placeX(from);
    const y = this.placeY(height);
    this.element.append(
      svg(
        'rect',
        {
          x,
          y,
          width: Math.max(0.5, this.placeX(to) - x - 0.5),
          height: Math.max(0, HEIGHT - BOTTOM - y),
          class: 'bar',
        },
        svg('title', {}, tooltip),
      ),
    );
  }

  /** A vertical line with a name. */
  mark(x: number, name: string): void {
    const place = this.placeX(x);
    const end = place > WIDTH * 0.7;
    this.element.append(
      svg('line', { x1: place, x2: place, y1: TOP, y2: HEIGHT - BOTTOM, class: 'mark' }),
      svg(
        'text',
        { x: place + (end ? -4 : 4), y: TOP + 10, 'text-anchor': end ? 'end' : 'start' },
        name,
      ),
    );
  }

  private drawX(): void {
    const { low, high, format = number, whole, label } = this.x;
    for (const value of ticks(low, high).filter((v) => !whole || Number.isInteger(v))) {
      const x = this.placeX(value);
      this.element.append(
        svg('line', { x1: x, x2: x, y1: HEIGHT - BOTTOM, y2: HEIGHT - BOTTOM + 4, class: 'axis' }),
        svg('text', { x, y: HEIGHT - BOTTOM + 15, 'text-anchor': 'middle' }, format(value)),
      );
    }
    this.element.append(
      svg('line', {
        x1: LEFT,
        x2: WIDTH - RIGHT,
        y1: HEIGHT - BOTTOM,
        y2: HEIGHT - BOTTOM,
        class: 'axis',
      }),
      svg('text', { x: (LEFT + WIDTH - RIGHT) / 2, y: HEIGHT - 6, 'text-anchor': 'middle' }, label),
    );
  }

  private drawY(): void {
    const { low, high, format = number, label } = this.y;
    for (const value of ticks(low, high)) {
      const y = this.placeY(value);
      this.element.append(
        svg('line', { x1: LEFT, x2: WIDTH - RIGHT, y1: y, y2: y, class: 'grid' }),
        svg('text', { x: LEFT - 5, y: y + 3.5, 'text-anchor': 'end' }, format(value)),
      );
    }
    const middle = (TOP + HEIGHT - BOTTOM) / 2;
    this.element.append(
      svg(
        'text',
        { x: 10, y: middle, 'text-anchor': 'middle', transform: `rotate(-90 10 ${middle})` },
        label,
      ),
    );
  }
}
