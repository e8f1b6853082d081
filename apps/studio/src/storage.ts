/** What the page remembers. A browser may refuse, for a file:// page above all; then it is simply not remembered. */
export function remember(key: string, value: string): void {
  try {
    localStorage.setItem(`mirrorball.${key}`, value);
  } catch {
    // Nothing depends on it.
  }
}

export function recall(key: string): string | null {
  try {
    return localStorage.getItem(`mirrorball.${key}`);
  } catch {
    return null;
  }
}
