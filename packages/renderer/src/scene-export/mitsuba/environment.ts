/** The sky: a constant, or a picture on Mitsuba's own grid. */
import { writeExr } from '../../export/exr.ts';
import { fromInterleaved } from '../../export/float-picture.ts';
import type { EnvironmentMap } from '../../scene/environment.ts';
import type { Sky } from '../../scene/scene.ts';
import type { PlannedFiles } from '../export-plan.ts';
import type { ExportReport } from '../export-report.ts';
import { type Element, float, plugin, rgb, string, toWorld } from './xml.ts';

/** Rows of the picture of a sky of two colours. */
const ROWS_OF_BLEND = 1024;

export function writeSky(sky: Sky, name: string, files: PlannedFiles, report: ExportReport): Element[] {
  const { horizon, zenith, map, scale = 1, rotation = 0 } = sky;
  const picture = (content: () => EnvironmentMap, factor: number): Element[] => {
    const file = `${name}.sky.exr`;
    files.set(file, () => {
      const { width, height, data } = content();
      return [writeExr(fromInterleaved(width, height, ['R', 'G', 'B'], data))];
    });
    const angle = (rotation * Math.PI) / 180;
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const turn = rotation === 0 ? [] : [toWorld([c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0])];
    return [plugin('emitter', 'envmap', [string('filename', file), float('scale', factor), ...turn])];
  };
  if (map) return picture(() => onMitsubasGrid(map), scale);
  if (horizon.every((x, c) => x === zenith[c]))
    return horizon.some((x) => x > 0) ? [plugin('emitter', 'constant', [rgb('radiance', horizon)])] : [];
  report.add('changed', `A sky of two colours is a picture of ${ROWS_OF_BLEND} rows there.`, 'sky');
  return picture(() => blend(horizon, zenith), 1);
}

/** Rows lie at j / (rows − 1) there, so the poles have rows of their own. */
function blend(horizon: readonly number[], zenith: readonly number[]): EnvironmentMap {
  const [width, height] = [3, ROWS_OF_BLEND];
  const data = new Float32Array(width * height * 3);
  for (let i = 0; i < data.length; i++) {
    const share = Math.max(Math.cos((Math.PI * Math.floor(i / 3 / width)) / (height - 1)), 0);
    data[i] = horizon[i % 3]! + (zenith[i % 3]! - horizon[i % 3]!) * share;
  }
  return { width, height, data };
}

/**
 * Our texels have their centres at ((i + ½) / W, (j + ½) / H), Mitsuba's at ((i + ½) / W′, j / (H′ − 1)). With W′ = 3 W and
 * H′ = 2 H + 1 every kink of our bilinear map lies on a node of its, so that both are the same function.
 */
export function onMitsubasGrid({ width, height, data }: EnvironmentMap): EnvironmentMap {
  const [columns, rows] = [3 * width, 2 * height + 1];
  const out = new Float32Array(columns * rows * 3);
  for (let j = 0; j < rows; j++) {
    const y = Math.min(Math.max(j / 2 - 0.5, 0), height - 1);
    const above = Math.min(Math.floor(y), Math.max(height - 2, 0));
    const below = Math.min(above + 1, height - 1);
    for (let i = 0; i < columns; i++) {
      const x = (i + 0.5) / 3 - 0.5;
      const left = (Math.floor(x) + width) % width;
      const right = (left + 1) % width;
      const [fx, fy] = [x - Math.floor(x), y - above];
      for (let c = 0; c < 3; c++) {
        const at = (row: number, column: number) => data[(row * width + column) * 3 + c]!;
        const line = (row: number) => at(row, left) * (1 - fx) + at(row, right) * fx;
        out[(j * columns + i) * 3 + c] = line(above) * (1 - fy) + line(below) * fy;
      }
    }
  }
  return { width: columns, height: rows, data: out };
}
