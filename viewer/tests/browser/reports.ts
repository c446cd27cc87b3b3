import { execFile } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
const PROGRAM = process.env.ISOMATCH_PROGRAM ?? join(ROOT, 'build/dev/tools/isomatch');
/** Writes the page of a made-up collection. */
export const SAMPLE_GROUP = join(dirname(PROGRAM), '../tests/tools/sample_group_page');
/** Shapes that may not be redistributed. */
const DATA = process.env.ISOMATCH_TEST_DATA ?? join(ROOT, '../shared/data');

export const hasData = (folder: string): boolean => existsSync(join(DATA, folder));

export class Reports {
  readonly folder = mkdtempSync(join(tmpdir(), 'isomatch-report-'));

  private async run(...words: string[]): Promise<void> {
    await promisify(execFile)(PROGRAM, words, { cwd: this.folder });
  }

  /** The path of a report of two poses of a made-up creature. */
  async synthetic(name: string, vertices: number, ...options: string[]): Promise<string> {
    for (const pose of ['1', '2'])
      await this.run(
        'synth',
        ...['--vertices', String(vertices), '--pose', pose, '--seed', '2'],
        ...['-o', `${name}${pose}.off`, '-q'],
      );
    const truth = ['--gt-source', `${name}1.vts`, '--gt-target', `${name}2.vts`];
    await this.run(
      'match',
      ...[`${name}1.off`, `${name}2.off`, '-o', name, '-q', '--report'],
      ...truth,
      ...options,
    );
    return join(this.folder, name, 'report.html');
  }

  /** The same of two shapes of the test data. */
  async ofData(folder: string, source: string, target: string): Promise<string> {
    const mesh = (shape: string) => join(DATA, folder, `${shape}.ply`);
    const truth = (shape: string) => join(DATA, folder, 'corres', `${shape}.vts`);
    await this.run(
      'match',
      ...[mesh(source), mesh(target), '-o', folder, '-q', '--report'],
      ...['--gt-source', truth(source), '--gt-target', truth(target)],
    );
    return join(this.folder, folder, 'report.html');
  }

  /** A copy of a page that has `fit` for the best map, none if it is undefined. */
  withFit(path: string, name: string, fit: object | undefined): string {
    const manifest = /(<script[^>]*id="isomatch-manifest"[^>]*>)([^<]*)/;
    const copy = readFileSync(path, 'utf8').replace(manifest, (_, tag: string, json: string) => {
      const parsed = JSON.parse(json) as { report: { fit?: object } };
      parsed.report.fit = fit;
      return tag + JSON.stringify(parsed).replaceAll('<', '\\u003c');
    });
    const edited = join(this.folder, `${name}.html`);
    writeFileSync(edited, copy);
    return edited;
  }
}
