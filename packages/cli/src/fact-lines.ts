/** Facts about a file as lines that people read: a name, then what it is; the parts of a thing each on a line of their own. */

/** Longer texts, such as the scene in a picture's text chunk, are told by their length: `--json` has them whole. */
const LONGEST = 160;
const NAME_WIDTH = 12;
const PART_WIDTH = 14;

export function factLines(facts: Readonly<Record<string, unknown>>): string[] {
  return Object.entries(facts).flatMap(([name, value]) => {
    const [first = '', ...others] = linesOf(opened(value));
    return [`${name.padEnd(NAME_WIDTH)} ${first}`, ...others.map((line) => `${''.padEnd(NAME_WIDTH)} ${line}`)].map(
      (line) => line.trimEnd(),
    );
  });
}

/** Texts of pictures may hold things written as JSON. */
function opened(value: unknown): unknown {
  if (typeof value !== 'string' || !value.startsWith('{')) return value;
  try {
    return JSON.parse(value);
  } catch {
    return value;
  }
}

function linesOf(value: unknown): string[] {
  if (Array.isArray(value) && value.some((item) => typeof item === 'string' && item.length > 40))
    return value.map(told);
  if (!isThing(value)) return [told(value)];
  const entries = Object.entries(value);
  if (JSON.stringify(value).length > 20 * LONGEST) return [`${entries.length} entries, whole with --json`];
  return entries.map(([key, part]) => `${key.padEnd(PART_WIDTH)} ${told(part)}`);
}

function told(value: unknown): string {
  if (typeof value === 'number') return String(Number(value.toPrecision(6)));
  if (Array.isArray(value)) return value.map(told).join(', ');
  if (isThing(value))
    return Object.entries(value)
      .map(([key, part]) => `${key} ${told(part)}`)
      .join(', ');
  const text = String(value);
  return text.length > LONGEST ? `${text.length} characters, whole with --json` : text;
}

const isThing = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);
