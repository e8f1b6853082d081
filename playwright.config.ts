import { defineConfig } from '@playwright/test';
import { chromiumFlags, findChromium } from './scripts/chromium.mjs';

const executablePath = await findChromium();

export default defineConfig({
  testDir: 'tests/browser',
  testMatch: '**/*.spec.ts',
  outputDir: 'test-results',
  preserveOutput: 'failures-only',
  globalSetup: './tests/browser/global-setup.ts',
  // One at a time: SwiftShader uses every core already, and two pages at once would only time out.
  workers: 1,
  timeout: 90_000,
  // A busy machine may drop a frame or a click; what fails twice is broken. Such a test is reported as flaky, not hidden.
  retries: process.env.CI ? 1 : 0,
  expect: { timeout: 20_000 },
  forbidOnly: Boolean(process.env.CI),
  reporter: 'list',
  use: {
    browserName: 'chromium',
    locale: 'en-US',
    viewport: { width: 960, height: 640 },
    actionTimeout: 15_000,
    screenshot: 'only-on-failure',
    launchOptions: { args: chromiumFlags, ...(executablePath ? { executablePath } : {}) },
  },
});
