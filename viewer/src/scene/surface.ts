import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, ShaderMaterial } from 'three';
import { NONE, type Shape } from '../data/shape';

const VERTEX = `
  attribute vec3 color;
  attribute vec3 place;
  attribute float matched;
  attribute vec3 moved;
  attribute vec3 movedNormal;
  uniform float morph;
  uniform float retreat;
  varying vec3 vColor;
  varying vec3 vPlace;
  varying vec3 vNormal;
  varying float vMatched;
  void main() {
    vColor = color;
    vPlace = place;
    vMatched = matched;
    vNormal = normalMatrix * mix(normal, movedNormal, morph);
    vec4 seen = modelViewMatrix * vec4(mix(position, moved, morph), 1.0);
    seen.z -= retreat;
    gl_Position = projectionMatrix * seen;
  }`;

// The light of results/picture/canvas.cpp.
const FRAGMENT = `
  uniform float checker;
  uniform float opacity;
  uniform float grey;
  varying vec3 vColor;
  varying vec3 vPlace;
  varying vec3 vNormal;
  varying float vMatched;
  void main() {
    float size = length(vNormal);
    vec3 normal = size > 0.0 ? vNormal / size : vec3(0.0, 0.0, 1.0);
    if (normal.z < 0.0) normal = -normal;
    vec3 light = normalize(vec3(-0.4, 0.7, 1.0));
    float shade = 0.22 + 0.6 * max(0.0, dot(normal, light)) + 0.25 * normal.z;
    vec3 color = vColor;
    if (checker > 0.0 && vMatched > 0.999) {
      vec2 cell = floor(vPlace.xy * checker);
      color = mod(cell.x + cell.y, 2.0) < 0.5 ? color * 0.3 : mix(color, vec3(1.0), 0.35);
    }
    color = mix(color, vec3(0.42), grey);
    gl_FragColor = vec4(color * shade, opacity);
    #include <colorspace_fragment>
  }`;

const attributes = new WeakMap<Float32Array | Uint32Array, BufferAttribute>();

/** Surfaces that share an array share it on the graphics card as well. */
function attribute(values: Float32Array | Uint32Array, size: number): BufferAttribute {
  let known = attributes.get(values);
  if (!known) attributes.set(values, (known = new BufferAttribute(values, size)));
  return known;
}

/** A shape on the graphics card. */
export class Surface {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;

  constructor(private readonly shape: Shape) {
    const geometry = new BufferGeometry();
    geometry.setIndex(attribute(shape.faces, 1));
    geometry.setAttribute('position', attribute(shape.position, 3));
    geometry.setAttribute('normal', attribute(shape.normal, 3));
    geometry.setAttribute('moved', attribute(shape.position, 3));
    geometry.setAttribute('movedNormal', attribute(shape.normal, 3));
    const material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: {
        morph: { value: 0 },
        checker: { value: 0 },
        opacity: { value: 1 },
        grey: { value: 0 },
        retreat: { value: 0 },
      },
      side: DoubleSide,
    });
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
    this.setColors(new Float32Array(shape.position.length));
    this.setPlaces(shape.position, new Int32Array(shape.count));
  }

  setColors(colors: Float32Array): void {
    this.mesh.geometry.setAttribute('color', attribute(colors, 3));
  }

  /** Where the checkerboard takes its squares from; there are none at vertices without a `partner`. */
  setPlaces(place: Float32Array, partner: Int32Array): void {
    const matched = Float32Array.from(partner, (v) => (v === NONE ? 0 : 1));
    this.mesh.geometry.setAttribute('matched', new BufferAttribute(matched, 1));
    this.mesh.geometry.setAttribute('place', attribute(place, 3));
  }

  /** Where `setMorph(1)` takes the vertices. */
  setMoved(position: Float32Array, normal: Float32Array): void {
    this.mesh.geometry.setAttribute('moved', attribute(position, 3));
    this.mesh.geometry.setAttribute('movedNormal', attribute(normal, 3));
  }

  /** After the shape's own arrays were changed. */
  shapeChanged(): void {
    for (const name of ['position', 'normal'])
      this.mesh.geometry.getAttribute(name).needsUpdate = true;
  }

  setMorph(share: number): void {
    this.mesh.material.uniforms.morph!.value = share;
  }

  /** Squares along the longest direction of the target, 0 for none. */
  setChecker(squares: number): void {
    this.mesh.material.uniforms.checker!.value = squares;
  }

  /** Shows it as a grey veil over what else there is. */
  setGhost(ghost: boolean): void {
    const { material } = this.mesh;
    material.uniforms.opacity!.value = ghost ? 0.4 : 1;
    material.uniforms.grey!.value = ghost ? 1 : 0;
    // Where surfaces coincide, the other one shows.
    material.uniforms.retreat!.value = ghost ? 0.012 : 0;
    material.transparent = ghost;
    material.depthWrite = !ghost;
    material.needsUpdate = true;
    this.mesh.renderOrder = ghost ? 1 : 0;
  }

  /** Component `k` of vertex `v` as it is shown. */
  coordinate(v: number, k: number): number {
    const morph = this.mesh.material.uniforms.morph!.value as number;
    const at = this.shape.position[3 * v + k]!;
    if (morph === 0) return at;
    const moved = this.mesh.geometry.getAttribute('moved').array as Float32Array;
    return at + morph * (moved[3 * v + k]! - at);
  }

  normalComponent(v: number, k: number): number {
    const morph = this.mesh.material.uniforms.morph!.value as number;
    const at = this.shape.normal[3 * v + k]!;
    if (morph === 0) return at;
    const moved = this.mesh.geometry.getAttribute('movedNormal').array as Float32Array;
    return at + morph * (moved[3 * v + k]! - at);
  }

  get count(): number {
    return this.shape.count;
  }
}
