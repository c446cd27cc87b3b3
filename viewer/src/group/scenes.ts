import { Quaternion } from 'three';
import type { Collection } from './collection';
import type { Coloring } from './coloring';
import { Detail } from './detail';
import { MeanShape } from './model_panel';
import { Painter } from './painter';
import type { GroupStore } from './state';
import { Thumbnails } from './thumbnails';

/** What the canvases are put into. */
export interface Boxes {
  detail: HTMLElement;
  mean: HTMLElement;
}

/** All that draws in 3D. Shapes turn together, whichever is turned by hand. */
export class Scenes {
  readonly thumbnails: Thumbnails;
  private readonly detail: Detail;
  private readonly mean: MeanShape | null;

  constructor(boxes: Boxes, collection: Collection, coloring: Coloring, store: GroupStore) {
    const painter = new Painter();
    this.thumbnails = new Thumbnails(collection, coloring, painter, store.state.coloring);
    this.detail = new Detail(boxes.detail, collection, coloring, painter, store, (rotation) => {
      this.thumbnails.turnTo(rotation);
      this.mean?.turnTo(rotation);
    });
    this.mean =
      collection.model &&
      new MeanShape(boxes.mean, collection.model, coloring, painter, store, (rotation) => {
        this.thumbnails.turnTo(rotation);
        this.detail.turnTo(rotation);
      });
    store.listen((state, changed) => {
      if (changed.has('coloring')) this.thumbnails.color(state.coloring);
    });
  }

  /** As the page was at first, without a point that was clicked on. */
  reset(): void {
    this.detail.reset();
    this.mean?.reset();
    this.thumbnails.turnTo(new Quaternion());
  }

  redraw(): void {
    this.detail.redraw();
  }
}
