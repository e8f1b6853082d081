/** Names of files that a glTF file names: only such as lie in its folder or below. */

/** The name, with "/" between folders, or in words what is wrong with it. */
export function fileNameOf(uri: string): { readonly name: string } | { readonly fault: string } {
  let name = uri;
  try {
    name = decodeURIComponent(uri);
  } catch {
    // A file may have a % in its name that stands for itself.
  }
  if (/^[a-z][a-z0-9+.-]*:/i.test(name)) return { fault: 'an address' };
  // biome-ignore lint/suspicious/noControlCharactersInRegex: it is what is refused
  if (/[\u0000-\u001f\\]/.test(name)) return { fault: 'a name with a backslash or a control character' };
  if (name.startsWith('/')) return { fault: 'a path from the root' };
  const parts: string[] = [];
  for (const part of name.split('/')) {
    if (part === '' || part === '.') continue;
    if (part !== '..') parts.push(part);
    else if (parts.pop() === undefined) return { fault: 'a path that leads out of the folder' };
  }
  return parts.length === 0 ? { fault: 'no name' } : { name: parts.join('/') };
}
