import { expect, test, vi } from 'vitest';
import { type Actions, createProgram, exitOfCommander, type RenderOptions } from './arguments.ts';
import { EXIT } from './exit-codes.ts';

function parse(...args: string[]) {
  const render = vi.fn(async () => {});
  const other = vi.fn(async () => {});
  const actions = { render, merge: other, compare: other, validate: other, schema: other, info: other, doctor: other };
  const program = createProgram('1.2.3', actions as unknown as Actions);
  let said = '';
  const output = { writeErr: (text: string) => (said += text), writeOut: (text: string) => (said += text) };
  for (const command of [program, ...program.commands]) command.configureOutput(output);
  let code: number | null = null;
  try {
    program.parse(args, { from: 'user' });
  } catch (error) {
    code = exitOfCommander(error);
  }
  const [scene, options] = (render.mock.calls[0] ?? []) as unknown as [string, RenderOptions];
  return { scene, options, code, said };
}

test('all options of render', () => {
  const { scene, options } = parse(
    ...'render a.json -o out.exr --spp 1024 --size 640x360 --max-depth -1 --seed 7 --integrator path --time -1.5'.split(
      ' ',
    ),
    ...'--frames 0-119 --fps 30 --region 1,2,3,4 --until-error 0.01 --until-time 60 --backend cpu --resume --save-every 9'.split(
      ' ',
    ),
    ...'--half --bits 16 --exposure -2 --json'.split(' '),
  );
  expect(scene).toBe('a.json');
  expect(options).toEqual({
    output: 'out.exr',
    spp: 1024,
    size: { width: 640, height: 360 },
    maxDepth: -1,
    seed: 7,
    integrator: 'path',
    time: -1.5,
    frames: { first: 0, last: 119 },
    fps: 30,
    region: { x: 1, y: 2, width: 3, height: 4 },
    untilError: 0.01,
    untilTime: 60,
    backend: 'cpu',
    resume: true,
    saveEvery: 9,
    half: true,
    bits: '16',
    exposure: -2,
    json: true,
  });
});

test('merge may leave gaps', () => {
  expect(parse(...'merge a.part b.part -o x.exr --allow-gaps'.split(' ')).code).toBeNull();
  expect(parse('render', 'a.json', '-o', 'x.exr', '--allow-gaps').code).toBe(EXIT.usage);
});

test('what is left out', () => {
  const { options } = parse('render', 'a.json', '-o', 'x.png');
  const rest = {
    size: { width: 1280, height: 720 },
    seed: 0,
    saveEvery: 60,
    time: 0,
    fps: 24,
    backend: 'auto',
    bits: '8',
  };
  expect(options).toEqual({ output: 'x.png', ...rest });
});

test.each([
  ['--spp', '0', 'a whole number from 1 to 16777216'],
  ['--spp', '1e3', 'a whole number from 1 to 16777216'],
  ['--spp', '99999999999999999999', 'a whole number from 1 to 16777216'],
  ['--size', '0x10', 'WIDTHxHEIGHT as in 1280x720'],
  ['--size', '10', 'WIDTHxHEIGHT as in 1280x720'],
  ['--size', '-1x5', 'WIDTHxHEIGHT as in 1280x720'],
  ['--seed', '-1', 'a whole number from 0 to 4294967295'],
  ['--seed', '4294967296', 'a whole number from 0 to 4294967295'],
  ['--time', 'NaN', 'a number from'],
  ['--time', 'Infinity', 'a number from'],
  ['--time', '0x10', 'a number from'],
  ['--frames', '9-3', 'one whole number or two'],
  ['--samples', '-5', 'one whole number or two'],
  ['--samples', '0-99999999', 'one whole number or two'],
  ['--region', '1,2,3', 'x,y,width,height in pixels'],
  ['--region', '1,2,0,4', 'x,y,width,height in pixels'],
  ['--pixel', '1.5,2', 'x,y in pixels'],
  ['--until-error', '0', 'a number above 0'],
  ['--until-time', '-3', 'a number above 0'],
  ['--max-depth', '0', 'a whole number from 1 to 4096'],
  ['--max-reflections', '65', 'a whole number from 0 to 64'],
  ['--light-samples', '257', 'a whole number from 1 to 256'],
  ['--backend', 'opengl', 'Allowed choices are auto, webgpu, chromium, cpu'],
  ['--bits', '12', 'Allowed choices are 8, 16'],
])('%s %s is refused with a sentence', (flag, value, allowed) => {
  const { code, said, scene } = parse('render', 'a.json', '-o', 'x.png', flag, value);
  expect(scene).toBeUndefined();
  expect(code).toBe(EXIT.usage);
  expect(said).toContain(flag);
  expect(said).toContain(allowed);
});

test('help and version are no mistakes; unknown commands and options, and missing arguments, are', () => {
  expect(parse('--help').code).toBe(EXIT.done);
  expect(parse('render', '--help').code).toBe(EXIT.done);
  expect(parse('--version')).toMatchObject({ code: EXIT.done, said: '1.2.3\n' });
  expect(parse('rendr')).toMatchObject({ code: EXIT.usage });
  expect(parse('rendr').said).toContain('Did you mean render?');
  expect(parse('render').code).toBe(EXIT.usage);
  expect(parse('render', 'a', '--ssp', '3').said).toContain('Did you mean --spp?');
  expect(parse('merge', 'a.part').code).toBe(EXIT.usage);
  expect(parse('compare', 'a.exr').code).toBe(EXIT.usage);
  expect(parse().code).toBe(EXIT.usage);
});
