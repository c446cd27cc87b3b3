import './style.css';
import './group/style.css';
import { unpack } from './data/arrays';
import type { Manifest } from './data/manifest';
import { Result } from './data/result';
import { Collection } from './group/collection';
import type { GroupManifest } from './group/manifest';
import { showGroup } from './group/page';
import { showPage } from './page';

const text = (id: string): string => document.getElementById(id)?.textContent ?? '';

async function start(root: HTMLElement): Promise<void> {
  const manifest = text('isomatch-manifest');
  if (!manifest.trim()) throw new Error('This is the empty page that `isomatch report` fills.');
  const parsed = JSON.parse(manifest) as Manifest | GroupManifest;
  if (parsed.format !== 1)
    throw new Error(`This page cannot show data of format ${parsed.format}.`);
  const arrays = await unpack(text('isomatch-arrays'), parsed.arrays);
  if ('kind' in parsed) showGroup(root, new Collection(parsed, arrays));
  else showPage(root, new Result(parsed, arrays));
  // Milliseconds since the page was opened, for tests.
  document.documentElement.dataset.firstPicture = performance.now().toFixed(0);
}

const root = document.getElementById('page')!;
start(root).catch((error: unknown) => {
  root.className = 'failure';
  root.textContent = error instanceof Error ? error.message : String(error);
});
