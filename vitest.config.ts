import { defineConfig } from 'vitest/config';

// Unit tests stand beside what they test; those across folders are in tests/. Files named *.spec.ts are Playwright's.
export default defineConfig({
  test: {
    include: ['packages/**/*.test.ts', 'apps/**/*.test.{ts,tsx}', 'tests/**/*.test.ts', 'scripts/**/*.test.ts'],
    // Vitest would leave a core to itself: half of all there is on a machine with two.
    maxWorkers: '100%',
    // No test mocks a module or leaves a global changed, so files can share a process and what it has imported.
    isolate: false,
    // Against hanging, not a measure of speed: a busy machine may take its time.
    testTimeout: 120_000,
    exclude: ['**/node_modules/**', '**/dist/**', '**/*.spec.ts'],
  },
});
