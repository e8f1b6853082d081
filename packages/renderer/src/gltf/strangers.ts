/** Extensions that a file has and nobody here reads: named with their places. */

import { SUPPORTED_EXTENSIONS } from './check/check-gltf.ts';
import { isObject } from './check/form.ts';
import type { Gltf } from './json.ts';
import type { Path } from './problems.ts';
import type { ReportList } from './report.ts';

/** Things of a file that are looked through. */
const MOST_VALUES = 5_000_000;

export function reportStrangers(json: Gltf, report: ReportList): void {
  const known = new Set(SUPPORTED_EXTENSIONS);
  const found = new Set<string>();
  const stack: { value: unknown; path: Path }[] = [{ value: json, path: [] }];
  for (let left = MOST_VALUES; left > 0; left--) {
    const next = stack.pop();
    if (next === undefined) break;
    const { value, path } = next;
    if (typeof value !== 'object' || value === null) continue;
    const extensions = isObject(value) && Object.hasOwn(value, 'extensions') ? value.extensions : undefined;
    for (const name of isObject(extensions) ? Object.keys(extensions) : []) {
      if (known.has(name)) continue;
      found.add(name);
      report.add('unsupported', name, [...path, 'extensions', name], `The extension ${name} is not read.`);
    }
    for (const [key, part] of Object.entries(value)) {
      if (key === 'extras' || typeof part !== 'object' || part === null) continue;
      if (key !== 'extensions' || !isObject(part))
        stack.push({ value: part, path: [...path, Array.isArray(value) ? Number(key) : key] });
      else
        for (const [name, inner] of Object.entries(part))
          if (known.has(name)) stack.push({ value: inner, path: [...path, key, name] });
    }
  }
  (json.extensionsUsed ?? []).forEach((name, i) => {
    if (!known.has(name) && !found.has(name))
      report.add('unsupported', name, ['extensionsUsed', i], `The extension ${name} is not read.`);
  });
}
