/** The file that the program was started from: threads start from it too, as it is the only one that a build leaves. */
let entry: URL | null = null;

export function setEntry(url: string): void {
  entry = new URL(url);
}

export function workerEntry(): URL {
  if (!entry) throw new Error('The program has not said where it is.');
  return entry;
}
