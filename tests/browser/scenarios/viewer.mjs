// SPDX-License-Identifier: MIT
// What a link opens: the viewer for a person who receives it, the workbench for its owner. Each scenario opens its own
// pages.
import assert from 'node:assert/strict';
import { Fingers, Mouse } from '../pointers.mjs';
import { ONE_BROWSER, PageDriver, sleep } from '../page_driver.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */

const STRANGER = { newcomer: true, plays: true };

/** A link to the shuffle, as Share makes it. @param {Visit} visit */
async function sharedLink({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const link = await page.link();
  await page.close();
  return link;
}

/** @param {PageDriver} page */
async function shown(page) {
  const ids = (await page.widgets()).map(({ id }) => id);
  return {
    viewer: ids.includes('stage/make') && await page.call('mode', () => document.documentElement.dataset.viewer !== undefined),
    workbench: ids.some((id) => /^(panels|timeline|world|search)\//.test(id)),
  };
}
const VIEWER = { viewer: true, workbench: false }, WORKBENCH = { viewer: false, workbench: true };

/** @param {PageDriver} page */
const pushes = (page) => page.call('pushes', () => (window.gaitsmith.document().pushes ?? []).length);
/** @param {PageDriver} page */
const place = (page) => page.call('address', () => location.href);
/** @param {PageDriver} page */
const words = (page) => page.call('words', () => document.querySelector('#mirror')?.textContent ?? '');

/** Drags the figure, which is somewhere above the ground. @param {PageDriver} page @param {Mouse | Fingers} pointer */
async function pull(page, pointer) {
  await page.play(false);
  await page.frames();
  const { rect: { x, y, width, height } } = (await page.widgets()).find(({ id }) => id === 'stage') ?? { rect: { x: 0, y: 0, width: 0, height: 0 } };
  const ground = y + height - Math.max(104, Math.min(130, 0.178 * height));
  for (let at = 0.1; at < 0.95; at += 0.05) {
    await pointer.drag({ x: x + at * width, y: ground - 40 }, { x: x + at * width + 50, y: ground - 130 });
    if (await pushes(page) > 0) return;
    if ((await page.widgets()).some(({ id }) => id === 'stage/follow')) await pointer.tap(await pointer.centre('stage/follow'));
  }
  assert.fail('the figure could not be dragged');
}

/** @param {Visit} visit */
async function stranger(visit) {
  const link = await sharedLink(visit);
  const page = await PageDriver.open(visit.browser, link, STRANGER);
  assert.deepEqual(await shown(page), VIEWER);
  assert.ok((await page.widgets()).some(({ id, label }) => id === 'transport/play' && label === 'Pause'), 'it plays');
  const mirror = await words(page);
  for (const text of [await page.text('#title'), 'Nobody animated this. A computer found it.', 'Drag the figure to push it.', 'Make your own', 'How it works']) {
    assert.ok(text && mirror.includes(text), text);
  }
  assert.equal(await page.call('tour', () => document.querySelector('#tour:not([hidden])')), null);
  assert.equal(await page.call('undo', () => window.gaitsmith.canUndo()), false);

  // A push is not the person's work: neither the address nor the storage keeps it.
  const before = await page.hash();
  await pull(page, new Mouse(page));
  assert.notEqual(await page.hash(), before);
  await page.until('the hint has done its work', () => !document.querySelector('#mirror')?.textContent?.includes('Drag the figure'));
  await page.call('leave', () => dispatchEvent(new Event('pagehide')));
  assert.deepEqual(await page.call('works', () => Object.keys(localStorage).filter((key) => /work|own/.test(key))), []);
  assert.equal(await place(page), link);
  await page.press('Control+z');
  assert.equal(await page.hash(), before, 'Undo takes the push back');
  assert.deepEqual(await shown(page), VIEWER);
  await pull(page, new Mouse(page));
  const pushed = await page.hash();

  await page.click('stage/make');
  assert.deepEqual(await shown(page), WORKBENCH);
  assert.equal(await page.hash(), pushed, 'with this motion');
  assert.equal(await place(page), await page.link(), 'in place');
  assert.equal(await page.status(), 'This motion is yours to change now.');
  assert.ok((await page.widgets()).some(({ id }) => id === 'stage/another'));
  await page.reload();
  assert.deepEqual(await shown(page), WORKBENCH);
  assert.equal(await page.hash(), pushed);
  await page.press('Control+z');
  assert.equal(await page.hash(), before, 'Undo reaches back to what was received');
  assert.equal(await page.call('undo', () => window.gaitsmith.canUndo()), false);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function byKeys(visit) {
  const link = await sharedLink(visit);
  const page = await PageDriver.open(visit.browser, link, STRANGER);
  await page.press(' ');
  await page.until('paused', () => window.gaitsmith.widgets().some(({ id, label }) => id === 'transport/play' && label === 'Play'));
  const focused = (/** @type {string} */ id) => page.call('focus', `document.activeElement?.getAttribute('data-id') === '${id}'`);
  for (let stops = 0; stops < 30 && !await focused('stage/how'); stops++) await page.press('Tab');
  assert.ok(await focused('stage/how'));
  await page.press('Enter');
  await page.until('the rules', () => window.gaitsmith.widgets().some(({ id }) => id === 'controller/why'));
  assert.deepEqual(await shown(page), WORKBENCH);
  assert.equal(await page.call('undo', () => window.gaitsmith.canUndo()), false, 'opening a panel is no change');
  assert.ok(await page.call('place', () => document.querySelector('#mirror')?.contains(document.activeElement)), 'the focus stays on the canvas');

  // What a person opens or makes belongs to the workbench.
  const other = await PageDriver.open(visit.browser, link, STRANGER);
  await other.press('2');
  assert.deepEqual(await shown(other), WORKBENCH);
  const third = await PageDriver.open(visit.browser, link, STRANGER);
  await third.call('another link', () => { location.hash = window.gaitsmith.link().split('#')[1].slice(0, 30); });
  await third.until('the banner', () => !document.querySelector('#banner')?.hasAttribute('hidden'));
  assert.deepEqual(await shown(third), VIEWER, 'a damaged link changes nothing');
  await third.call('figure', () => window.gaitsmith.run('document/new'));
  await third.frames();
  assert.deepEqual(await shown(third), WORKBENCH);
  for (const { complaints } of [page, other, third]) assert.deepEqual(complaints, []);
  for (const one of [page, other, third]) await one.close();
}

/** The browser may restore the page as it was, or load it again. @param {PageDriver} page */
async function goBack(page) {
  await page.page.evaluate(() => { history.back(); });
  for (let i = 0; i < 200; i++, await sleep(50)) {
    const there = await page.page.evaluate(() => !location.search && document.querySelector('#mirror [id^=on-canvas]') !== null).catch(() => false);
    if (there) return page.page.evaluate(() => { delete document.documentElement.dataset.left; }); // of the driver
  }
  assert.fail('the page has not come back');
}

/** @param {Visit} visit */
async function own(visit) {
  const link = await sharedLink(visit);
  const page = await PageDriver.open(visit.browser, visit.address);
  await page.call('work', () => window.gaitsmith.open({ ...window.gaitsmith.document(), hash: undefined, title: 'Mine', environment: { friction: 0.3 } }));
  await page.until('its address', () => location.href === window.gaitsmith.link());
  const mine = await page.link();
  await page.reload();
  assert.deepEqual(await shown(page), WORKBENCH);
  await page.arrive(() => page.page.goto(`${visit.address}?elsewhere`));
  await goBack(page);
  assert.deepEqual(await shown(page), WORKBENCH, 'back');
  assert.equal(await page.link(), mine);
  const bookmark = await PageDriver.open(visit.browser, mine, { ...STRANGER, beside: page });
  assert.deepEqual(await shown(bookmark), WORKBENCH, 'a bookmark');
  await bookmark.page.close();
  // Also of a motion that is not changed, and has no stored work.
  const edited = await PageDriver.open(visit.browser, link, { beside: page });
  await edited.page.close();
  const unchanged = await PageDriver.open(visit.browser, link, { ...STRANGER, beside: page });
  assert.deepEqual(await shown(unchanged), WORKBENCH);
  await page.close();

  const received = await PageDriver.open(visit.browser, link, STRANGER);
  await received.reload();
  assert.deepEqual(await shown(received), VIEWER, 'a reload of the viewer');
  await received.reload();
  assert.deepEqual(await shown(received), VIEWER, 'and another one');
  await received.click('stage/make');
  assert.deepEqual(await shown(received), WORKBENCH);
  await received.reload();
  assert.deepEqual(await shown(received), WORKBENCH, 'what is one\'s own stays so');
  const complaints = [page, unchanged, received].flatMap((one) => one.complaints);
  assert.deepEqual(complaints.filter((text) => !text.includes('favicon.ico')), []); // Firefox asks for it after a step back
  await received.close();
}

/** @param {Visit} visit */
async function switches(visit) {
  const link = await sharedLink(visit);
  const [bare, payload] = link.split('#');
  /** @param {string} query @param {object} expected @param {RegExp} [banner] */
  const opens = async (query, expected, banner) => {
    const page = await PageDriver.open(visit.browser, `${bare}${query}#${payload}`, STRANGER);
    if (banner) {
      await page.until('the banner', () => !document.querySelector('#banner')?.hasAttribute('hidden'));
      assert.match(await page.text('#banner-text'), banner);
    }
    assert.deepEqual(await shown(page), expected, query);
    assert.deepEqual(page.complaints, []);
    return page;
  };
  const edit = await opens('?edit', WORKBENCH);
  assert.equal(await place(edit), link, 'an address copied from there is an ordinary link');
  await edit.arrive(() => edit.page.goto(`${bare}?view#${payload}`));
  assert.deepEqual(await shown(edit), VIEWER, 'also of a motion of one\'s own');
  await edit.reload();
  assert.deepEqual(await shown(edit), VIEWER);
  await edit.click('stage/make');
  assert.equal(await place(edit), link);
  await edit.reload();
  assert.deepEqual(await shown(edit), WORKBENCH);
  await edit.close();
  const mistake = /“view” and “edit” take no value, and exclude each other/;
  for (const [query, expected, banner] of /** @type {[string, object, RegExp?][]} */ ([
    ['?lang=en', VIEWER], ['?panels=style', WORKBENCH], ['?lock=figure', WORKBENCH], ['?view=yes', VIEWER, mistake], ['?edit&view', VIEWER, mistake],
  ])) await (await opens(query, expected, banner)).close();
}

/** @param {Visit} visit */
async function framed(visit) {
  const link = await sharedLink(visit);
  const page = await PageDriver.open(visit.browser, visit.address);
  const inFrame = (/** @type {string} */ query) => page.page.evaluate(async (src) => {
    const frame = document.createElement('iframe');
    frame.src = src;
    frame.width = '900';
    frame.height = '600';
    document.body.append(frame);
    await new Promise((resolve) => frame.addEventListener('load', resolve));
    const { gaitsmith } = /** @type {Window} */ (frame.contentWindow);
    await gaitsmith.ready;
    gaitsmith.open({ ...gaitsmith.document(), hash: undefined, title: 'Another' });
    await new Promise((resolve) => setTimeout(resolve, 500));
    const ids = gaitsmith.widgets().map(({ id }) => id);
    frame.remove();
    return { viewer: ids.includes('stage/make'), workbench: ids.some((id) => /^(panels|timeline|world)\//.test(id)) };
  }, link.replace('#', `${query}#`));
  assert.deepEqual(await inFrame(''), WORKBENCH);
  assert.deepEqual(await inFrame('?view'), VIEWER);
  await page.close();
}

/** @param {Visit} visit */
async function onPhone(visit) {
  const link = await sharedLink(visit);
  const page = await PageDriver.open(visit.browser, link.replace('#', '?view#'), STRANGER);
  await page.becomePhone();
  await page.frames(10);
  assert.deepEqual(await shown(page), VIEWER);
  for (const wanted of ['stage/make', 'stage/how', 'transport/play']) {
    const rect = (await page.widgets()).find(({ id }) => id === wanted)?.rect;
    assert.ok(rect && rect.height >= 44 && rect.x >= 0 && rect.x + rect.width <= 390 && rect.y + rect.height <= 844, wanted);
  }
  const finger = new Fingers(page);
  await pull(page, finger);
  await finger.tap(await finger.centre('stage/how'));
  await page.until('the rules', () => window.gaitsmith.widgets().some(({ id }) => id.startsWith('controller/')));
  assert.deepEqual(await shown(page), WORKBENCH);
  assert.deepEqual(page.complaints, []);

  // Low and narrow windows keep the way to the workbench.
  const low = await PageDriver.open(visit.browser, link.replace('#', '?view#'), STRANGER);
  for (const [width, height] of [[844, 390], [640, 360], [320, 256]]) {
    await low.page.setViewport({ width, height });
    await low.frames(10);
    const rect = (await low.widgets()).find(({ id }) => id === 'stage/make')?.rect;
    assert.ok(rect && rect.height >= 44 && rect.x + rect.width <= width, `${width} x ${height}`);
  }
  await low.click('stage/make');
  assert.deepEqual(await shown(low), WORKBENCH);
  for (const one of [page, low]) await one.close();
}

/** @type {import('./all.mjs').Scenario[]} */
export const VIEWER_SCENARIOS = [
  ['the viewer plays for a stranger, a drag pushes, Make your own opens the workbench for good', stranger],
  ['the viewer works by keys, and a panel, a figure or a search leaves it', byKeys],
  ['the viewer is not for what the browser knows: reload, back, bookmark', own],
  ['the viewer comes with ?view and the workbench with ?edit, and mistakes are reported', switches, ONE_BROWSER],
  ['the viewer stays out of frames unless they ask for it', framed],
  ['the viewer on a phone: buttons for fingers, a pull pushes, the rules open', onPhone],
];
