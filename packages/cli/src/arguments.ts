/** The commands and their options: what can be typed, and nothing of what is done then. */
import { Command, CommanderError, Option } from 'commander';
import { builtInScenes } from 'mirrorball/built-in';
import { AOV_NAMES, type AovName } from 'mirrorball/headless';
import { SCENE_LIMITS } from 'mirrorball/scene';
import { EXIT, type ExitCode } from './exit-codes.ts';
import type { SampleRange } from './sample-ranges.ts';
import { depth, names, pixel, positive, range, real, region, size, whole } from './values.ts';

/** A film's sample index must stay exact in float32. */
const MOST_SAMPLES = 2 ** 24;
const MOST_SIDE = 32768;

export const BACKENDS = ['webgpu', 'chromium', 'cpu'] as const;
export type BackendName = (typeof BACKENDS)[number];
export type BackendChoice = BackendName | 'auto';

export interface CommonOptions {
  readonly json?: boolean;
}
export interface OutputOptions extends CommonOptions {
  readonly half?: boolean;
  readonly bits: '8' | '16';
  readonly exposure?: number;
  readonly aov?: readonly AovName[];
}
/** What of a scene is shown, and in what light. */
export interface ChoiceOptions {
  /** Name of a picture of all around. */
  readonly env?: string;
  /** Degrees about +Y. */
  readonly envRotation?: number;
  readonly envStrength?: number;
  /** Name of one of the scene's other cameras, or "frame". */
  readonly camera?: string;
  /** Name of a clip, or "none". */
  readonly clip?: string;
  readonly variant?: string;
}
export interface ConvertOptions extends CommonOptions, ChoiceOptions {
  readonly time: number;
  readonly size: { readonly width: number; readonly height: number };
  readonly spp: number;
}
export interface RenderOptions extends OutputOptions, ChoiceOptions {
  readonly output?: string;
  readonly spp?: number;
  readonly size: { readonly width: number; readonly height: number };
  readonly integrator?: 'classic' | 'path';
  readonly maxDepth?: number;
  readonly maxReflections?: number;
  readonly lightSamples?: number;
  readonly seed: number;
  readonly time: number;
  readonly frames?: SampleRange;
  readonly fps: number;
  readonly samples?: SampleRange;
  readonly region?: { readonly x: number; readonly y: number; readonly width: number; readonly height: number };
  readonly pixel?: { readonly x: number; readonly y: number };
  readonly untilError?: number;
  readonly untilTime?: number;
  readonly backend: BackendChoice;
  readonly resume?: boolean;
  /** Seconds; 0: never. */
  readonly saveEvery: number;
}
export interface MergeOptions extends OutputOptions {
  readonly output: string;
  readonly backend: BackendChoice;
  readonly allowGaps?: boolean;
}

export interface BenchOptions extends CommonOptions {
  readonly backend: BackendChoice;
  /** Ids of built-in scenes. */
  readonly scene?: readonly string[];
  readonly size: { readonly width: number; readonly height: number };
  readonly spp: number;
  readonly seconds: number;
}

/** What each command does. */
export interface Actions {
  render(scene: string, options: RenderOptions): Promise<void>;
  merge(parts: string[], options: MergeOptions): Promise<void>;
  convert(scene: string, output: string, options: ConvertOptions): Promise<void>;
  compare(a: string, b: string, options: CommonOptions): Promise<void>;
  validate(scenes: string[], options: CommonOptions): Promise<void>;
  schema(options: { readonly output?: string }): Promise<void>;
  info(files: string[], options: CommonOptions): Promise<void>;
  doctor(options: CommonOptions): Promise<void>;
  bench(options: BenchOptions): Promise<void>;
}

const json = () => new Option('--json', 'one JSON object a line on standard output');
const output = () =>
  new Option('-o, --output <file>', 'where to: .exr, .png, .pfm, .npy, .hdr, or .part to go on later');
