import { css, positionColor } from '../color/oklab';
import { isCoarse, type Line, sampledLines, worstByIso, worstByTruth } from '../data/matches';
import type { Result } from '../data/result';
import { NONE } from '../data/shape';
import type { Point, State } from '../state';
import type { Stage } from './stage';
import type { ScreenPoint } from './view';

export const RED = '#e8212b';
export const GREEN = '#13a538';

interface Style {
  color: string;
  width: number;
  alpha: number;
  dash?: number[];
}

function ends(stage: Stage, line: Line): [ScreenPoint, ScreenPoint] {
  return [
    stage.viewOf('source').project(stage.surfaces.source, line.source),
    stage.viewOf('target').project(stage.surfaces.target, line.target),
  ];
}

function stroke(
  context: CanvasRenderingContext2D,
  [from, to]: [ScreenPoint, ScreenPoint],
  { color, width, alpha, dash = [] }: Style,
): void {
  context.globalAlpha = alpha;
  context.strokeStyle = color;
  context.lineWidth = width;
  context.setLineDash(dash);
  context.beginPath();
  context.moveTo(from.x, from.y);
  context.lineTo(to.x, to.y);
  context.stroke();
  context.setLineDash([]);
}

function dot(
  context: CanvasRenderingContext2D,
  { x, y }: ScreenPoint,
  radius: number,
  color: string,
  alpha = 1,
): void {
  context.globalAlpha = alpha;
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fillStyle = color;
  context.fill();
  context.lineWidth = radius > 4 ? 2 : 1;
  context.strokeStyle = radius > 4 ? '#fff' : '#0008';
  context.stroke();
}

/** Thin lines in the colour of their places; faint where an end is on the far side. */
function drawSample(
  context: CanvasRenderingContext2D,
  stage: Stage,
  result: Result,
  state: State,
): void {
  const place = result.target.place!;
  const coarse = isCoarse(result, state);
  const lines = sampledLines(result, state);
  for (const line of lines) {
    const t = 3 * line.target;
    const color = css(positionColor(place[t]!, place[t + 1]!, place[t + 2]!));
    const points = ends(stage, line);
    const seen = points[0].facing && points[1].facing;
    const few = lines.length <= 40;
    const hidden = few ? 0.45 : 0.18;
    stroke(context, points, { color, width: few ? 2 : 1.2, alpha: seen ? 0.85 : hidden });
    const radius = coarse && lines.length < 100 ? 4 : 2.5;
    for (const point of points) dot(context, point, radius, color, point.facing ? 1 : 0.25);
  }
}

function drawWorst(
  context: CanvasRenderingContext2D,
  stage: Stage,
  line: Line | null,
  color: string,
  dash?: number[],
): void {
  if (!line) return;
  const points = ends(stage, line);
  stroke(context, points, { color, width: 4, alpha: 1, dash });
  for (const point of points) dot(context, point, 6, color);
}

/** A point and its partner, or the point alone. */
function drawPoint(
  context: CanvasRenderingContext2D,
  stage: Stage,
  result: Result,
  state: State,
  point: Point,
  color: string,
): void {
  const map = result.map(state.map);
  const partner = (point.side === 'source' ? map.partner : map.back)[point.vertex]!;
  const other = point.side === 'source' ? 'target' : 'source';
  const here = stage.viewOf(point.side).project(stage.surfaces[point.side], point.vertex);
  if (partner !== NONE) {
    const there = stage.viewOf(other).project(stage.surfaces[other], partner);
    stroke(context, [here, there], { color, width: 2, alpha: 0.9, dash: [7, 5] });
    dot(context, there, 6, color);
  }
  dot(context, here, 6, color);
}

/** Draws matches and points over the shapes. */
export function drawAnnotations(
  context: CanvasRenderingContext2D,
  stage: Stage,
  result: Result,
  state: State,
): void {
  if (state.lines > 0) drawSample(context, stage, result, state);
  if (state.worstIso) drawWorst(context, stage, worstByIso(result, state), RED);
  if (state.worstTruth) drawWorst(context, stage, worstByTruth(result, state), GREEN, [14, 5]);
  const accent = getComputedStyle(context.canvas).getPropertyValue('--accent') || '#06c';
  if (state.selected) drawPoint(context, stage, result, state, state.selected, accent);
  if (state.hovered) drawPoint(context, stage, result, state, state.hovered, accent);
  context.globalAlpha = 1;
}
