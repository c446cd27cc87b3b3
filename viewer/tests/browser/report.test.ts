import { rmSync, statSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import type { Browser } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { launch, ReportPage, type Rgb } from './page';
import { hasData, Reports } from './reports';

const RED: Rgb = [232, 33, 43];
const GREEN: Rgb = [19, 165, 56];

const reports = new Reports();
let browser: Browser;

beforeAll(async () => {
  browser = await launch();
});

afterAll(async () => {
  await browser?.close();
  rmSync(reports.folder, { recursive: true, force: true });
});

/** Both shapes are seen, in many colours. */
async function expectShapes(report: ReportPage): Promise<void> {
  for (const half of Object.values(await report.halves())) {
    expect(half.pixels).toBeGreaterThan(1000);
    expect(half.colors).toBeGreaterThan(15);
  }
}

/** `act` changes what WebGL draws. */
async function expectChange(report: ReportPage, act: () => Promise<unknown>): Promise<void> {
  const before = await report.halves();
  await act();
  expect(await report.halves()).not.toEqual(before);
}

describe('a synthetic pair of 16k vertices, by the tracked method', () => {
  let path: string;
  let report: ReportPage;

  beforeAll(async () => {
    path = await reports.synthetic('creature', 16000, '--alternatives', '1');
    report = await ReportPage.open(browser, path);
  });
  afterAll(() => report?.close());

  it('is a file of less than 4 MB', () => {
    expect(statSync(path).size).toBeLessThan(4_000_000);
  });

  it('has its first picture within two seconds', async () => {
    // Where the machine is busy with other things, what the page itself computes counts.
    if ((await report.firstPicture()) < 2000) return;
    expect(await ReportPage.secondsComputed(browser, path)).toBeLessThan(2);
  });

  it('shows both shapes', () => expectShapes(report));

  it('tells the result in words', async () => {
    expect(await report.text('.remarks')).toContain('is matched');
    expect(await report.text('.remarks')).toContain('Against the ground truth');
    expect(await report.text('.numbers')).toContain('tracked');
    expect(await report.text('.panel pre >> nth=0')).toContain('match creature1.off creature2.off');
  });

  it('says first whether the map that is shown can be trusted', async () => {
    expect(await report.text('.verdict.good .grade')).toContain('Good fit');
  });

  it.each([
    ['good', '✓', 'Good fit', []],
    ['doubtful', '!', 'Doubtful fit', ['2 % of the target is not reached']],
    ['poor', '✕', 'Poor fit', ['distances change by a third', 'it is turned over']],
  ])('has icon, word and reasons of a %s fit in sight', async (grade, icon, word, reasons) => {
    const edited = reports.withFit(path, grade, { grade, reasons });
    for (const viewport of [
      { width: 1280, height: 800 },
      { width: 390, height: 844 },
    ]) {
      const other = await ReportPage.open(browser, edited, { viewport });
      const title = other.page.locator(`.verdict.${grade} .grade`);
      expect(await title.textContent()).toBe(icon + word);
      const box = (await title.boundingBox())!;
      expect(box.y + box.height).toBeLessThan(viewport.height / 2);
      const told = await other.page.locator('.verdict li').allTextContents();
      expect(told.map((text) => text.toLowerCase())).toEqual(reasons.map((text) => `${text}.`));
      await other.close();
    }
  });

  it('has no badge for results of older versions', async () => {
    const old = await ReportPage.open(browser, reports.withFit(path, 'old', undefined));
    expect(await old.page.locator('.verdict').isVisible()).toBe(false);
    await expectShapes(old);
    await old.close();
  });

  it('plays the bending, and stops when asked or when the slider is moved', async () => {
    const play = report.page.locator('#play');
    const morph = () => report.page.locator('#morph').inputValue();
    await play.click();
    expect(await play.textContent()).toBe('Stop');
    await play.click();
    const stopped = await morph();
    await report.page.waitForTimeout(200);
    expect(await morph()).toBe(stopped);
    expect(await play.textContent()).toBe('Play');
    await play.click();
    await report.setSlider('morph', 0);
    await report.page.waitForTimeout(200);
    expect(await morph()).toBe('0');
    expect(await play.textContent()).toBe('Play');
  });

  it('tells all but the picture where there is no WebGL', async () => {
    const page = await browser.newPage({ viewport: { width: 390, height: 844 } });
    await page.addInitScript(() => {
      HTMLCanvasElement.prototype.getContext = () => null;
    });
    await page.goto(pathToFileURL(path).href);
    await page.waitForSelector('html[data-complete]', { timeout: 60_000 });
    expect(await page.textContent('.no-webgl')).toContain('WebGL');
    expect(await page.textContent('.verdict')).toContain('Good fit');
    expect(await page.textContent('.numbers')).toContain('tracked');
    expect(await page.textContent('#point')).toBe('');
    await page.close();
  });

  it('has other colours for each choice', async () => {
    for (const value of ['checker', 'confidence', 'd_iso', 'error', 'curvature', 'map'])
      await expectChange(report, () => report.choose(value));
    await report.choose('d_iso');
    expect(await report.text('.legend')).toContain('Isometric distortion');
    expect(await report.page.locator('.legend .scale').count()).toBe(1);
    await report.choose('map');
  });

  it('shows how sure each point is, with a scale from 0 to 1', async () => {
    await expectChange(report, () => report.choose('confidence'));
    expect(await report.text('.legend')).toContain('How sure each point is');
    expect(await report.page.locator('.legend .scale span').allTextContents()).toEqual(['0', '1']);
    await report.choose('map');
  });

  it('draws match lines, the worst in red and green', async () => {
    expect((await report.overlay(RED)).painted).toBe(0);
    await report.setSlider('lines', 60);
    expect((await report.overlay(RED)).painted).toBeGreaterThan(2000);
    await report.setSlider('lines', 0);
    await report.page.locator('#worstIso').check();
    expect((await report.overlay(RED)).ofColor).toBeGreaterThan(300);
    await report.page.locator('#worstIso').uncheck();
    await report.page.locator('#worstTruth').check();
    expect((await report.overlay(GREEN)).ofColor).toBeGreaterThan(300);
    await report.page.locator('#worstTruth').uncheck();
    expect((await report.overlay(RED)).painted).toBe(0);
  });

  it('names the vertex under the pointer and its partner, and keeps it when clicked', async () => {
    await report.point(0.25, 0.5);
    const hovered =
      /source vertex \d+ ↔ target vertex \d+ .*d_iso .*confidence [01].*ground-truth error/;
    expect(await report.text('#point')).toMatch(hovered);
    expect((await report.overlay(RED)).painted).toBeGreaterThan(100);
    await report.page.mouse.down();
    await report.page.mouse.up();
    await report.point(0.5, 0.02);
    expect(await report.text('#point')).toMatch(hovered);
    await report.point(0.75, 0.5);
    expect(await report.text('#point')).toMatch(/target vertex \d+ ↔ source vertex \d+/);
    await report.point(0.5, 0.02);
    await report.page.mouse.down();
    await report.page.mouse.up();
    expect(await report.text('#point')).toContain('Point at a shape');
  });

  it('lets go of a vertex on Escape, wherever the focus is, and when the view is reset', async () => {
    const letGo = [
      async () => {
        await report.page.locator('#lines').focus();
        await report.page.keyboard.press('Escape');
      },
      () => report.page.locator('#reset').click(),
    ];
    for (const act of letGo) {
      await report.point(0.25, 0.5);
      await report.page.mouse.down();
      await report.page.mouse.up();
      await report.point(0.5, 0.02);
      expect(await report.text('#point')).toMatch(/source vertex \d+/);
      await act();
      expect(await report.text('#point')).toContain('Point at a shape');
    }
  });

  it('turns both shapes together, or one alone', async () => {
    const drag = async (x: number) => {
      await report.point(x, 0.5);
      await report.page.mouse.down();
      await report.point(x + 0.1, 0.55);
      await report.page.mouse.up();
    };
    const start = await report.halves();
    await drag(0.25);
    const both = await report.halves();
    expect(both.left).not.toEqual(start.left);
    expect(both.right).not.toEqual(start.right);
    await report.page.locator('#linked').uncheck();
    await drag(0.25);
    const one = await report.halves();
    expect(one.left).not.toEqual(both.left);
    expect(one.right).toEqual(both.right);
    await report.page.locator('#linked').check();
    await report.page.locator('#reset').click();
    expect(await report.halves()).toEqual(start);
  });

  it('leaves the wheel to the page until the shapes are clicked on', async () => {
    const scrolled = () => report.page.evaluate(() => scrollY);
    const wheel = async (delta: number) => {
      await report.page.mouse.wheel(0, delta);
      await report.page.waitForTimeout(300);
    };
    await report.page.locator('#lines').focus();
    await report.page.evaluate(() => scrollTo(0, 0));
    const { x, y, width, height } = (await report.page.locator('#stage').boundingBox())!;
    await report.page.mouse.move(x + 0.25 * width, y + 0.5 * height);
    await report.drawn();
    const start = await report.halves();
    await wheel(100);
    expect(await scrolled()).toBeGreaterThan(0);
    await report.point(0.5, 0.02);
    expect(await report.halves()).toEqual(start);
    const before = await scrolled();
    await report.page.keyboard.down('Control');
    await expectChange(report, () => wheel(-100));
    await report.page.keyboard.up('Control');
    await report.page.locator('#stage').focus();
    await expectChange(report, () => wheel(-100));
    expect(await scrolled()).toBe(before);
    await report.page.locator('#reset').click();
  });

  it('obeys the keyboard', async () => {
    await report.page.locator('#stage').focus();
    await expectChange(report, () => report.page.keyboard.press('ArrowLeft'));
    await expectChange(report, () => report.page.keyboard.press('+'));
    await expectChange(report, () => report.page.keyboard.press('0'));
  });

  it('bends the source into the pose of the target, also over it', async () => {
    await expectChange(report, () => report.setSlider('morph', 1));
    await expectChange(report, () => report.choose('overlay'));
    await expectChange(report, () => report.setSlider('morph', 0));
    await report.page.locator('#play').click();
    await report.page.waitForFunction(
      () => document.querySelector<HTMLInputElement>('#morph')!.value === '1',
    );
    await report.setSlider('morph', 0);
    await report.choose('pair');
    await expectShapes(report);
  });

  it('shows alternatives, if there are any', async () => {
    if ((await report.page.locator('#map').count()) === 0) return;
    await expectChange(report, () => report.setSlider('map', 1));
    await report.setSlider('map', 0);
  });

  it('has plots and all of the report', async () => {
    expect(await report.page.locator('.plots .panel').count()).toBe(4);
    expect(await report.page.locator('.chart .line').count()).toBe(1);
    expect(await report.page.locator('.chart .bar').count()).toBe(40);
    await report.page.locator('summary').click();
    expect(await report.text('details pre')).toContain('"peak_memory_mib"');
    await report.page.locator('#copy').click();
  });

  it('changes its theme', async () => {
    const back = () => report.page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    const auto = await back();
    await report.page.locator('#theme').click();
    await report.page.locator('#theme').click();
    expect(await back()).not.toBe(auto);
    await report.page.locator('#theme').click();
    expect(await back()).toBe(auto);
  });

  it('fits on a phone, also in the dark', async () => {
    const phone = await ReportPage.open(browser, path, {
      viewport: { width: 390, height: 844 },
      colorScheme: 'dark',
      hasTouch: true,
      isMobile: true,
    });
    const width = await phone.page.evaluate(() => document.documentElement.scrollWidth);
    expect(width).toBeLessThanOrEqual(390);
    const { left, right } = await phone.halves();
    expect(left.pixels + right.pixels).toBeGreaterThan(1000);
    expect(await phone.text('#point')).toMatch(/^Tap a shape/);
    const badge = (await phone.page.locator('.verdict .grade').boundingBox())!;
    expect(badge.y + badge.height).toBeLessThan(400);
    await phone.close();
  });
});

describe('a synthetic pair, by the method of the paper', () => {
  it('shows its levels', async () => {
    const report = await ReportPage.open(
      browser,
      await reports.synthetic('paper', 2000, '--method=paper'),
    );
    await expectShapes(report);
    expect(await report.page.locator('input[value="confidence"]').count()).toBe(0);
    const last = Number(await report.page.locator('#level').getAttribute('max'));
    expect(last).toBeGreaterThan(3);
    await expectChange(report, () => report.setSlider('level', 1));
    expect(await report.page.locator('input[value="patches"]').isChecked()).toBe(true);
    expect((await report.overlay(RED)).painted).toBeGreaterThan(500);
    expect(await report.text('.slider:has(#level)')).toMatch(/1 of \d+: \d+ matches, D_iso/);
    await expectChange(report, () => report.setSlider('level', last));
    expect(await report.page.locator('input[value="map"]').isChecked()).toBe(true);
    await report.page.locator('.chart .dot >> nth=2').click();
    expect(await report.page.locator('#level').inputValue()).toBe('2');
    await report.close();
  });
});

describe.skipIf(!hasData('horse_gallop'))('a pair of horses', () => {
  it('is shown', async () => {
    const path = await reports.ofData('horse_gallop', 'horse_01', 'horse_11');
    const report = await ReportPage.open(browser, path);
    await expectShapes(report);
    expect(await report.text('.warnings')).toContain('holes or open borders');
    await report.close();
  });
});

describe.skipIf(!hasData('elephant169k'))('a pair of 169k vertices', () => {
  it('is shown, and its controls work', async () => {
    const path = await reports.ofData('elephant169k', 'elephant_gallop_1', 'elephant_gallop_20');
    const report = await ReportPage.open(browser, path);
    await expectShapes(report);
    await expectChange(report, () => report.choose('d_iso'));
    await expectChange(report, () => report.setSlider('morph', 1));
    await report.point(0.25, 0.5);
    expect(await report.text('#point')).toMatch(/source vertex \d+ ↔ target vertex \d+/);
    await report.close();
  });
});
