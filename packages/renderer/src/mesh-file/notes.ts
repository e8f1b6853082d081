/** Sentences about what was left out or mended, of those things that all formats may have. */
export interface Tally {
  readonly degenerate: number;
  readonly mended: number;
  readonly tiny: number;
}

const many = (count: number, one: string): string => (count === 1 ? `1 ${one}` : `${count} ${one}s`);

export function notesOf({ degenerate, mended, tiny }: Tally): string[] {
  const notes: string[] = [];
  if (degenerate > 0) notes.push(`Left out: ${many(degenerate, 'triangle')} without area.`);
  if (tiny > 0) notes.push(`Left out: ${many(tiny, 'face')} of fewer than three corners.`);
  if (mended > 0) notes.push(`Made of the triangles around: ${many(mended, 'normal')} without direction.`);
  return notes;
}
