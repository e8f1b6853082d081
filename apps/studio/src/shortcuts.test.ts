import { expect, test } from 'vitest';
import { belongsToControl, heldMoveOf } from './shortcuts.ts';

const press = (key: string, code = '', shiftKey = false) => ({
  key,
  code,
  shiftKey,
  ctrlKey: false,
  metaKey: false,
  altKey: false,
});

test('arrows orbit, with Shift they pan', () => {
  expect(heldMoveOf(press('ArrowLeft'))).toBe('left');
  expect(heldMoveOf(press('ArrowLeft', '', true))).toBe('panLeft');
});

test('plus and minus and W A S D move the view', () => {
  expect(heldMoveOf(press('+', 'Equal', true))).toBe('closer');
  expect(heldMoveOf(press('-'))).toBe('farther');
  expect(heldMoveOf(press('a', 'KeyA'))).toBe('left');
  expect(heldMoveOf(press('q', 'KeyQ'))).toBeNull();
});

test('where text is typed every key belongs to the text', () => {
  for (const key of ['h', ' ', '1', 'ArrowUp', '[']) {
    expect(belongsToControl(press(key), { tagName: 'INPUT', type: 'number' })).toBe(true);
    expect(belongsToControl(press(key), { tagName: 'TEXTAREA' })).toBe(true);
    expect(belongsToControl(press(key), { tagName: 'SELECT' })).toBe(true);
  }
});

test('sliders, dividers and buttons keep only the keys they use', () => {
  expect(belongsToControl(press('ArrowUp'), { tagName: 'INPUT', type: 'range' })).toBe(true);
  expect(belongsToControl(press('h'), { tagName: 'INPUT', type: 'range' })).toBe(false);
  expect(belongsToControl(press('ArrowLeft'), { tagName: 'DIV', role: 'separator' })).toBe(true);
  expect(belongsToControl(press(' '), { tagName: 'BUTTON' })).toBe(true);
  expect(belongsToControl(press('ArrowLeft'), { tagName: 'BUTTON' })).toBe(false);
  expect(belongsToControl(press(' '), { tagName: 'CANVAS' })).toBe(false);
});
