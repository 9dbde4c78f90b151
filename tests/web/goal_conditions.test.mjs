// SPDX-License-Identifier: MIT
// The conditions of goals: what can be written, and when a motion meets it.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { isMet, parseGoal } from '../../web/page/goal_conditions.js';

const TABLES = { terms: [{ name: 'rotations' }], control_modes: [{ name: 'physical' }, { name: 'timer' }] };
const term = (/** @type {string} */ name, /** @type {number | null} */ value) => ({ name, label: name, unit: '', decimals: 2, value });
const MOTION = {
  terms: [term('distance', 8), term('travel', -8), term('rotations', 0.5), term('seed', 4), term('pushes', 0), term('push_right', null), term('push_time', null), term('switch', null), term('generations', 2)],
  sense: 'physical', controller: 'new', world: 'usual', rules: 6, broke: false, preview: false,
};
/** @param {string} goal @param {Partial<import('../../web/app/app.js').Measures>} [other] */
const met = (goal, other = {}) => parseGoal(goal, TABLES).map((condition) => isMet(condition, { ...MOTION, ...other }));

test('goals: numbers are compared in each way', () => {
  assert.deepEqual(met('distance >= 8, distance > 8, distance <= 8, distance < 8, distance = 8, distance != 8'), [true, false, true, false, true, false]);
  assert.deepEqual(met('travel>=-8,rotations<=0.5,rules=6,seed!=3,generations>=3'), [true, true, true, true, false]);
});

test('goals: a number that a motion does not have meets nothing', () => {
  assert.deepEqual(met('push_right <= 0, push_time != 3, switch >= 0, push_right = 0'), [false, false, false, false]);
});

test('goals: words are met by the same word', () => {
  assert.deepEqual(met('sense = physical, sense = timer, controller = new, controller = opened, world = usual'), [true, false, true, false, true]);
  assert.deepEqual(met('controller = new, controller = opened, world = usual', { controller: 'changed', world: 'other' }), [false, false, false]);
  assert.deepEqual(['usual', 'earth', 'other'].map((world) => met('world = earth', { world })[0]), [true, true, false]);
  assert.deepEqual(met('world = usual', { world: 'earth' }), [false]);
});

test('goals: a motion that broke physics meets nothing', () => {
  assert.deepEqual(met('rules <= 6, controller = new', { broke: true }), [false, false]);
});

test('goals: what is no condition is named', () => {
  for (const wrong of ['controller != new', 'controller = old', 'world = moon', 'world >= usual', 'speed >= 1', 'seed != three', 'distance == 8', 'sense = smell', 'constructor = new']) {
    assert.throws(() => parseGoal(`rules <= 2, ${wrong}`, TABLES), (/** @type {Error} */ { message }) => message.includes(wrong), wrong);
  }
  assert.throws(() => parseGoal('', TABLES), /one to 6/);
  assert.throws(() => parseGoal(Array(7).fill('rules <= 2').join(), TABLES), /one to 6/);
});
