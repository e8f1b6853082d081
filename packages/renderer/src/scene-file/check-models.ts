/** Names that belong to the models of a scene. */
import { belongsTo } from '../scene/models.ts';
import type { Sections } from './check-scene.ts';
import type { FaultyPlaces } from './faulty-places.ts';
import { MODEL_SECTIONS } from './model-things.ts';
import { type ProblemList, quote } from './problem.ts';

export function checkModels(scene: Sections, faulty: FaultyPlaces, problems: ProblemList): void {
  for (const model of Object.keys(scene.models ?? {}))
    for (const section of MODEL_SECTIONS) {
      if (faulty.has(section)) continue;
      for (const name of Object.keys(scene[section] ?? {})) {
        if (!belongsTo(model, name) || (name === model && section !== 'nodes')) continue;
        const message = `The name ${quote(name)} belongs to the model ${quote(model)}, whose own things get such names; please choose another.`;
        problems.add([section, name], `the name ${quote(name)}`, 'another name', message);
      }
    }
}
