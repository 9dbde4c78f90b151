// SPDX-License-Identifier: MIT
// The rules or curves of a controller, read and changed by hand, and the gallery of figures. Each scenario opens its own pages.
import assert from 'node:assert/strict';
import { Mouse } from '../pointers.mjs';
import { ONE_BROWSER, PageDriver } from '../page_driver.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */

/** @param {PageDriver} page @param {string} id */
async function widget(page, id) {
  return (await page.widgets()).find((candidate) => candidate.id === id);
}

/** @param {PageDriver} page */
async function undo(page) {
  await page.clickElement('#undo');
  await page.frames();
}

/** The parts of a document that the tests check. @typedef {{figure: {name: string, rods: unknown[]}, controllers?: {name: string, rules: unknown[]}[]}} Contents */

/** @param {PageDriver} page @returns {Promise<Contents>} */
const document = (page) => page.call('document', () => /** @type {any} */ (window.gaitsmith.document()));

/** The number of the active rule, which must use a sense, and the number of such a sense. @param {PageDriver} page */
async function activeRule(page) {
  for (let step = 0; step < 40; step++) {
    const card = (await page.widgets()).find(({ id, state, value }) => id.startsWith('controller/rule/') && state.selected && !value.includes('no sense'));
    if (card) return card;
    await page.click('transport/step');
  }
  return assert.fail('no active rule on the panel');
}

