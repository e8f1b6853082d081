import { expect, test } from 'vitest';
import { richScene } from './broken/good-scene.ts';
import { parseScene } from './parse-scene.ts';
import { isParsedScene } from './trusted-scenes.ts';
import { withCamera } from './with-camera.ts';

test('another camera, with what moves it and without what moved the first', () => {
  const track = (target: string) => ({ target, times: [0, 1], values: [30, 60] });
  const draft = richScene();
  draft.clips.wave.tracks.push(track('/camera/verticalFov'), track('/cameras/close/verticalFov'));
  draft.animation.push({ target: '/camera/focusDistance', keys: [{ time: 0, value: 1 }] });
  const parsed = parseScene(draft);
  if (!parsed.ok) throw new Error(parsed.problems[0]!.message);
  const scene = withCamera(parsed.scene, 'close');
  expect(isParsedScene(scene)).toBe(true);
  expect(scene.camera).toBe(parsed.scene.cameras!.close);
  const targets = scene.clips!.wave!.tracks.map(({ target }) => target);
  expect(targets.slice(-2)).toEqual(['/cameras/close/verticalFov', '/camera/verticalFov']);
  expect(targets).toHaveLength(parsed.scene.clips!.wave!.tracks.length);
  expect(scene.animation.map(({ target }) => target)).not.toContain('/camera/focusDistance');
  expect(() => withCamera(parsed.scene, 'far')).toThrow('no camera "far"');
});
