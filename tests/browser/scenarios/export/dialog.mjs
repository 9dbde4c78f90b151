// SPDX-License-Identifier: MIT
// The export dialog: by mouse and by keyboard, every format, and cancelling a video. Each scenario opens its own pages.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { PageDriver } from '../../page_driver.mjs';
import { MOVING_PICTURE_SCENARIOS } from './moving_pictures.mjs';

/** @typedef {import('../all.mjs').Visit} Visit */

/** Runs in the page before its scripts: records the offered files, so that the browser does not save them. */
function recordFiles() {
  const offered = /** @type {{name: string, blob: Promise<Blob>}[]} */ ([]);
  Object.assign(window, { testOffered: offered });
  const click = HTMLAnchorElement.prototype.click;
  HTMLAnchorElement.prototype.click = function () {
    if (!this.download) return click.call(this);
    offered.push({ name: this.download, blob: blobs.get(this.href) ?? Promise.reject(new Error('no blob')) });
  };
  const blobs = new Map();
  const create = URL.createObjectURL.bind(URL);
  URL.createObjectURL = (blob) => {
    const url = create(blob);
    blobs.set(url, blob);
    return url;
  };
}

/** A short motion. @param {Visit} visit */
async function openShort({ browser, address }) {
  const page = await PageDriver.open(browser, address, { before: recordFiles });
  await page.call('shorten', () => window.gaitsmith.open({ ...window.gaitsmith.document(), hash: undefined, title: 'A short one', duration_steps: 60 }));
  return page;
}

/** @param {PageDriver} page */
const dialogIsOpen = (page) => page.call('dialog', () => document.querySelector('#export-dialog')?.hasAttribute('open') ?? false);

/** Opens the dialog with its command. @param {PageDriver} page */
async function open(page) {
  await page.call('open', () => window.gaitsmith.run('document/export'));
  await page.until('the dialog', () => document.querySelector('#export-dialog')?.hasAttribute('open') ?? false);
}

/** @param {PageDriver} page @param {number} count */
async function untilOffered(page, count) {
  await page.until(`file ${count}`, `window.testOffered.length === ${count} || document.querySelector('#export-error').textContent !== ''`);
  assert.equal(await page.text('#export-error'), '');
}

/** The last file: name, type, size, first bytes, and what the browser reads from it. @param {PageDriver} page */
const lastFile = (page) => page.call('file', async () => {
  const { name, blob: promised } = /** @type {any} */ (window).testOffered.at(-1);
  const blob = /** @type {Blob} */ (await promised);
  const bytes = new Uint8Array(await blob.arrayBuffer());
  const image = /^image/.test(blob.type) && blob.type !== 'image/svg+xml' ? await createImageBitmap(blob) : null;
  return {
    name, type: blob.type, size: bytes.length, width: image?.width ?? 0, height: image?.height ?? 0,
    begin: String.fromCharCode(...bytes.subarray(0, 6)),
    // In a WebM: the element 0x4489, a number of milliseconds in 4 or 8 bytes.
    seconds: bytes.reduce((found, byte, i) => {
      if (blob.type !== 'video/webm' || found || byte !== 0x44 || bytes[i + 1] !== 0x89) return found;
      const view = new DataView(bytes.buffer, i + 3);
      return (bytes[i + 2] === 0x84 ? view.getFloat32(0) : view.getFloat64(0)) / 1000;
    }, 0),
    text: /svg|csv|gltf/.test(blob.type) ? new TextDecoder().decode(bytes) : '',
    // In a GIF, each frame has one such block.
    frames: blob.type === 'image/gif' ? bytes.filter((byte, i) => byte === 0x21 && bytes[i + 1] === 0xf9 && bytes[i + 2] === 4).length : 0,
  };
});

