/** Linear red, green and blue in [0, 1]. */
export type Rgb = [number, number, number];

const clamp = (x: number): number => Math.min(1, Math.max(0, x));

/** The colour at lightness `l` and opponents `a` (green-red) and `b` (blue-yellow), Ottosson 2020. */
export function fromOklab(l: number, a: number, b: number): Rgb {
  const long = (l + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const medium = (l - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const small = (l - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    clamp(4.0767416621 * long - 3.3077115913 * medium + 0.2309699292 * small),
    clamp(-1.2684380046 * long + 2.6097574011 * medium - 0.3413193965 * small),
    clamp(-0.0041960863 * long - 0.7034186147 * medium + 1.707614701 * small),
  ];
}

export const toLinear = (srgb: number): number =>
  srgb <= 0.04045 ? srgb / 12.92 : ((srgb + 0.055) / 1.055) ** 2.4;

export const toSrgb = (linear: number): number =>
  linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055;

export function css([r, g, b]: Rgb): string {
  const byte = (x: number) => Math.round(255 * toSrgb(clamp(x)));
  return `rgb(${byte(r)} ${byte(g)} ${byte(b)})`;
}

/** The colour of a place in the colour box, as results/picture/position_colors.cpp has it. */
export function positionColor(x: number, y: number, z: number): Rgb {
  const [s, t, u] = [clamp(x), clamp(y), clamp(z)];
  return fromOklab(0.42 + 0.18 * s + 0.28 * u, -0.15 + 0.32 * t, -0.19 + 0.35 * s);
}
