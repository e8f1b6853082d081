/** What of a scene another format cannot say, or says otherwise: nothing is left out in silence. */

export interface ExportEntry {
  /** `lost`: it is not in the file. `changed`: it is there in another form. */
  readonly kind: 'lost' | 'changed';
  /** An English sentence. */
  readonly message: string;
  /** Names of things of the scene that it is about, such as `material "glass"`. */
  readonly things: readonly string[];
}

/** Collects entries; what is said of several things is one entry. */
export class ExportReport {
  readonly #entries = new Map<string, { kind: ExportEntry['kind']; message: string; things: string[] }>();

  add(kind: ExportEntry['kind'], message: string, thing: string): void {
    const key = `${kind} ${message}`;
    const entry = this.#entries.get(key) ?? { kind, message, things: [] };
    if (!entry.things.includes(thing)) entry.things.push(thing);
    this.#entries.set(key, entry);
  }

  list(): ExportEntry[] {
    return [...this.#entries.values()];
  }
}

/** A scene in another format: files by their names, and what they lack. */
export interface ExportedScene {
  readonly files: Readonly<Record<string, Uint8Array>>;
  readonly report: readonly ExportEntry[];
}
