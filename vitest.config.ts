import { defineConfig } from 'vitest/config';

// Unit tests stand beside what they test; those across folders are in tests/. Files named *.spec.ts are Playwright's.
export default defineConfig({
  test: {
    include: ['packages/**/*.test.ts', 'apps/**/*.test.{ts,tsx}', 'tests/**/*.test.ts', 'scripts/**/*.test.ts'],
    // Against hanging, not a measure of speed: a busy machine may take its time.
    testTimeout: 120_000,
    exclude: ['**/node_modules/**', '**/dist/**', '**/*.spec.ts'],
  },
});