const pictureOptions = (command: Command): Command =>
  command
    .addOption(new Option('--half', 'EXR with 16-bit floats'))
    .addOption(new Option('--bits <n>', 'bits of a PNG channel').choices(['8', '16']).default('8'))
    .addOption(new Option('--exposure <stops>', "PNG: brightness; default: the scene's").argParser(real(-32, 32)))
    .addOption(
      new Option('--aov <names>', `more than the picture, with commas: ${AOV_NAMES.join(', ')}`).argParser(
        names(AOV_NAMES),
      ),
    )
    .addOption(new Option('--backend <name>', 'what traces').choices(['auto', ...BACKENDS]).default('auto'));

const choiceOptions = (command: Command): Command =>
  command
    .addOption(new Option('--env <file>', 'light from a picture of all around: .hdr, .exr, .npy, .pfm'))
    .addOption(new Option('--env-rotation <degrees>', 'turns it about +Y').argParser(real(-1e6, 1e6)))
    .addOption(new Option('--env-strength <n>', 'factor on its light').argParser(real(0, 1e6)))
    .addOption(new Option('--camera <name>', "one of the scene's other cameras; frame: one that shows everything"))
    .addOption(new Option('--clip <name>', 'the clip that plays; none: none'))
    .addOption(new Option('--variant <name>', 'other materials, by the name of the choice'));

function addConvert(program: Command, actions: Actions): void {
  const command = program.command('convert').description('write a scene in another format, and what that cannot say');
  command
    .argument('<scene>', 'a scene file, a model, or a built-in scene by its name')
    .argument('<output>', '.glb, .xml (Mitsuba 3, with meshes and a program beside it) or .json')
    .addOption(new Option('--time <s>', '.xml: seconds into the animation').argParser(real(-1e9, 1e9)).default(0))
    .addOption(
      new Option('--size <WxH>', '.xml: pixels')
        .argParser(size(MOST_SIDE))
        .default({ width: 1280, height: 720 }, '1280x720'),
    )
    .addOption(new Option('--spp <n>', '.xml: samples a pixel').argParser(whole(1, MOST_SAMPLES)).default(64));
  choiceOptions(command).addOption(json());
  command.action((scene: string, out: string, options: ConvertOptions) => actions.convert(scene, out, options));
}

function addRender(program: Command, actions: Actions): void {
  const command = program
    .command('render')
    .description('render a scene file or a model (or a built-in scene by its name)');
  command
    .argument(
      '<scene>',
      'scene.json, model.glb, - (standard input), or cube-room, mirror-blocks, moving-shadows, materials',
    )
    .addOption(output());
  const option = (flags: string, about: string) => new Option(flags, about);
  command
    .addOption(option('--spp <n>', 'samples a pixel (default: 64)').argParser(whole(1, MOST_SAMPLES)))
    .addOption(option('--samples <a-b>', 'only these samples, to merge later').argParser(range(MOST_SAMPLES - 1)))
    .addOption(
      option('--size <WxH>', 'pixels').argParser(size(MOST_SIDE)).default({ width: 1280, height: 720 }, '1280x720'),
    )
    .addOption(option('--region <x,y,w,h>', 'only this part of the picture').argParser(region(MOST_SIDE)))
    .addOption(option('--pixel <x,y>', 'only this pixel; prints its value').argParser(pixel(MOST_SIDE)))
    .addOption(option('--integrator <name>', "default: the scene's").choices(['classic', 'path']))
    .addOption(option('--max-depth <n>', 'path: path segments, -1 = no limit').argParser(depth(SCENE_LIMITS.maxDepth)))
    .addOption(option('--max-reflections <n>', 'classic: mirror rays').argParser(whole(0, SCENE_LIMITS.maxReflections)))
    .addOption(
      option('--light-samples <n>', 'classic: points on each light').argParser(whole(1, SCENE_LIMITS.lightSamples)),
    )
    .addOption(
      option('--seed <n>', 'of the random numbers')
        .argParser(whole(0, 2 ** 32 - 1))
        .default(0),
    )
    .addOption(option('--time <s>', 'seconds into the animation').argParser(real(-1e9, 1e9)).default(0))
    .addOption(option('--frames <a-b>', 'frames of the animation; the file gets numbers').argParser(range(999_999)))
    .addOption(option('--fps <n>', 'frames a second').argParser(positive(1e6)).default(24))
    .addOption(option('--until-error <e>', 'stop when the estimated error is below').argParser(positive(1e6)))
    .addOption(option('--until-time <s>', 'stop after so many seconds a picture').argParser(positive(1e9)))
    .addOption(option('--resume', 'go on from what an interrupted run saved'))
    .addOption(
      option('--save-every <s>', 'save the samples so far every so many seconds, 0 = never')
        .argParser(real(0, 1e9))
        .default(60),
    );
  choiceOptions(command);
  pictureOptions(command).addOption(json());
  command.action((scene: string, options: RenderOptions) => actions.render(scene, options));
}

