/** JSON Pointer, RFC 6901: "/shapes/red ball/center" is ['shapes', 'red ball', 'center']; ~1 stands for / and ~0 for ~. */

/** The segments of a pointer, or null when the text is not a pointer. The empty text points at the whole document. */
export function parsePointer(text: string): string[] | null {
  if (text === '') return [];
  if (!text.startsWith('/') || /~(?![01])/.test(text)) return null;
  return text
    .slice(1)
    .split('/')
    .map((segment) => segment.replaceAll('~1', '/').replaceAll('~0', '~'));
}

/** The pointer made of these segments. */
export function formatPointer(segments: readonly (string | number)[]): string {
  return segments.map((segment) => `/${String(segment).replaceAll('~', '~0').replaceAll('/', '~1')}`).join('');
}
