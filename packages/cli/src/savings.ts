/** Saves a film now and then while it is traced, so that even an end without warning (a power cut, `kill -9`) costs little. */
export interface Savings {
  /** Whether it is time to save again. */
  due(): boolean;
  save(): Promise<void>;
}

/** Saving may take this share of the time at most: films can be gigabytes. */
const MOST_SHARE = 0.05;

export const noSavings: Savings = { due: () => false, save: async () => {} };

/** `write` writes the film as it is; `seconds` lie between two times at least. It is up to `write` to cope with a full disk. */
export function startSavings(
  seconds: number,
  write: () => Promise<void>,
  now = () => performance.now() / 1000,
): Savings {
  let next = now() + seconds;
  return {
    due: () => now() >= next,
    async save() {
      const begun = now();
      await write();
      const took = now() - begun;
      next = begun + took + Math.max(seconds, took / MOST_SHARE);
    },
  };
}