function addOthers(program: Command, actions: Actions): void {
  const merge = program.command('merge').description('put part files of one picture together');
  merge.argument('<parts...>', 'what `render -o x.part` or an interrupted run wrote');
  merge.addOption(output().makeOptionMandatory());
  merge.addOption(new Option('--allow-gaps', 'the whole picture, black where pixels are in no part'));
  pictureOptions(merge).addOption(json());
  merge.action((parts: string[], options: MergeOptions) => actions.merge(parts, options));
  program
    .command('compare')
    .description('how much two pictures differ')
    .argument('<a>', 'a picture or part file')
    .argument('<b>', 'the reference')
    .addOption(json())
    .action((a: string, b: string, options: CommonOptions) => actions.compare(a, b, options));
  program
    .command('validate')
    .description('list everything that is wrong with scene files')
    .argument('<scenes...>', 'scene files')
    .addOption(json())
    .action((scenes: string[], options: CommonOptions) => actions.validate(scenes, options));
  program
    .command('schema')
    .description('the JSON Schema of scene files')
    .option('-o, --output <file>', 'write it there')
    .action((options: { output?: string }) => actions.schema(options));
  program
    .command('info')
    .description('what is in scenes, models, meshes, pictures and part files')
    .argument('<files...>', 'files')
    .addOption(json())
    .action((files: string[], options: CommonOptions) => actions.info(files, options));
  program
    .command('doctor')
    .description('what can render here, what is missing, and how to get it')
    .addOption(json())
    .action((options: CommonOptions) => actions.doctor(options));
}

function addBench(program: Command, actions: Actions): void {
  const scenes = builtInScenes.map(({ id }) => id);
  program
    .command('bench')
    .description('how fast this machine traces: both integrators, backend by backend')
    .addOption(
      new Option('--backend <name>', 'only this one; auto: webgpu and chromium')
        .choices(['auto', ...BACKENDS])
        .default('auto'),
    )
    .addOption(
      new Option('--scene <names>', `with commas: ${scenes.join(', ')} (default: cube-room,materials)`).argParser(
        names(scenes),
      ),
    )
    .addOption(
      new Option('--size <WxH>', 'pixels').argParser(size(MOST_SIDE)).default({ width: 320, height: 180 }, '320x180'),
    )
    .addOption(new Option('--spp <n>', 'samples a pixel at most').argParser(whole(1, MOST_SAMPLES)).default(65536))
    .addOption(new Option('--seconds <s>', 'of each measurement, about').argParser(positive(3600)).default(0.7))
    .addOption(json())
    .action((options: BenchOptions) => actions.bench(options));
}

export function createProgram(version: string, actions: Actions): Command {
  const program = new Command('mirrorball');
  program.description('Renders, merges, checks and compares without a window.').version(version);
  program.exitOverride().showSuggestionAfterError().enablePositionalOptions();
  addRender(program, actions);
  addConvert(program, actions);
  addOthers(program, actions);
  addBench(program, actions);
  // Subcommands made before an override would not have it.
  for (const command of program.commands) {
    command
      .copyInheritedSettings(program)
      .showHelpAfterError(`(mirrorball ${command.name()} --help lists the options)`);
  }
  program.showHelpAfterError('(mirrorball --help lists the commands)');
  return program;
}

/** Commander's own ends: help and version are done, all else is a mistake in what was typed. Null: not commander's. */
export function exitOfCommander(error: unknown): ExitCode | null {
  if (!(error instanceof CommanderError)) return null;
  const asked = ['commander.helpDisplayed', 'commander.version'].includes(error.code);
  return asked ? EXIT.done : EXIT.usage;
}
