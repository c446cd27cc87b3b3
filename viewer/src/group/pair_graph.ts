import { quantile, sorted } from '../data/statistics';
import { h, svg } from '../ui/dom';
import { number } from '../ui/format';
import type { Collection } from './collection';
import { layOut } from './layout';
import type { MemberEntry, PairEntry, Use } from './manifest';
import { orderOf } from './order';
import type { GroupStore } from './state';

const SIZE = 420;
const MARGIN = 16;

const USES: Record<Use, string> = {
  agrees: 'its own map agrees with the others',
  'runner-up': 'its runner-up took the place of its own map',
  composed: 'the maps of other pairs were composed instead',
};

/** Many are smaller, to be told apart. */
const nodeSize = (count: number): number => Math.min(12, Math.max(5, 12 * Math.sqrt(80 / count)));

/** A pair in one line. */
export const describePair = (members: MemberEntry[], pair: PairEntry): string =>
  `${members[pair.source]!.name} → ${members[pair.target]!.name}: cycle error ${number(pair.cycle_error)}, cost ${number(pair.cost)}; ${USES[pair.use]}`;

/** How bad a cycle error is among those of all pairs, in [0, 1]. */
export function badness(pairs: PairEntry[]): (pair: PairEntry) => number {
  const ascending = sorted(pairs.map((pair) => pair.cycle_error));
  const low = quantile(ascending, 0.5);
  const high = Math.max(quantile(ascending, 0.98), 2 * low, 1e-9);
  return ({ cycle_error }) => Math.min(1, Math.max(0, (cycle_error - low) / (high - low)));
}

const place = ([x, y]: [number, number]): [number, number] =>
  [x, y].map((share) => MARGIN + share * (SIZE - 2 * MARGIN)) as [number, number];

/** Round if good, a square if poor, between them if doubtful, as are the badges. */
function node({ grade }: MemberEntry, [x, y]: [number, number], size: number): SVGElement {
  const round = { good: size / 2, doubtful: size / 4, poor: 0 }[grade];
  return svg('rect', {
    x: x - size / 2,
    y: y - size / 2,
    width: size,
    height: size,
    rx: round,
    class: `node ${grade}`,
    tabindex: 0,
    role: 'button',
  });
}

function legend(): HTMLElement {
  const item = (use: Use, text: string) =>
    h(
      'span',
      {},
      svg(
        'svg',
        { viewBox: '0 0 34 8', width: 34, height: 8, 'aria-hidden': 'true' },
        svg('g', { class: `edge ${use}` }, svg('line', { x1: 0, x2: 34, y1: 4, y2: 4 })),
      ),
      text,
    );
  return h(
    'p',
    { class: 'graph-legend' },
    item('agrees', 'agrees'),
    item('runner-up', 'runner-up used'),
    item('composed', 'composed of others'),
    h('span', {}, h('i', { class: 'errors' }), 'cycle error, small to large'),
  );
}

/** Edges of the graph, the worst on top. */
function edges(
  { members, pairs }: Collection['manifest'],
  places: [number, number][],
  tell: (text: string) => void,
): SVGElement[] {
  const bad = badness(pairs);
  return [...pairs]
    .sort((a, b) => a.cycle_error - b.cycle_error)
    .map((pair) => {
      const [x1, y1] = places[pair.source]!;
      const [x2, y2] = places[pair.target]!;
      const edge = svg('g', { class: `edge ${pair.use}`, style: `--bad-share:${bad(pair)}` });
      // A wide one that is not seen is easier to hit.
      for (const kind of ['hit', 'seen']) edge.append(svg('line', { x1, y1, x2, y2, class: kind }));
      edge.addEventListener('pointerenter', () => tell(describePair(members, pair)));
      return edge;
    });
}

/** Shapes and the pairs that were matched; a click selects a shape. */
export function pairGraph(collection: Collection, store: GroupStore): HTMLElement {
  const { members, pairs, template } = collection.manifest;
  const places = layOut(members.length, pairs).map(place);
  const told = h('p', { class: 'told', role: 'status' });
  const hint =
    'Shapes that fit well lie near each other. Point at a line or a shape; a click selects it.';
  const tell = (text: string) => (told.textContent = text);
  const size = nodeSize(members.length);
  const nodes = members.map((entry, k) => {
    const mark = node(entry, places[k]!, k === template.member ? 18 : size);
    const select = () => store.set({ selected: k });
    const own = k === template.member ? ', the template' : '';
    mark.setAttribute('aria-label', entry.name);
    mark.addEventListener('click', select);
    mark.addEventListener('keydown', ({ key }) => key === 'Enter' && select());
    mark.addEventListener('pointerenter', () =>
      tell(`${entry.name}${own}: ${entry.grade}, cycle error ${number(entry.cycle_error)}`),
    );
    return mark;
  });
  const graph = svg(
    'svg',
    { viewBox: `0 0 ${SIZE} ${SIZE}`, class: 'graph', id: 'graph' },
    ...edges(collection.manifest, places, tell),
    // The worst on top.
    ...orderOf(collection.manifest, 'quality')
      .map((k) => nodes[k]!)
      .reverse(),
  );
  graph.addEventListener('pointerleave', () => tell(hint));
  const show = () =>
    nodes.forEach((mark, k) => mark.classList.toggle('selected', k === store.state.selected));
  store.listen((_, changed) => changed.has('selected') && show());
  show();
  tell(hint);
  return h('section', { class: 'panel' }, h('h2', {}, 'Pairs'), graph, told, legend());
}
