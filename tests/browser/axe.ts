import { fileURLToPath } from 'node:url';
import type { Page } from '@playwright/test';

const axePath = fileURLToPath(import.meta.resolve('axe-core/axe.min.js'));

interface AxeViolation {
  readonly id: string;
  readonly impact: string | null;
  readonly nodes: readonly { readonly html: string }[];
}
/** What axe calls serious or critical, in words that say where. */
export async function seriousProblems(page: Page): Promise<string[]> {
  await page.addScriptTag({ path: axePath });
  const violations = await page.evaluate(async () => {
    const { axe } = window as unknown as { axe: { run(): Promise<{ violations: AxeViolation[] }> } };
    return (await axe.run()).violations.map(({ id, impact, nodes }) => ({ id, impact, html: nodes[0]?.html ?? '' }));
  });
  const serious = violations.filter(({ impact }) => impact === 'serious' || impact === 'critical');
  return serious.map(({ id, html }) => `${id}: ${html.slice(0, 200)}`);
}
