import type { Fit, Report } from '../data/manifest';
import type { Result } from '../data/result';
import type { PairStore } from '../state';
import { h } from './dom';
import { BADGES, sentence } from './grades';

/** Of the best map, 0, or of an alternative. */
export const fitOf = (report: Report, map: number): Fit | undefined =>
  map === 0 ? report.fit : report.alternatives?.[map - 1]?.fit;

function badge({ grade, reasons }: Fit): HTMLElement[] {
  const { icon, word } = BADGES[grade];
  const title = h('p', { class: 'grade' }, h('span', { 'aria-hidden': 'true' }, icon), word);
  if (reasons.length === 0)
    return [title, h('p', {}, 'Nothing in the map or the shapes speaks against it.')];
  const list = h('ul', {});
  for (const reason of reasons) list.append(h('li', {}, sentence(reason)));
  return [title, list];
}

/** Whether the map that is shown can be trusted, and why not. */
export function verdict(result: Result, store: PairStore): HTMLElement {
  const box = h('section', { 'aria-label': 'Verdict', 'aria-live': 'polite' });
  const show = () => {
    const fit = fitOf(result.manifest.report, store.state.map);
    box.hidden = !fit;
    box.className = `verdict ${fit?.grade ?? ''}`;
    box.replaceChildren(...(fit ? badge(fit) : []));
  };
  store.listen((_, changed) => {
    if (changed.has('map')) show();
  });
  show();
  return box;
}
