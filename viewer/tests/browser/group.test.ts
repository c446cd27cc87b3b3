import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type { Browser } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { launch, ReportPage } from './page';
import { SAMPLE_GROUP } from './reports';

const folder = mkdtempSync(join(tmpdir(), 'isomatch-group-'));
const path = join(folder, 'group.html');
let browser: Browser;

beforeAll(async () => {
  execFileSync(SAMPLE_GROUP, [path, '40', '2000']);
  browser = await launch();
});

afterAll(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

/** Changes with any pixel of a canvas; 0 of an empty one. */
async function hash(report: ReportPage, selector: string): Promise<number> {
  await report.drawn();
  return report.page
    .locator(selector)
    .first()
    .evaluate((canvas: HTMLCanvasElement) => {
      const { data } = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height);
      return data.reduce((sum, byte) => (Math.imul(sum, 31) + byte) | 0, 0);
    });
}

/** What `read` tells once it is no longer `before`. */
const changed = <T>(read: () => Promise<T>, before: T) =>
  expect.poll(read, { timeout: 20_000 }).not.toEqual(before);

describe('the page of a made-up collection of 40 shapes', () => {
  let report: ReportPage;
  const names = () => report.page.locator('#wall .card-name b').allTextContents();
  const title = () => report.text('#details h2');

  beforeAll(async () => {
    report = await ReportPage.open(browser, path, { viewport: { width: 1400, height: 900 } });
  });
  afterAll(() => report?.close());

  it('is a file of less than 3 MB', () => expect(statSync(path).size).toBeLessThan(3_000_000));

  it('tells how it went', async () => {
    expect(await report.text('.grade-counts')).toMatch(/1 poor\s+!?\s*2 doubtful\s+✓?\s*37 good/);
    expect(await report.text('.remarks')).toContain('40 shapes, followed from creature_0');
    expect(await report.page.title()).toBe('A made-up collection – isomatch');
    expect(await report.text('pre')).toBe("isomatch group 'creatures/*.off' -o 'out dir' --report");
  });

  it('has the bad shapes first, and shows the worst beside the template', async () => {
    expect((await names()).slice(0, 3)).toEqual(['creature_2', 'creature_4', 'creature_3']);
    expect(await report.text('#wall .card >> nth=0')).toContain('two legs are exchanged');
    expect(await title()).toBe('creature_2');
    expect(await report.text('.sides')).toContain('creature_0, the template');
    for (const half of Object.values(await report.halves())) {
      expect(half.pixels).toBeGreaterThan(1000);
      expect(half.colors).toBeGreaterThan(15);
    }
  });

  it('has a picture of each shape in sight', () => changed(() => hash(report, '#wall canvas'), 0));

  it('sorts by name and by score', async () => {
    await report.page.locator('#sort').selectOption('name');
    expect((await names()).slice(0, 3)).toEqual(['creature_0', 'creature_1_part', 'creature_2']);
    await report.page.locator('#sort').selectOption('mode0');
    const scores = (await report.page.locator('#wall .value').allTextContents()).map((text) =>
      Number(/score (.*) sd/.exec(text)![1]!.replace('−', '-')),
    );
    expect(scores).toEqual([...scores].sort((a, b) => a - b));
    await report.page.locator('#sort').selectOption('quality');
  });

  it('shows the shape that is clicked on, and the next', async () => {
    const before = await report.halves();
    await report.page.locator('#wall .card', { hasText: 'creature_1_part' }).click();
    expect(await title()).toBe('creature_1_part');
    expect(await report.text('#details')).toContain('Missing');
    expect((await report.halves()).right).not.toEqual(before.right);
    await report.page.locator('#next').click();
    expect(await title()).not.toBe('creature_1_part');
    await report.page.locator('#previous').click();
    expect(await title()).toBe('creature_1_part');
    await report.page.locator('#details .pairs button').first().click();
    expect(await title()).toBe('creature_2');
  });

  it('shows spread on all shapes', async () => {
    const before = await report.halves();
    const thumbnail = await hash(report, '#wall canvas');
    await report.choose('spread');
    const after = await report.halves();
    expect(after.left).not.toEqual(before.left);
    expect(after.right).not.toEqual(before.right);
    expect(await report.page.locator('.legend .scale').count()).toBe(1);
    await changed(() => hash(report, '#wall canvas'), thumbnail);
    await report.choose('map');
    expect(await report.halves()).toEqual(before);
  });

  it('names the point under the pointer, marks it on both shapes and keeps it', async () => {
    const before = await report.halves();
    await report.point(0.25, 0.5);
    const told = /template vertex \d+ .* spread .* of √area on creature_2 .* over all shapes/;
    expect(await report.text('#point')).toMatch(told);
    const marked = await report.halves();
    expect(marked.left).not.toEqual(before.left);
    expect(marked.right).not.toEqual(before.right);
    await report.page.mouse.down();
    await report.page.mouse.up();
    await report.point(0.5, 0.02);
    expect(await report.text('#point')).toMatch(told);
    await report.page.keyboard.press('Escape');
    expect(await report.text('#point')).toContain('Point at a shape');
  });

  it('turns all shapes together, and back', async () => {
    const before = await report.halves();
    const thumbnail = await hash(report, '#wall canvas');
    const mean = await hash(report, '#mean canvas');
    await report.page.locator('#stage').press('ArrowRight');
    const after = await report.halves();
    expect(after.left).not.toEqual(before.left);
    expect(after.right).not.toEqual(before.right);
    await changed(() => hash(report, '#wall canvas'), thumbnail);
    await report.page.locator('#mean').scrollIntoViewIfNeeded();
    await changed(() => hash(report, '#mean canvas'), mean);
    await report.page.locator('#reset').click();
    expect(await report.halves()).toEqual(before);
  });

  it('moves the mean shape along its modes', async () => {
    await report.page.locator('#mean').scrollIntoViewIfNeeded();
    const mean = await hash(report, '#mean canvas');
    await report.setSlider('mode1', 2);
    expect(await report.text('.modes')).toContain('+2.0 sd');
    await changed(() => hash(report, '#mean canvas'), mean);
    const moved = await hash(report, '#mean canvas');
    await report.page.locator('#to-selected').click();
    await changed(() => hash(report, '#mean canvas'), moved);
    await report.page.locator('#to-mean').click();
    await expect.poll(() => hash(report, '#mean canvas')).toBe(mean);
  });

  it('has a graph that tells of pairs and selects shapes', async () => {
    await report.page.locator('#graph').scrollIntoViewIfNeeded();
    await report.page.locator('#graph .edge').last().dispatchEvent('pointerenter');
    expect(await report.text('.told')).toMatch(/creature_2 → creature_3: .*composed instead/);
    await report.page.locator('#graph .node[aria-label="creature_20"]').click();
    expect(await title()).toBe('creature_20');
    expect(await report.page.locator('#graph .node.selected').getAttribute('aria-label')).toBe(
      'creature_20',
    );
  });

  it('has charts of the model', async () => {
    for (const name of ['Compactness', 'Generalisation', 'Specificity'])
      expect(
        await report.page.locator(`svg[aria-label="${name} by number of modes"]`).count(),
      ).toBe(1);
  });

  it('has tables of shapes and pairs, the worst first', async () => {
    await report.page.locator('details', { hasText: 'All 40 shapes' }).locator('summary').click();
    expect(await report.text('.data tbody tr >> nth=0')).toMatch(/creature_2\s+poor/);
  });
});

describe('the page of a collection elsewhere', () => {
  it('fits a phone', async () => {
    const viewport = { width: 390, height: 844 };
    const phone = await ReportPage.open(browser, path, {
      viewport,
      hasTouch: true,
      isMobile: true,
    });
    expect(await phone.page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
    await phone.close();
  });

  it('tells all but the shapes where there is no WebGL', async () => {
    const page = await browser.newPage();
    await page.addInitScript(() => {
      HTMLCanvasElement.prototype.getContext = () => null;
    });
    await page.goto(pathToFileURL(path).href);
    await page.waitForSelector('html[data-complete]', { timeout: 60_000 });
    expect(await page.textContent('.no-webgl')).toContain('WebGL');
    expect(await page.locator('#wall .card').count()).toBe(40);
    expect(await page.locator('.chart').count()).toBe(3);
    expect(await page.locator('#mode0').isVisible()).toBe(false);
    await page.locator('#wall .card', { hasText: 'creature_7' }).click();
    expect(await page.textContent('#details h2')).toBe('creature_7');
    await page.close();
  });
});
