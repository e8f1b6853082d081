export { problemInChinese } from './problem-zh-CN.ts';
export { reportInChinese } from './report-zh-CN.ts';
export { savedInChinese } from './saved-zh-CN.ts';
