import about from '../package.json' with { type: 'json' };

export const { version } = about;
/** As picture files name what made them. */
export const software = `Mirrorball ${version}`;
