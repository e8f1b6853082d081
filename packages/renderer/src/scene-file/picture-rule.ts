/** What files of images are called. By itself, as it is needed where nothing else of the schema is. */
export const pictureRule =
  'the name of a file with an image, .png, .jpg, .jpeg or .webp, relative to the scene\'s folder, with "/" between folders';
