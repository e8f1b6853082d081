/** What is done with a scene on show: much code, the reader of scenes among it, which a page needs for no picture. */
export { depthAt, frameScene, withCamera, withGround, withParts } from 'mirrorball';