/** @param {PageDriver} page @param {string} format */
async function exportByMouse(page, format) {
  await open(page);
  await page.clickElement(`#export-formats label:has([value=${format}])`);
  const count = await page.call('count', () => /** @type {any} */ (window).testOffered.length);
  await page.clickElement('#export-go');
  await untilOffered(page, count + 1);
  assert.equal(await dialogIsOpen(page), false, `${format}: the dialog stays`);
  return lastFile(page);
}

/** @param {Visit} visit */
async function everyFormat(visit) {
  const page = await openShort(visit);
  const svg = await exportByMouse(page, 'svg');
  assert.deepEqual([svg.name, svg.type], ['a-short-one.svg', 'image/svg+xml']);
  assert.equal(svg.text.match(/class="pose"/g)?.length, 8);
  const png = await exportByMouse(page, 'png');
  assert.deepEqual([png.name, png.type, png.width], ['a-short-one.png', 'image/png', 2400]);
  assert.ok(png.height > 300 && png.size > 10000);
  const gif = await exportByMouse(page, 'gif');
  assert.deepEqual([gif.name, gif.type, gif.begin, gif.width, gif.height, gif.frames], ['a-short-one.gif', 'image/gif', 'GIF89a', 640, 360, 16]);
  const gltf = await exportByMouse(page, 'gltf');
  assert.equal(gltf.name, 'a-short-one.gltf');
  assert.equal(JSON.parse(gltf.text).asset.version, '2.0');
  await open(page);
  await page.clickElement('#export-formats label:has([value=csv])');
  await page.until('its size', () => /^[\d.]+ kB$/.test(document.querySelector('#export-size')?.textContent ?? ''));
  const kilobytes = Number.parseFloat(await page.text('#export-size'));
  await page.clickElement('#export-formats label:has([value=gif])');
  assert.equal(await page.text('#export-size'), '', 'a film is made first');
  await page.press('Escape');
  const csv = await exportByMouse(page, 'csv');
  assert.ok(Math.abs(csv.size / 1000 - kilobytes) <= 0.5, `${csv.size} bytes were said to be ${kilobytes} kB`);
  assert.match(await page.text('#toast'), /^Exported: a-short-one\.csv, [\d.]+ kB$/);
  assert.equal(csv.text.split('\n').length, 63);
  assert.match(csv.text, /^t,x,y,vx,vy,phi,L,rule,theta_1/);
  const moving = await exportByMouse(page, 'animated-svg');
  assert.match(moving.text, /^<svg [\s\S]*@keyframes/);
  const scene = await exportByMouse(page, 'godot');
  assert.deepEqual([scene.name, scene.type], ['a-short-one.tscn', 'text/plain']);
  const webm = await exportByMouse(page, 'webm');
  assert.deepEqual([webm.name, webm.type, webm.begin.slice(0, 4)], ['a-short-one.webm', 'video/webm', '\x1a\x45\xdf\xa3']);
  assert.ok(webm.size > 1000 && webm.size <= gif.size, `the film has ${webm.size} bytes, the GIF ${gif.size}`);
  // Recorded in real time, so a busy machine takes longer.
  assert.ok(webm.seconds > 0.4 && webm.seconds < 3, `the film lasts ${webm.seconds} s`);
  visit.figures['bytes of film and GIF'] = `${webm.size}, ${gif.size}`;
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** Both motions of a solved plan: as played, and as planned. @param {Visit} visit */
async function ofPlan({ browser, address }) {
  const page = await PageDriver.open(browser, address, { before: recordFiles });
  await open(page);
  assert.equal(await page.call('without a plan', () => document.querySelector('#export-plan')?.hasAttribute('hidden')), true);
  await page.press('Escape');
  const jump = await readFile(new URL('../../../../examples/planned/lamp-jump.json', import.meta.url), 'utf8');
  await page.call('a planned jump', `window.gaitsmith.open(${JSON.stringify(jump)})`);
  const played = await exportByMouse(page, 'csv');
  await open(page);
  await page.clickElement('#export-planned');
  await page.press('Escape');
  const planned = await exportByMouse(page, 'csv');
  const rows = (/** @type {string} */ text) => text.split('\n');
  assert.equal(rows(planned.text)[0], rows(played.text)[0]);
  assert.equal(rows(planned.text).length, rows(played.text).length);
  assert.notEqual(planned.text, played.text);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** One cycle, which ends as it begins, along the ground and in place. @param {Visit} visit */
async function asLoop({ browser, address }) {
  const page = await PageDriver.open(browser, address, { before: recordFiles });
  await open(page);
  await page.until('a cycle', () => /^0\.67 s and 1\.31 m a cycle/.test(document.querySelector('#export-cycle')?.textContent ?? ''));
  await page.clickElement('#export-parts label:has([value=loop])');
  await page.press('Escape');
  const rows = async () => (await exportByMouse(page, 'csv')).text.trim().split('\n').slice(1).map((line) => line.split(',').map(Number));
  const moves = await rows();
  assert.equal(moves.length, 68);
  const [first, last] = [moves[0], moves[67]];
  assert.ok(Math.abs(first[1]) < 1e-9 && Math.abs(last[1] - 1.31) < 0.01, `from ${first[1]} to ${last[1]}`);
  assert.deepEqual(last.slice(8, 12), first.slice(8, 12), 'the joints end as they begin');
  await open(page);
  await page.until('the way it is made', () => document.querySelector('#export-ways')?.hasAttribute('hidden') === false);
  await page.clickElement('#export-ways label:has(#export-in-place)');
  await page.press('Escape');
  const stays = await rows();
  assert.ok(Math.abs(stays[67][1]) < 1e-9);
  const gif = await exportByMouse(page, 'gif');
  assert.equal(gif.name, 'mr-star-man-shuffles-loop.gif');
  assert.equal(gif.frames, 17);
  // What does not repeat says why.
  await page.call('a short one', () => window.gaitsmith.open({ ...window.gaitsmith.document(), hash: undefined, timeline: [], controllers: [] }));
  await open(page);
  await page.until('a reason', () => document.querySelector('#export-cycle')?.textContent === 'None: the document has no controller');
  assert.equal(await page.call('whole', () => /** @type {HTMLInputElement} */ (document.querySelector('[value=whole]')).checked), true);
  assert.equal(await page.call('no loop', () => /** @type {HTMLInputElement} */ (document.querySelector('[value=loop]')).disabled), true);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function byKeyboard(visit) {
  const page = await openShort(visit);
  await page.page.focus('canvas');
  await page.openPalette();
  await page.page.keyboard.type('export picture');
  await page.press('Enter');
  await page.until('the dialog', () => document.querySelector('#export-dialog')?.hasAttribute('open') ?? false);
  const focus = () => page.call('focus', () => {
    const node = /** @type {HTMLInputElement} */ (document.activeElement);
    return node.id || `${node.value} ${node.checked}`;
  });
  assert.equal(await focus(), 'gif true');
  await page.press('ArrowDown', 3);
  assert.equal(await focus(), 'svg true');
  await page.press('Tab');
  assert.equal(await focus(), 'export-poses');
  await page.press('ArrowDown', 3);
  await page.press('Enter');
  await untilOffered(page, 1);
  assert.equal((await lastFile(page)).text.match(/class="pose"/g)?.length, 5);
  // An invalid number of poses is refused, but only if the format uses it.
  await open(page);
  await page.call('poses', () => { /** @type {HTMLInputElement} */ (document.querySelector('#export-poses')).value = '99'; });
  await page.clickElement('#export-go');
  await page.frames(6);
  assert.equal(await dialogIsOpen(page), true);
  await page.clickElement('#export-formats label:has([value=csv])');
  await page.clickElement('#export-go');
  await untilOffered(page, 2);
  await open(page);
  assert.equal(await focus(), 'csv true');
  await page.press('Escape');
  assert.equal(await dialogIsOpen(page), false);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function cancelled(visit) {
  const page = await openShort(visit);
  await page.call('lengthen', () => window.gaitsmith.open({ ...window.gaitsmith.document(), duration_steps: 12000 }));
  const begin = async () => {
    await page.clickElement('#export-formats label:has([value=gif])');
    await page.clickElement('#export-go');
    await page.until('progress', () => Number(document.querySelector('progress#export-progress')?.getAttribute('value')) > 0);
  };
  const making = () => page.call('making', () => !document.querySelector('#export-progress')?.hasAttribute('hidden'));
  await open(page);
  await begin();
  assert.equal(await page.call('focus', () => document.activeElement?.id), 'export-cancel');
  await page.clickElement('#export-cancel');
  await page.until('an end', () => document.querySelector('#export-progress')?.hasAttribute('hidden') ?? false);
  assert.equal(await dialogIsOpen(page), true, 'one may choose another format');
  assert.equal(await page.text('#toast'), 'Export cancelled');
  await begin();
  await page.press('Escape');
  await page.until('an end', () => document.querySelector('#export-progress')?.hasAttribute('hidden') ?? false);
  assert.equal(await dialogIsOpen(page), false);
  await page.frames(10);
  assert.equal(await making(), false);
  assert.equal(await page.call('files', () => /** @type {any} */ (window).testOffered.length), 0);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function withoutRecorder({ browser, address }) {
  const page = await PageDriver.open(browser, address, { before: () => { Reflect.deleteProperty(window, 'MediaRecorder'); } });
  await open(page);
  assert.equal(await page.text('#export-webm'), 'This browser cannot record videos');
  assert.equal(await page.call('off', () => document.querySelector('[value=webm]')?.matches(':disabled')), true);
  await page.close();
}

/** What cannot show springs says so, and is offered again for a figure of rods. @param {Visit} visit */
async function ofSprings(visit) {
  const page = await openShort(visit);
  const offered = () => page.call('formats', () => [...document.querySelectorAll('#export-dialog input[name=export-format]')]
    .map((radio) => /** @type {HTMLInputElement} */ (radio)).map(({ value, disabled, checked, labels }) => ({ value, disabled, checked, words: labels?.[0]?.textContent ?? '' })));
  await open(page);
  const all = await offered();
  assert.ok(all.length > 10 && all.every(({ disabled }) => !disabled), JSON.stringify(all));
  await page.call('choose', () => /** @type {HTMLInputElement} */ (document.querySelector('#export-dialog input[value=gltf]')).click());
  await page.press('Escape');
  const shuffle = await page.call('document', () => window.gaitsmith.document());
  const table = await readFile(new URL('../../../../examples/gallery/table-trip.json', import.meta.url), 'utf8');
  await page.page.evaluate((text) => window.gaitsmith.open(text), table);
  await open(page);
  const left = await offered();
  assert.deepEqual(left.filter(({ disabled }) => disabled).map(({ value }) => value).sort(), ['animated-svg', 'dragonbones', 'gltf', 'godot', 'godot3', 'lottie', 'mjcf']);
  for (const { disabled, words } of left) assert.equal(/Needs a figure of rods/.test(words), disabled, words);
  assert.equal(left.find(({ checked }) => checked)?.value, 'gif', 'what was chosen cannot be made');
  await page.press('Escape');
  await page.page.evaluate((document) => window.gaitsmith.open(document), shuffle);
  await open(page);
  assert.deepEqual((await offered()).map(({ words }) => words), all.map(({ words }) => words));
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @type {import('../all.mjs').Scenario[]} */
export const EXPORT_SCENARIOS = [
  ['an export of every format, by mouse, is what it says', everyFormat],
  ['one cycle of a motion is exported as a loop', asLoop],
  ['a motion between keyframes is exported as played and as planned', ofPlan],
  ['an export of a figure of springs offers what can show it', ofSprings],
  ['an export by keyboard alone, with the poses asked for', byKeyboard],
  ['an export of a long film is cancelled, by button and by Escape', cancelled],
  ['an export where nothing records films says so', withoutRecorder],
  ...MOVING_PICTURE_SCENARIOS,
];
