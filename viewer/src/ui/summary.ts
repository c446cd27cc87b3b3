import type { Result } from '../data/result';
import { statistics } from '../data/statistics';
import type { Report } from '../data/manifest';
import { number, percent } from './format';

export interface Remark {
  kind: 'good' | 'bad' | 'plain';
  text: string;
}

function coverage(result: Result, map: number): Remark {
  const { partner } = result.map(map);
  const { report } = result.manifest;
  // The page may show fewer vertices than there are; the report counts all, of the best map.
  const counted = map === 0 ? report.source_vertices_unmatched : undefined;
  const unmatched = counted ?? partner.filter((t) => t < 0).length;
  const all = counted === undefined ? partner.length : report.source.vertices;
  if (unmatched === 0)
    return { kind: 'plain', text: `Every vertex of the source (${number(all)}) is matched.` };
  return {
    kind: 'bad',
    text: `${number(unmatched)} of ${number(all)} vertices of the source have no match and are grey.`,
  };
}

function choice({ ambiguity, ambiguous }: Report): Remark | null {
  if (!ambiguous || ambiguity === undefined) return null;
  return {
    kind: 'bad',
    text: `Ambiguous: another, quite different map fits nearly as well (${percent(ambiguity)}). Look for a flip.`,
  };
}

function landmarks({ contradicted_landmarks: pairs = [] }: Report): Remark | null {
  if (pairs.length === 0) return null;
  const names = pairs.map(([source, target]) => `${source} → ${target}`).join(', ');
  return {
    kind: 'bad',
    text: `Landmarks that contradict the shapes: ${names}. Without them a far better map is found.`,
  };
}

function orientation(report: Report): Remark | null {
  if (report.oriented !== false) return null;
  return {
    kind: 'bad',
    text: 'A mesh does not tell outside from inside, so the map may be a mirror image.',
  };
}

function distortion(result: Result, map: number): Remark {
  const { mean, max } = statistics(result.map(map).dIso);
  return {
    kind: 'plain',
    text: `Distances along the surface change by ${percent(mean)} of the shape’s extent on average, ${percent(max)} at the worst vertex (isometric distortion).`,
  };
}

function truth(result: Result, map: number): Remark | null {
  const { error } = result.map(map);
  if (!error) return null;
  const { mean } = statistics(error);
  const near = error.filter((e) => e <= 0.05).length / error.filter((e) => !Number.isNaN(e)).length;
  return {
    kind: mean < 0.05 && near > 0.95 ? 'good' : 'bad',
    text: `Against the ground truth: mean error ${percent(mean)} of √area; ${percent(near)} of the vertices within 5 %.`,
  };
}

/** What a person wants to know of the pair and of a map, in plain words. */
export function remarks(result: Result, map: number): Remark[] {
  const { report } = result.manifest;
  const all = [
    choice(report),
    landmarks(report),
    orientation(report),
    truth(result, map),
    coverage(result, map),
    distortion(result, map),
  ];
  return all.filter((remark): remark is Remark => remark !== null);
}

/** What is unusual about the meshes, and about how they are shown. */
export function warnings(result: Result): string[] {
  const { report, source, target } = result.manifest;
  const all: string[] = [];
  for (const [name, mesh, shown] of [
    ['Source', report.source, source],
    ['Target', report.target, target],
  ] as const) {
    for (const warning of mesh.warnings ?? []) all.push(`${name}: ${warning}`);
    if (shown.simplified)
      all.push(
        `${name}: simplified for display from ${number(shown.vertices_given)} to ${number(shown.vertices)} vertices. The match itself used all of them.`,
      );
  }
  return all;
}
