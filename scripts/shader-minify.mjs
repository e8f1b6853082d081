/**
 * Shaders for the page: the same programs in fewer letters. Whitespace goes, what a function declares for itself gets short names, and
 * nothing else is renamed: entry points, bindings, switches, structs and functions keep theirs, so that a driver's complaint is still
 * readable. naga numbers the names in GLSL by program (`_e12`, `point_3`); with names by function the same function is the same text in
 * all programs, and can be stored once (shader-text.mjs).
 */

/** @typedef {'wgsl' | 'glsl'} Language */

/** Words, numbers, operators that belong together, whitespace. */
const TOKEN = /\s+|[A-Za-z_]\w*|(?:0x[\da-fA-F]+|\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?[fuhi]?|->|[\s\S]/g;
const isWord = (/** @type {string | undefined} */ token) => token !== undefined && /^[A-Za-z_]/.test(token);
const isSpace = (/** @type {string} */ token) => /^\s/.test(token);

/** Words of the languages that a short name must not be, and words that stand before a name without declaring it. */
const KEYWORDS = new Set(['as', 'do', 'fn', 'if', 'in', 'of', 'is', 'or']);
const NO_TYPES = new Set(['return', 'else', 'case', 'struct', 'precision', 'uniform', 'in', 'out', 'inout', 'const']);

/** @param {string} text */
export const withoutComments = (text) =>
  text
    .replace(/\/\/.*$/gm, '')
    .replace(/^\s+/gm, '')
    .replace(/[ \t]+$/gm, '');

/**
 * The declarations of a program, each a short text; joined they are the program.
 * @param {string} text
 * @param {Language} language
 * @returns {string[]}
 */
export function minifiedDeclarations(text, language) {
  // Lines of the preprocessor are whole lines.
  const directives = [...text.matchAll(/^#.*\n/gm)].map(([line]) => line);
  const code = withoutComments(text.replace(/^#.*\n/gm, ''));
  const parts = declarations(code.match(TOKEN) ?? []);
  const globals = new Set(
    parts.flatMap((part) =>
      globalNames(
        wordsOf(part).map(({ token }) => token),
        language,
      ),
    ),
  );
  return [...directives, ...parts.map((part) => joined(withShortNames(part, language, globals)))];
}

/**
 * Cut behind each `;` and each closing `}` outside of everything.
 * @param {string[]} tokens
 */
function declarations(tokens) {
  /** @type {string[][]} */
  const parts = [];
  /** @type {string[]} */
  let part = [];
  let depth = 0;
  tokens.forEach((token, i) => {
    if (part.length === 0 && isSpace(token)) return;
    part.push(token);
    if ('({['.includes(token)) depth++;
    if (')}]'.includes(token)) depth--;
    if (depth > 0 || (token !== ';' && token !== '}')) return;
    const next = tokens.slice(i + 1).find((other) => !isSpace(other));
    // `struct A { … };` and `uniform B { … } b;` go on behind the brace; a function does not.
    if (
      token === '}' &&
      (next === ';' || (isWord(next) && /^(layout|uniform)$/.test(part[0] ?? '') && next !== 'layout'))
    )
      return;
    parts.push(part);
    part = [];
  });
  if (part.length > 0) parts.push(part);
  return parts;
}

/** The tokens that are no space, and where they stand. @param {string[]} part */
const wordsOf = (part) => part.map((token, i) => ({ token, i })).filter(({ token }) => !isSpace(token));

/** @param {string[]} words @param {Language} language */
const isFunction = (words, language) =>
  language === 'wgsl' ? words.includes('fn') : isWord(words[0]) && isWord(words[1]) && words[2] === '(';

/**
 * Names that a declaration may give to the whole program, and some more: members of GLSL's blocks are such names, those of structs not.
 * @param {string[]} words
 * @param {Language} language
 */
function globalNames(words, language) {
  if (isFunction(words, language)) return [words[language === 'wgsl' ? words.indexOf('fn') + 1 : 1] ?? ''];
  const isBlock = words.includes('uniform');
  return words.slice(0, isBlock || !words.includes('{') ? words.length : words.indexOf('{')).filter(isWord);
}

/**
 * No space but where two words, or two operators, would become one.
 * @param {string[]} tokens
 */
function joined(tokens) {
  const operator = /[-+*/%<>=!&|^~?:@]$/;
  let text = '';
  let space = false;
  for (const token of tokens) {
    if (isSpace(token)) {
      space = true;
      continue;
    }
    const last = text.at(-1) ?? '';
    const words = /[\w.]/.test(last) && /^[\w.]/.test(token);
    const operators = operator.test(last) && operator.test(token[0] ?? '');
    text += space && (words || operators) ? ` ${token}` : token;
    space = false;
  }
  return text;
}

/**
 * @param {string[]} part one declaration
 * @param {Language} language
 * @param {Set<string>} globals
 */
function withShortNames(part, language, globals) {
  const words = wordsOf(part);
  const tokens = words.map(({ token }) => token);
  if (!isFunction(tokens, language)) return part;
  const declared = declaredNames(tokens, language);
  for (const name of globals) declared.delete(name);
  const names = shortNames(new Set(tokens.filter((token) => isWord(token) && !declared.has(token))));
  /** @type {Map<string, string>} */
  const renamed = new Map();
  const result = [...part];
  words.forEach(({ token, i }, n) => {
    // Members, `@fragment` and `@builtin(position)` belong to others.
    if (!declared.has(token) || '.@'.includes(tokens[n - 1] ?? ' ') || tokens[n - 3] === '@') return;
    const name = renamed.get(token) ?? /** @type {string} */ (names.next().value);
    renamed.set(token, name);
    result[i] = name;
  });
  return result;
}

/** What a function declares for itself. @param {string[]} tokens @param {Language} language */
function declaredNames(tokens, language) {
  const at = (/** @type {number} */ n) => tokens[n];
  const open = tokens.indexOf('(', language === 'wgsl' ? tokens.indexOf('fn') : 0);
  /** @type {Set<string>} */
  const declared = new Set();
  for (let n = open + 1; n < tokens.length; n++)
    if (language === 'wgsl' ? declaresWgsl(at, n, open) : declaresGlsl(at, n)) declared.add(tokens[n] ?? '');
  // What is also called is a function that the name hides.
  tokens.forEach((token, n) => {
    if (at(n + 1) === '(') declared.delete(token);
  });
  return declared;
}

/** @param {(n: number) => string | undefined} at @param {number} n @param {number} open where the parameters begin */
function declaresWgsl(at, n, open) {
  if (!isWord(at(n))) return false;
  const before = at(n - 1);
  if (before === 'let' || before === 'var' || before === 'const') return true;
  // A parameter, with or without an attribute before it. There are no other colons behind names in a body but of declarations.
  return at(n + 1) === ':' && (n === open + 1 || before === ',' || before === ')') && at(n - 2) !== '@';
}

/** @param {(n: number) => string | undefined} at @param {number} n */
function declaresGlsl(at, n) {
  const [type, name, next] = [at(n - 1), at(n), at(n + 1)];
  if (!isWord(name) || !isWord(type) || NO_TYPES.has(type ?? '')) return false;
  return next === '=' || next === ';' || next === '[' || next === ',' || next === ')';
}

/** a … z, A … Z, then two letters. @param {Set<string>} taken */
function* shortNames(taken) {
  const letters = [...'abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ'];
  for (const first of ['', ...letters])
    for (const letter of letters) {
      const name = first + letter;
      if (!taken.has(name) && !KEYWORDS.has(name)) yield name;
    }
  throw new Error('A function declares more names than there are short ones.');
}
