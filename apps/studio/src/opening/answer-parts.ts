/**
 * Gives a worker the parts of the page that it asks for. In the page of one file scripts/lazy-parts.mjs puts what does so in this one's
 * place; elsewhere a worker finds modules by itself.
 */
export function answerParts(_worker: Worker): void {}
