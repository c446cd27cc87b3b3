import { PerspectiveCamera, Quaternion, Vector3 } from 'three';

/** In degrees, from top to bottom. */
export const FIELD_OF_VIEW = 28;

/** From where a shape about the origin is looked at. */
export class Orbit {
  readonly rotation = new Quaternion();
  /** Above 1 is nearer. */
  zoom = 1;
  /** The shift of the shape, in heights of the view. */
  panX = 0;
  panY = 0;

  copy(other: Orbit): void {
    this.rotation.copy(other.rotation);
    this.zoom = other.zoom;
    this.panX = other.panX;
    this.panY = other.panY;
  }

  reset(): void {
    this.copy(new Orbit());
  }

  /** Turns the shape by angles in radians about the view's upright and level axes. */
  turn(right: number, down: number): void {
    const about = (axis: Vector3, angle: number) =>
      this.rotation.premultiply(new Quaternion().setFromAxisAngle(axis, angle));
    about(new Vector3(0, 1, 0), right);
    about(new Vector3(1, 0, 0), down);
  }

  pan(right: number, up: number): void {
    this.panX += right;
    this.panY += up;
  }

  scale(factor: number): void {
    this.zoom = Math.min(40, Math.max(0.2, this.zoom * factor));
  }

  /** Points `camera` from `farthest` away at zoom 1. */
  aim(camera: PerspectiveCamera, aspect: number, farthest: number): void {
    const distance = farthest / this.zoom;
    const height = 2 * distance * Math.tan((FIELD_OF_VIEW * Math.PI) / 360);
    const place = new Vector3(-this.panX * height, -this.panY * height, distance);
    const inverse = this.rotation.clone().invert();
    camera.fov = FIELD_OF_VIEW;
    camera.aspect = aspect;
    camera.near = distance / 50;
    camera.far = distance * 10 + 20;
    camera.position.copy(place.applyQuaternion(inverse));
    camera.quaternion.copy(inverse);
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
  }
}
