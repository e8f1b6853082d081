export { filmToSrgb } from '../display/srgb.ts';
export {
  type Block,
  type Comparison,
  type ComparisonOptions,
  comparePictures,
  type FourNumbers,
  type MeasuredPicture,
} from './compare.ts';
export { type ExrOptions, readExr, writeExr } from './exr.ts';
export * from './float-picture.ts';
export { formatOf, PICTURE_FORMATS, type PictureFormat, type WriteOptions } from './formats.ts';
export { readHdr, writeHdr } from './hdr.ts';
export { ImageError } from './image-error.ts';
export { arrayAsPicture, type NpyArray, readNpy, readNpyArray, writeNpy } from './npy.ts';
export { type Npz, readNpz } from './npz.ts';
export { readPfm, writePfm } from './pfm.ts';
export { type PngOptions, readPng, writePng } from './png.ts';