/** What a rule feels shows on the body, and goes with the pointer. @param {Visit} visit */
async function felt({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await page.click('panels/1');
  const card = await activeRule(page);
  const pointer = new Mouse(page);
  const stage = await widget(page, 'stage');
  assert.ok(stage);
  const away = { x: stage.rect.x + 30, y: stage.rect.y + stage.rect.height - 30 };
  await page.page.mouse.move(away.x, away.y);
  // The mark of the cycle comes when the motion has rested for a moment.
  await page.until('the cycle', `/a cycle/.test(document.querySelector('#mirror').textContent)`);
  await page.frames(10);
  const bare = await page.stage();
  const { x, y } = await pointer.centre(card.id);
  await page.page.mouse.move(x, y);
  await page.frames(10);
  assert.notEqual((await page.stage()).sum, bare.sum, 'the body shows what the rule feels');
  await page.page.mouse.move(away.x, away.y);
  let after = await page.stage();
  for (let look = 0; look < 40 && after.sum !== bare.sum; look++, after = await page.stage()) await page.frames(10);
  assert.equal(after.sum, bare.sum, 'and no longer');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function byMouse({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await page.click('panels/1');
  const before = await page.hash();
  const card = await activeRule(page);
  const number = card.id.split('/')[2];
  const why = await widget(page, 'controller/why');
  assert.match(why?.label ?? '', new RegExp(`Rule ${number} (stays|is) active`));
  assert.equal(card.state.expanded, false);
  await page.click(card.id);
  assert.equal((await widget(page, card.id))?.state.expanded, true);
  assert.equal(await page.hash(), before, 'opening a rule changes nothing');

  // A whole drag is one step of Undo.
  const pointer = new Mouse(page);
  const right = (/** @type {import('../pointers.mjs').Point} */ { x, y }, /** @type {number} */ by) => pointer.drag({ x, y }, { x: x + by, y });
  await pointer.scrollTo('rule-edit/tau', 24);
  const low = (await page.widgets()).find(({ id }) => /^rule-edit\/sense\/\d+\/low$/.test(id));
  assert.ok(low, 'an active rule has an interval');
  await right(await pointer.centre(low.id), 60);
  assert.notEqual((await widget(page, low.id))?.value, low.value);
  const changed = await page.hash();
  assert.notEqual(changed, before);
  const edited = await document(page);
  assert.match(edited.controllers?.[0].name ?? '', /, edited$/);
  await undo(page);
  assert.equal(await page.hash(), before);
  assert.doesNotMatch((await document(page)).controllers?.[0].name ?? '', /edited/);

  // A limb of the target pose.
  const pose = await widget(page, 'rule-edit/pose');
  assert.ok(pose, 'the pose is on the panel');
  const middle = { x: pose.rect.x + pose.rect.width / 2, y: pose.rect.y + pose.rect.height / 2 };
  const genes = async () => JSON.stringify((await document(page)).controllers?.[0]);
  const unchanged = await genes();
  // Try directions around the hub until a drag hits a limb.
  for (let angle = 0.1; angle < 6.3 && await genes() === unchanged; angle += 0.4) {
    await right({ x: middle.x + 32 * Math.cos(angle), y: middle.y + 32 * Math.sin(angle) }, 24);
  }
  assert.notEqual(await genes(), unchanged, 'no limb could be turned');
  await undo(page);
  assert.equal(await genes(), unchanged);
  assert.equal(await page.hash(), before);

  // A copy does not change the motion. Deleting the copied rule does.
  const count = async () => (await document(page)).controllers?.[0].rules.length;
  const rules = await count() ?? 0;
  await page.page.mouse.move(middle.x, middle.y);
  await page.page.mouse.wheel({ deltaY: -100 });
  await page.frames();
  await page.click('rule-edit/copy');
  assert.equal(await count(), rules + 1);
  assert.equal(await page.hash(), before);
  await page.click('rule-edit/delete');
  assert.equal(await count(), rules);
  assert.equal(await page.hash(), before);
  assert.equal(await widget(page, 'rule-edit/pose'), undefined, 'the editor of a deleted rule closes');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** Presses Tab until the widget has the focus. @param {PageDriver} page @param {(id: string) => boolean} wanted */
async function tabTo(page, wanted) {
  for (let presses = 0; presses < 90; presses++) {
    const focused = (await page.widgets()).find(({ state }) => state.focused);
    if (focused && wanted(focused.id)) return focused.id;
    await page.page.keyboard.press('Tab', { delay: 40 });
    await page.frames(2);
  }
  return assert.fail('Tab does not get there');
}

/** @param {Visit} visit */
async function byKeyboard({ browser, address }) {
  const page = await PageDriver.open(browser, address, { plays: true });
  const before = await page.hash();
  await page.page.focus('canvas');
  await page.frames(6);
  await tabTo(page, (id) => id === 'transport/play');
  await page.press('Enter');
  await page.frames(6);
  // The tabs are one stop, and arrows move between them.
  await tabTo(page, (id) => id === 'panels/3');
  await page.press('ArrowLeft', 2);
  await page.press('Enter');
  await page.frames(6);
  const card = await tabTo(page, (id) => id === 'controller/rule/1');
  assert.match((await widget(page, 'controller/why'))?.label ?? '', /Rule 1 /, 'what has the keyboard is explained');
  await page.page.keyboard.press('Enter', { delay: 40 });
  await page.frames(6);
  assert.equal((await widget(page, card))?.state.expanded, true);
  const end = await tabTo(page, (id) => /^rule-edit\/sense\/\d+\/high$/.test(id));
  const value = (await widget(page, end))?.value;
  await page.page.keyboard.down('Shift');
  await page.page.keyboard.press('ArrowLeft', { delay: 60 });
  await page.page.keyboard.up('Shift');
  await page.frames();
  assert.notEqual((await widget(page, end))?.value, value);
  assert.notEqual(await page.hash(), before);
  await page.page.focus('#undo');
  await page.page.keyboard.press('Enter', { delay: 40 });
  await page.frames();
  assert.equal(await page.hash(), before);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function gallery({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const before = await page.hash();
  await page.click('panels/0');
  const tiles = async () => (await page.widgets()).filter(({ id }) => /^figure\/gallery\/\d+$/.test(id));
  assert.equal((await tiles()).length, 3, 'closed, it shows the row of the present figure');
  assert.equal((await tiles()).find(({ state }) => state.checked)?.label, 'Mr. Star-Man');
  await page.click('figure/gallery');
  const all = await tiles();
  assert.ok(all.length >= 15, `${all.length} figures in the gallery`);
  assert.equal(new Set(all.map(({ label }) => label)).size, all.length);
  const spider = all.find(({ label }) => label === 'Spider');
  assert.ok(spider);
  await page.click(spider.id);
  const chosen = await document(page);
  assert.deepEqual([chosen.figure.name, chosen.figure.rods.length, chosen.controllers?.length ?? 0], ['Spider', 13, 0]);
  assert.match(await page.status(), /This spider can’t move yet\. Undo/);
  assert.equal((await tiles()).find(({ state }) => state.checked)?.label, 'Spider');
  await undo(page);
  assert.equal(await page.hash(), before);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** Angles over time: a motion of rules recorded as curves, which are dragged and set by keys, and searched for. @param {Visit} visit */
async function curves({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  await page.click('panels/1');
  const before = await page.hash();
  const pointer = new Mouse(page);
  await pointer.scrollTo('controller/record', 24);
  await page.click('controller/record');
  const recorded = await page.call('recorded', () => /** @type {any} */ (window.gaitsmith.document()).controllers[0]);
  assert.deepEqual([recorded.kind, recorded.senses.kind, recorded.knots.length], ['trajectory', 'timer', 32]);
  assert.match(await page.text('#status'), /^Recorded: the joints' angles differ by [\d.]+°, at most [\d.]+°\. It travels .* m, where it went .* m before\.$/);
  const hash = await page.hash();
  assert.notEqual(hash, before);
  assert.ok(await page.call('beside', () => window.gaitsmith.commands().some(({ title }) => title === 'Stop comparing side by side')), 'the rules move beside the curves');

  await pointer.scrollTo('curves/plot', 140);
  const { x, y } = await pointer.centre('curves/plot');
  const value = async () => (await widget(page, 'curves/plot'))?.value;
  const chosen = await value();
  await pointer.drag({ x, y }, { x, y: y - 40 });
  assert.notEqual(await value(), chosen);
  assert.notEqual(await page.hash(), hash, 'a point of a curve is dragged');
  await undo(page);
  assert.equal(await page.hash(), hash, 'one drag is one step of Undo');

  await page.page.focus('canvas');
  await tabTo(page, (id) => id === 'curves/knot');
  await page.press('ArrowRight', 2);
  await tabTo(page, (id) => id === 'curves/angle/1');
  await page.press('ArrowLeft', 5);
  assert.notEqual(await page.hash(), hash, 'an angle is set by keys');
  const other = await PageDriver.open(browser, await page.link());
  assert.equal(await other.hash(), await page.hash(), 'a link carries the curves');
  await other.close();

  const found = await page.call('a search', () => window.gaitsmith.synthesize({ evaluations: 300, seed: 1, sense: 'trajectory', algorithm: 'pose-cycle' })
    .then(() => /** @type {any} */ (window.gaitsmith.document()).controllers.at(-1).kind));
  assert.equal(found, 'trajectory');
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @type {import('./all.mjs').Scenario[]} */
export const RULE_SCENARIOS = [
  ['the body shows what a rule feels, while the pointer is on its card', felt],
  ['a rule is opened, its interval and its pose are dragged, copied and deleted; Undo brings the motion back', byMouse],
  ['a rule is changed by the keyboard alone, and the one in focus is explained', byKeyboard],
  ['a motion of rules is recorded as curves, which are dragged, set by keys, shared and searched for', curves],
  ['the gallery shows all figures, and one of them takes the stage', gallery, ONE_BROWSER],
];
