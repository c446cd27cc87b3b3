import type { Result } from '../data/result';
import { commandToRepeat } from './command';
import { h } from './dom';
import { number, quote, seconds } from './format';

/** The command line that makes the result again. */
export function commandLine(result: Result): string {
  const { command = [], working_folder } = result.manifest.report;
  const line = command.map(quote).join(' ');
  return working_folder ? `cd ${quote(working_folder)}\n${line}` : line;
}

/** The numbers of the report in words that need no manual. */
function keyNumbers(result: Result): [string, string][] {
  const { report, source, target } = result.manifest;
  const rows: [string, string][] = [
    ['Method', String(report.options.method)],
    ['Source', `${report.source.file}: ${number(source.vertices_given)} vertices`],
    ['Target', `${report.target.file}: ${number(target.vertices_given)} vertices`],
  ];
  if (report.map) rows.push(['Elastic energy (unit area)', number(report.map.energy)]);
  if (report.ambiguity !== undefined) rows.push(['Ambiguity', number(report.ambiguity)]);
  if (report.hypotheses) rows.push(['Hypotheses judged', number(report.hypotheses.length)]);
  if (report.complete !== undefined)
    rows.push(['All vertices matched', report.complete ? 'yes' : 'no']);
  if (report.seconds) {
    const total = Object.values(report.seconds).reduce((sum, x) => sum + x, 0);
    rows.push(['Time', seconds(total)]);
  }
  if (report.peak_memory_mib !== undefined)
    rows.push(['Peak memory', `${number(Math.round(report.peak_memory_mib))} MiB`]);
  if (report.isomatch) rows.push(['isomatch', report.isomatch]);
  return rows;
}

export function numbers(result: Result): HTMLElement {
  const line = commandLine(result);
  const table = h('table', { class: 'numbers' });
  for (const [name, value] of keyNumbers(result))
    table.append(h('tr', {}, h('th', { scope: 'row' }, name), h('td', {}, value)));
  const section = h('section', { class: 'panel' }, h('h2', {}, 'Numbers'), table);
  if (line) section.append(...commandToRepeat(line));
  section.append(
    h(
      'details',
      {},
      h('summary', {}, 'All of report.json'),
      h('pre', {}, JSON.stringify(result.manifest.report, null, 2)),
    ),
  );
  return section;
}
