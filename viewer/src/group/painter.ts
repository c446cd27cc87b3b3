import { WebGLRenderer } from 'three';
import type { Extent } from '../scene/extent';
import type { View } from '../scene/view';

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

  /** Fills `canvas` with views, whose rectangles are in units of `ratio` pixels. */
  paint(canvas: CanvasRenderingContext2D, views: [View, Extent][], ratio: number): void {
    const { width, height } = canvas.canvas;
    this.makeRoom(width, height);
    for (const [view, extent] of views) {
      view.aim(view.orbit, extent);
      const { x, y, width: w, height: h } = view.rectangle;
      const bottom = height - (y + h) * ratio;
      this.renderer.setViewport(x * ratio, bottom, w * ratio, h * ratio);
      this.renderer.setScissor(x * ratio, bottom, w * ratio, h * ratio);
      this.renderer.clear();
      this.renderer.render(view.scene, view.camera);
    }
    const top = this.height - height;
    canvas.setTransform(1, 0, 0, 1, 0, 0);
    canvas.clearRect(0, 0, width, height);
    canvas.drawImage(this.renderer.domElement, 0, top, width, height, 0, 0, width, height);
  }

  private makeRoom(width: number, height: number): void {
    if (width <= this.width && height <= this.height) return;
    this.width = Math.max(width, this.width);
    this.height = Math.max(height, this.height);
    this.renderer.setSize(this.width, this.height, false);
  }
}
