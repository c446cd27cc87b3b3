import { pathToFileURL } from 'node:url';
import { type Browser, chromium, type Page } from 'playwright-core';
import { expect } from 'vitest';

const EXECUTABLE = process.env.ISOMATCH_CHROMIUM ?? '/usr/bin/chromium';

export const launch = (): Promise<Browser> =>
  chromium.launch({
    executablePath: EXECUTABLE,
    // WebGL on the processor; the sandbox does not work as root.
    args: [
      '--no-sandbox',
      '--use-angle=swiftshader',
      '--enable-unsafe-swiftshader',
      '--ignore-gpu-blocklist',
    ],
  });

export type Rgb = [number, number, number];

/** Pixels that are not background. */
export interface Half {
  pixels: number;
  /** How many clearly different ones. */
  colors: number;
  /** Changes with any of them. */
  hash: number;
}

const VIEWPORT = { width: 1000, height: 750 };

async function load(page: Page, path: string): Promise<void> {
  await page.goto(pathToFileURL(path).href);
  await page.waitForSelector('html[data-complete]', { timeout: 60_000 });
}

/** A report in the browser. Whatever the page complains about or fetches is remembered. */
export class ReportPage {
  readonly complaints: string[] = [];
  private readonly requests: string[] = [];

  private constructor(readonly page: Page) {
    page.on('console', (message) => {
      if (['error', 'warning'].includes(message.type())) this.complaints.push(message.text());
    });
    page.on('pageerror', (error) => this.complaints.push(error.message));
    page.on('request', (request) => this.requests.push(request.url()));
  }

  static async open(
    browser: Browser,
    path: string,
    options: Parameters<Browser['newPage']>[0] = {},
  ): Promise<ReportPage> {
    const page = await browser.newPage({ viewport: VIEWPORT, ...options });
    const report = new ReportPage(page);
    await load(page, path);
    return report;
  }

  /** Seconds for which the page's main thread computes until it is complete, however busy the
   * machine is with other things. */
  static async secondsComputed(browser: Browser, path: string): Promise<number> {
    const page = await browser.newPage({ viewport: VIEWPORT });
    const session = await page.context().newCDPSession(page);
    await session.send('Performance.enable', { timeDomain: 'threadTicks' });
    await load(page, path);
    const { metrics } = await session.send('Performance.getMetrics');
    await page.close();
    return metrics.find(({ name }) => name === 'TaskDuration')?.value ?? Number.NaN;
  }

  /** Ends the visit; nothing may have gone wrong, and nothing been fetched. */
  async close(): Promise<void> {
    await this.page.close();
    // Chromium warns about our reading of pixels.
    const real = this.complaints.filter((text) => !/GPU stall|readback/i.test(text));
    expect(real).toEqual([]);
    expect(this.requests.filter((url) => !/^(file|data|blob):/.test(url))).toEqual([]);
  }

  /** Milliseconds from opening the page to its first picture. */
  firstPicture(): Promise<number> {
    return this.page.evaluate(() => Number(document.documentElement.dataset.firstPicture));
  }

  async setSlider(id: string, value: number): Promise<void> {
    await this.page.locator(`#${id}`).fill(String(value));
  }

  async choose(value: string): Promise<void> {
    await this.page.locator(`label:has(input[value="${value}"])`).click();
  }

  /** Waits until what was asked for is drawn. */
  async drawn(): Promise<void> {
    await this.page.evaluate(
      () =>
        new Promise<void>((done) =>
          requestAnimationFrame(() => requestAnimationFrame(() => done())),
        ),
    );
  }

  /** What WebGL drew of the shapes, in the left and the right half: every third pixel each way. */
  async halves(): Promise<{ left: Half; right: Half }> {
    await this.drawn();
    return this.page.evaluate(() => {
      const canvas = document.querySelector<HTMLCanvasElement>('#stage canvas')!;
      const copy = document.createElement('canvas');
      copy.width = canvas.width;
      copy.height = canvas.height;
      const context = copy.getContext('2d', { willReadFrequently: true })!;
      context.drawImage(canvas, 0, 0);
      const { data } = context.getImageData(0, 0, copy.width, copy.height);
      const look = (from: number, to: number) => {
        const colors = new Set<number>();
        let pixels = 0;
        let hash = 0;
        for (let y = 0; y < copy.height; y += 3) {
          for (let x = from; x < to; x += 3) {
            const i = 4 * (y * copy.width + x);
            if (data[i + 3]! < 255) continue;
            const color = (data[i]! << 16) | (data[i + 1]! << 8) | data[i + 2]!;
            ++pixels;
            colors.add(color & 0xe0e0e0);
            hash = (Math.imul(hash, 31) + color + x) | 0;
          }
        }
        return { pixels, colors: colors.size, hash };
      };
      const middle = copy.width >> 1;
      return { left: look(0, middle), right: look(middle, copy.width) };
    });
  }

  /** How many pixels of the drawing over the shapes are not empty, and how many are `color`. */
  async overlay(color: Rgb): Promise<{ painted: number; ofColor: number }> {
    await this.drawn();
    return this.page.evaluate((wanted) => {
      const canvas = document.querySelector<HTMLCanvasElement>('#stage canvas.overlay')!;
      const { data } = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height);
      let painted = 0;
      let ofColor = 0;
      for (let i = 0; i < data.length; i += 4) {
        if (data[i + 3]! === 0) continue;
        ++painted;
        const far = Math.max(...wanted.map((value, k) => Math.abs(value - data[i + k]!)));
        if (far < 12 && data[i + 3]! > 200) ++ofColor;
      }
      return { painted, ofColor };
    }, color);
  }

  text(selector: string): Promise<string> {
    return this.page.locator(selector).innerText();
  }

  /** Moves the pointer to a share of the canvas's width and height. */
  async point(x: number, y: number): Promise<void> {
    const stage = this.page.locator('#stage');
    await stage.evaluate((element) => element.scrollIntoView({ block: 'center' }));
    const box = (await stage.boundingBox())!;
    await this.page.mouse.move(box.x + x * box.width, box.y + y * box.height);
    await this.drawn();
  }
}
