import { defineConfig } from '@playwright/test';
import { chromiumFlags, findChromium } from './scripts/chromium.mjs';

const executablePath = await findChromium();

export default defineConfig({
  testDir: 'tests/browser',
  testMatch: '**/*.spec.ts',
  outputDir: 'test-results',
  preserveOutput: 'failures-only',
  globalSetup: './tests/browser/global-setup.ts',
  // Three files at a time on two cores: a page waits for a third of its time. What has a bar in seconds is marked @alone, and the test
  // command runs it by itself.
  workers: 3,
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
