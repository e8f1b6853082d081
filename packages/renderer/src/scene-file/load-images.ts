/** The images of a scene: from the bytes of files to pixels. */
import { defaultDecoder, type ImageDecoder } from '../gltf/images/decoder.ts';
import { type ImageHead, NO_IMAGE, readImageHead, strangeImage } from '../gltf/images/image-head.ts';
import { SCENE_LIMITS } from '../scene/limits.ts';
import { type ImageSource, lacksPixels } from '../scene/textures.ts';
import { pictureRule } from './picture-rule.ts';
import { type ProblemList, quote, sentence } from './problem.ts';
import type { ReadFile } from './read-file.ts';

interface Opened {
  readonly name: string;
  readonly bytes: Uint8Array;
  readonly head: ImageHead;
}

/** The images with their pixels; those that cannot be had stay as they are, with problems. Adds to `notes` what was changed. */
export async function loadImages(
  images: Readonly<Record<string, ImageSource>>,
  readFile: ReadFile,
  problems: ProblemList,
  notes: string[],
  decoder: ImageDecoder = defaultDecoder(),
): Promise<Record<string, ImageSource>> {
  const refuse = (name: string, reason: string) => {
    const file = images[name]!.file ?? '';
    const found = `the file ${quote(file)}, which cannot be used (${reason.replace(/\.$/, '')})`;
    const message = `The image ${quote(name)} cannot be read from ${quote(file)}: ${sentence(reason)}`;
    problems.add(['images', name, 'file'], found, pictureRule, message);
  };
  const loaded = { ...images };
  const opened: Opened[] = [];
  for (const [name, source] of Object.entries(images))
    if (lacksPixels(source))
      try {
        const bytes = await readFile(source.file!);
        opened.push({ name, bytes, head: headOf(bytes, decoder) });
      } catch (error) {
        refuse(name, error instanceof Error ? error.message : String(error));
      }
  // Before anything is decoded: files of a few bytes may stand for pixels without end.
  const total = opened.reduce((sum, { head }) => sum + head.width * head.height * 4, 0);
  if (total > SCENE_LIMITS.imageBytes) {
    problems.add(
      ['images'],
      `images of ${total} bytes once they are decoded`,
      `at most ${SCENE_LIMITS.imageBytes} bytes`,
    );
    return loaded;
  }
  for (const { name, bytes, head } of opened)
    try {
      loaded[name] = { ...images[name]!, data: await decoder.decode(bytes, head.type) };
      if (head.depth > 8) notes.push(`The image ${quote(name)}: channels of ${head.depth} bits are rounded to 8.`);
    } catch (error) {
      refuse(name, error instanceof Error ? error.message : String(error));
    }
  return loaded;
}

/** What is known before decoding; throws an Error for what will not be decoded. */
export function headOf(bytes: Uint8Array, decoder: ImageDecoder): ImageHead {
  const head = readImageHead(bytes);
  if (head === null) throw new Error(whyNone(bytes));
  if (!decoder.canDecode(head.type)) throw new Error(`files of the kind ${head.type} cannot be decoded here`);
  const most = SCENE_LIMITS.imageSide;
  if (!(Math.min(head.width, head.height) >= 1 && Math.max(head.width, head.height) <= most))
    throw new Error(`it has ${head.width} × ${head.height} pixels, where 1 to ${most} a side are allowed`);
  return head;
}

function whyNone(bytes: Uint8Array): string {
  const strange = strangeImage(bytes);
  return strange === NO_IMAGE ? 'it is no image' : `it is ${strange}; PNG, JPEG, WebP, AVIF and KTX2 can be read`;
}
