import type { ViewName } from 'mirrorball';
import { en } from './en.ts';

/**
 * The address as an input, so that a picture can be linked, tested and measured:
 *
 *     ?scene=cube-room      one of the built-in scenes: cube-room, mirror-blocks, moving-shadows, materials
 *     &backend=webgl2       webgpu, webgl2 or cpu; else the best there is
 *     &integrator=path      classic or path     &depth=8       segments of a path, 1 … 4096; -1: no limit
 *     &aperture=0.02        radius of the lens, metres, 0: a pinhole     &focus=3.5    metres to what is sharp, 0: as far as the target
 *     &reflections=10       0 … 64               &samples=9     points on each light, 1 … 256
 *     &exposure=0.5         stops, −10 … 10      &compare=reflections    or samples: three strips side by side
 *     &tone=agx             tone mapping: none, aces, agx or neutral
 *     &view=depth           instead of the picture: albedo, normal, geometric-normal, depth, position, primitive-id, material-id
 *     &time=1.3             seconds to start at  &paused=1      stand still (0: move, even where reduced motion is wished)
 *     &scale=1              resolution scale, 0.1 … 1           &adaptive=0    hold that scale in motion
 *     &seed=1               of the random numbers
 *     &size=512             a canvas of 512 × 512 pixels at the top left, device pixel ratio 1
 *     &ui=0                 nothing but the picture             &lang=zh       en or zh
 *
 * What cannot be understood is left out and reported in `problems` and `unknown`.
 */
export interface UrlParameters {
  readonly scene: string | null;
  readonly backend: 'webgpu' | 'webgl2' | 'cpu' | null;
  readonly size: number | null;
  readonly integrator: 'classic' | 'path' | null;
  readonly depth: number | null;
  readonly aperture: number | null;
  readonly focus: number | null;
  readonly reflections: number | null;
  readonly samples: number | null;
  readonly exposure: number | null;
  readonly tone: 'none' | 'aces' | 'agx' | 'neutral' | null;
  readonly view: ViewName | null;
  readonly compare: 'off' | 'reflections' | 'samples' | null;
  readonly time: number | null;
  readonly paused: boolean | null;
  readonly scale: number | null;
  readonly adaptive: boolean | null;
  readonly seed: number | null;
  readonly ui: boolean;
  readonly lang: string | null;
  /** Such as "reflections=100 (0 … 64)". */
  readonly problems: readonly string[];
  /** Parameters that there are not, such as "reflection=10", and those that are there once more. */
  readonly unknown: readonly string[];
}

const VIEWS = Object.keys(en.viewNames) as readonly ViewName[];

/** Metres, as in scene files. */
const FARTHEST = 1e9;
/** So many parameters that there are not are named. */
const MOST_UNKNOWN = 8;

class Reader {
  readonly problems: string[] = [];
  private readonly query: URLSearchParams;
  private readonly known = new Set<string>();
  constructor(search: string) {
    this.query = new URLSearchParams(search);
  }

  private text(name: string): string | null {
    this.known.add(name);
    return this.query.get(name);
  }

  number(name: string, low: number, high: number, whole = false): number | null {
    const text = this.text(name);
    if (text === null) return null;
    const value = text.trim() === '' ? Number.NaN : Number(text);
    if (value >= low && value <= high && (!whole || Number.isInteger(value))) return value;
    return this.refuse(name, text, `${low} … ${high}`);
  }

  /** Segments of a path. */
  depth(name: string): number | null {
    const depth = this.number(name, -1, 4096, true);
    return depth === 0 ? this.refuse(name, '0', '1 … 4096, or -1') : depth;
  }

  choice<Choice extends string>(name: string, choices: readonly Choice[]): Choice | null {
    const text = this.text(name);
    if (text === null) return null;
    return choices.find((choice) => choice === text) ?? this.refuse(name, text, choices.join(', '));
  }

  flag(name: string): boolean | null {
    const choice = this.choice(name, ['0', '1']);
    return choice === null ? null : choice === '1';
  }

  private refuse(name: string, text: string, allowed: string): null {
    this.problems.push(`${name}=${text.slice(0, 40)} (${allowed})`);
    return null;
  }

  /** The first few parameters that nobody has asked for, and those that are there again: the first one counts. */
  unknown(): string[] {
    const seen = new Set<string>();
    const strangers = [...this.query].filter(([name]) => !this.known.has(name) || seen.size === seen.add(name).size);
    return strangers.slice(0, MOST_UNKNOWN).map(([name, text]) => `${name}=${text}`.slice(0, 40));
  }
}

export function readParameters(search: string, sceneIds: readonly string[]): UrlParameters {
  const read = new Reader(search);
  return {
    scene: read.choice('scene', sceneIds),
    backend: read.choice('backend', ['webgpu', 'webgl2', 'cpu']),
    size: read.number('size', 1, 8192, true),
    integrator: read.choice('integrator', ['classic', 'path']),
    depth: read.depth('depth'),
    aperture: read.number('aperture', 0, FARTHEST),
    focus: read.number('focus', 0, FARTHEST),
    reflections: read.number('reflections', 0, 64, true),
    samples: read.number('samples', 1, 256, true),
    exposure: read.number('exposure', -10, 10),
    tone: read.choice('tone', ['none', 'aces', 'agx', 'neutral']),
    view: read.choice('view', VIEWS),
    compare: read.choice('compare', ['off', 'reflections', 'samples']),
    time: read.number('time', 0, 1e6),
    paused: read.flag('paused'),
    scale: read.number('scale', 0.1, 1),
    adaptive: read.flag('adaptive'),
    seed: read.number('seed', 0, 0xffffffff, true),
    ui: read.flag('ui') ?? true,
    lang: read.choice('lang', ['en', 'zh', 'zh-CN']),
    problems: read.problems,
    unknown: read.unknown(),
  };
}
