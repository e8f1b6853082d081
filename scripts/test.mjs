#!/usr/bin/env node
// npm test: installs what is missing, then checks everything. `npm test -- unit build` runs only these steps.
import { installPackages } from './install-packages.mjs';
import { requireNode } from './node-version.mjs';
import { steps } from './test-steps.mjs';

/** @typedef {import('./test-steps.mjs').Step} Step */
/** @typedef {import('./test-steps.mjs').Outcome & { name: string, seconds: number, note: string }} Result */

/** @returns {readonly Step[]} */
function chosenSteps() {
  const names = process.argv.slice(2);
  const unknown = names.filter((name) => !steps.some((step) => step.name === name));
  if (unknown.length > 0) {
    const list = steps.map((step) => `  ${step.name.padEnd(10)}${step.about}`).join('\n');
    console.error(`There is no step called ${unknown.join(', ')}. The steps, all run when none is named:\n${list}`);
    process.exit(2);
  }
  return names.length === 0 ? steps : steps.filter((step) => names.includes(step.name));
}

/**
 * @param {Step} step
 * @param {readonly Result[]} before
 * @returns {Promise<Result>}
 */
async function runStep(step, before) {
  console.log(`\n━━━ ${step.name}: ${step.about}\n`);
  const start = performance.now();
  const missing = before.find((result) => result.name === step.needs && !result.ok);
  let note = missing ? `not run, as ${missing.name} failed` : '';
  /** @type {import('./test-steps.mjs').Outcome} */
  let outcome = { ok: false, cases: null };
  if (!missing) {
    try {
      outcome = await step.run();
    } catch (error) {
      note = error instanceof Error ? error.message : String(error);
    }
  }
  const seconds = (performance.now() - start) / 1000;
  console.log(`\n${step.name} ${outcome.ok ? 'passed' : 'FAILED'} after ${seconds.toFixed(1)} s${note && `: ${note}`}`);
  return { ...outcome, name: step.name, seconds, note };
}

/** @param {readonly Result[]} results */
function printSummary(results) {
  const total = { passed: 0, failed: 0, skipped: 0 };
  console.log('\n━━━ summary\n');
  for (const { name, ok, seconds, cases, note } of results) {
    // A step that failed without a failed case (types, lint, a crash) counts as one failure.
    const failed = Math.max(cases?.failed ?? 0, ok ? 0 : 1);
    total.passed += cases?.passed ?? 0;
    total.failed += failed;
    total.skipped += cases?.skipped ?? 0;
    const counts = cases ? `${cases.passed} passed, ${failed} failed, ${cases.skipped} skipped` : note;
    console.log(`  ${ok ? '✓' : '✗'} ${name.padEnd(10)}${seconds.toFixed(1).padStart(7)} s   ${counts}`);
  }
  const skipped = total.skipped > 0 ? `, ${total.skipped} skipped` : '';
  console.log(`\n${total.passed} passed, ${total.failed} failed${skipped}`);
}

requireNode();
const chosen = chosenSteps();
await installPackages();
/** @type {Result[]} */
const results = [];
for (const step of chosen) results.push(await runStep(step, results));
printSummary(results);
process.exitCode = results.every((result) => result.ok) ? 0 : 1;
