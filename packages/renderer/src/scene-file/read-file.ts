/** Where the files of a scene come from: who reads it says how they are found, so that nothing is opened or fetched that nobody asked for. */

/**
 * Gives the content of a file that a scene names: a path from the scene file's folder on, with "/" between names. It may begin with
 * "../", and never with "/" or "https:". Rejects with an Error whose message says why in a few words, such as "there is no such file".
 */
export type ReadFile = (name: string) => Promise<Uint8Array>;

/** Reads the files that a scene from this address names, from the same server only. */
export function fetchBeside(sceneUrl: string | URL): ReadFile {
  return async (name) => {
    const base = new URL(sceneUrl);
    const url = new URL(name.split('/').map(encodeURIComponent).join('/'), base);
    if (url.origin !== base.origin) throw new Error('it lies on another server than the scene');
    const response = await fetch(url);
    if (!response.ok) throw new Error(`the server answers ${response.status} ${response.statusText}`.trim());
    return new Uint8Array(await response.arrayBuffer());
  };
}
