/**
 * Linked WGSL → the same program for scenes that do not ask for some switches of shading/features.wesl: these are constants, what an `if`
 * guards with them is gone, and so is every declaration that nothing asks for any more. The text itself gets shorter, which counts
 * where it is loaded and where a compiler reads all of it before it leaves anything out.
 */

/** `off`: names of switches. Entry points and bindings stay. */
export function withoutFeatures(wgsl: string, off: readonly string[]): string {
  let text = wgsl;
  for (const name of off)
    text = text.replace(new RegExp(`^override ${name} = (true|false);`, 'm'), `const ${name} = false;`);
  return onlyWhatIsAskedFor(withoutSingleTurns(withoutDeadBranches(text, new Set(off)), new Set(off)));
}

/**
 * A loop that ends with `if (!hasX) { break; }`, or `if (!hasX | !hasY) { break; }`, has one turn without such a switch: no loop then, and
 * nothing of what came behind. Windows' FXC takes a seventh longer for a loop over meshes that stands in such a one.
 */
function withoutSingleTurns(wgsl: string, off: ReadonlySet<string>): string {
  let text = wgsl;
  const end = /\bif \((!\w+(?: \| !\w+)*)\) \{\s*break;\s*\}/g;
  for (let found = end.exec(text); found; found = end.exec(text)) {
    if (!operandsOf(found[1]!, '|').some((one) => off.has(one.slice(1)))) continue;
    const open = openingAround(text, found.index);
    const before = text.slice(open + 1, found.index);
    if (!/\bloop $/.test(text.slice(0, open)) || leaves(before)) continue;
    text = `${text.slice(0, open - 'loop '.length)}{${before}}${text.slice(closing(text, open) + 1)}`;
    end.lastIndex = open;
  }
  return text;
}

/** Where the innermost `{` around a place is. */
function openingAround(text: string, at: number): number {
  for (let open = text.lastIndexOf('{', at - 1); open >= 0; open = text.lastIndexOf('{', open - 1))
    if (closing(text, open) > at) return open;
  throw new Error(`In no braces: ${text.slice(at, at + 60)}`);
}

/** Whether statements leave the loop, or the turn of it, that they stand in. */
function leaves(statements: string): boolean {
  let own = statements;
  for (let inner = /\b(?:loop|for \(.*\)|while \(.*\)|switch \(.*\)) \{/.exec(own); inner; ) {
    const open = inner.index + inner[0].length - 1;
    own = own.slice(0, inner.index) + own.slice(closing(own, open) + 1);
    inner = /\b(?:loop|for \(.*\)|while \(.*\)|switch \(.*\)) \{/.exec(own);
  }
  return /\b(?:break|continue|continuing)\b/.test(own);
}

/** Only what stands in parentheses behind `if`: an expression is left as it is. */
function withoutDeadBranches(wgsl: string, off: ReadonlySet<string>): string {
  let text = wgsl;
  for (let at = nextIf(text, 0); at >= 0; at = nextIf(text, at + 1)) {
    const open = text.indexOf('(', at);
    const close = closing(text, open);
    if (!isFalse(text.slice(open + 1, close), off)) continue;
    const end = closing(text, text.indexOf('{', close)) + 1;
    const otherwise = /^\s*else\s*/.exec(text.slice(end))?.[0];
    const before = otherwise === undefined ? text.slice(0, at).replace(/\s*\belse\s*$/, '') : text.slice(0, at);
    text = before + text.slice(end + (otherwise?.length ?? 0));
    // What now stands here may be an `if` again.
    at = Math.min(at, before.length) - 1;
  }
  return text;
}

const nextIf = (text: string, start: number): number => {
  const found = /\bif \(/.exec(text.slice(start));
  return found ? start + found.index : -1;
};

/** Whether each operand of an `|` has such a switch among those of its `&`. */
function isFalse(condition: string, off: ReadonlySet<string>): boolean {
  return operandsOf(condition, '|').every((one) => operandsOf(one, '&').some((part) => off.has(part)));
}

/** What stands between these operators, outside of parentheses. */
function operandsOf(expression: string, operator: '|' | '&'): string[] {
  let depth = 0;
  let operand = '';
  const operands: string[] = [];
  for (const letter of `${expression}${operator}`) {
    if ('(['.includes(letter)) depth++;
    if (')]'.includes(letter)) depth--;
    if (depth === 0 && letter === operator) {
      operands.push(operand.trim());
      operand = '';
    } else operand += letter;
  }
  return operands;
}

/** Where the bracket at `open` is closed. */
function closing(text: string, open: number): number {
  let depth = 0;
  for (let i = open; i < text.length; i++) {
    if (text.startsWith('//', i)) i = text.indexOf('\n', i);
    if ('({['.includes(text[i]!)) depth++;
    if (')}]'.includes(text[i]!)) depth--;
    if (depth === 0) return i;
  }
  throw new Error(`A bracket is not closed: ${text.slice(open, open + 60)}`);
}

interface Declaration {
  readonly text: string;
  readonly name: string;
  /** Stays whether something asks for it or not. */
  readonly stays: boolean;
}

function onlyWhatIsAskedFor(wgsl: string): string {
  const all = declarationsOf(wgsl);
  const byName = new Map(all.map((one) => [one.name, one]));
  const asked = new Set<Declaration>();
  const rest = all.filter(({ stays }) => stays);
  for (let one = rest.pop(); one; one = rest.pop()) {
    if (asked.has(one)) continue;
    asked.add(one);
    for (const [word] of one.text.replace(/\/\/.*$/gm, '').matchAll(/[A-Za-z_]\w*/g)) {
      const other = byName.get(word);
      if (other && !asked.has(other)) rest.push(other);
    }
  }
  return all
    .filter((one) => asked.has(one))
    .map(({ text }) => text)
    .join('');
}

const NAMED = /^(?:@[^\n]*?\) |@\w+ )*(?:fn|struct|const|override|alias|var(?:<[^>]*>)?) (\w+)/m;

/** Each with the comment above it, and the text whole when they are joined. */
function declarationsOf(wgsl: string): Declaration[] {
  const declarations: Declaration[] = [];
  let start = 0;
  let depth = 0;
  for (let i = 0; i < wgsl.length; i++) {
    if (wgsl.startsWith('//', i)) {
      i = wgsl.indexOf('\n', i);
      continue;
    }
    if ('({['.includes(wgsl[i]!)) depth++;
    if (')}]'.includes(wgsl[i]!)) depth--;
    if (depth > 0 || (wgsl[i] !== ';' && wgsl[i] !== '}')) continue;
    const text = wgsl.slice(start, i + 1);
    const code = text.replace(/^\s*\/\/.*$/gm, '').trimStart();
    const name = NAMED.exec(code)?.[1];
    if (name === undefined) throw new Error(`What is declared here? ${code.slice(0, 80)}`);
    declarations.push({
      text,
      name,
      stays: /@(vertex|fragment|compute|binding)\b/.test(code.slice(0, code.indexOf(name))),
    });
    start = i + 1;
  }
  declarations.push({ text: wgsl.slice(start), name: '', stays: true });
  return declarations;
}
