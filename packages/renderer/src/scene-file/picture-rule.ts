/** What files of images are called. By itself, as it is needed where nothing else of the schema is. */
export const pictureRule =
  'the name of a file with an image, .png, .jpg, .jpeg or .webp, from the folder of the scene on, with "/" between folders';
