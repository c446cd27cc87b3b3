import { WebGLRenderer } from 'three';
import type { Extent } from '../scene/extent';
import type { View } from '../scene/view';

/** What is to be seen on a canvas: views, whose rectangles are in units of `ratio` pixels. */
export interface Picture {
  context: CanvasRenderingContext2D;
  views: [View, Extent][];
  ratio: number;
}

/** Draws all shapes of the page, however many canvases show them: browsers allow few to draw in 3D
 * on their own. */
export class Painter {
  private readonly renderer = new WebGLRenderer({ antialias: true });
  private width = 0;
  private height = 0;

  constructor() {
    this.renderer.setScissorTest(true);
    this.renderer.setClearColor(0, 0);
  }

  /** Draws pictures. All are drawn before the first is copied, which takes a while each time
   * something has been drawn. */
  paint(pictures: Picture[]): void {
    const heights = pictures.map(({ context }) => context.canvas.height);
    const widths = pictures.map(({ context }) => context.canvas.width);
    const bottoms = heights.map((_, k) => heights.slice(0, k).reduce((sum, x) => sum + x, 0));
    this.makeRoom(
      Math.max(...widths),
      heights.reduce((sum, x) => sum + x, 0),
    );
    pictures.forEach((picture, k) => this.draw(picture, bottoms[k]!));
    pictures.forEach(({ context }, k) => this.copy(context, bottoms[k]!));
  }

  private draw({ context, views, ratio }: Picture, bottom: number): void {
    for (const [view, extent] of views) {
      view.aim(view.orbit, extent);
      const { x, y, width, height } = view.rectangle;
      const up = bottom + context.canvas.height - (y + height) * ratio;
      this.renderer.setViewport(x * ratio, up, width * ratio, height * ratio);
      this.renderer.setScissor(x * ratio, up, width * ratio, height * ratio);
      this.renderer.clear();
      this.renderer.render(view.scene, view.camera);
    }
  }

  private copy(context: CanvasRenderingContext2D, bottom: number): void {
    const { width, height } = context.canvas;
    const top = this.height - bottom - height;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, width, height);
    context.drawImage(this.renderer.domElement, 0, top, width, height, 0, 0, width, height);
  }

  private makeRoom(width: number, height: number): void {
    if (width <= this.width && height <= this.height) return;
    this.width = Math.max(width, this.width);
    this.height = Math.max(height, this.height);
    this.renderer.setSize(this.width, this.height, false);
  }
}
