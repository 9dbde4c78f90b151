// SPDX-License-Identifier: MIT
// Uses a page like assistive tools: by roles and names, without pointer and keys.
import assert from 'node:assert/strict';
import { PATIENCE_MS, sleep } from './page_driver.mjs';

/** @typedef {import('./page_driver.mjs').PageDriver} PageDriver */

/**
 * Waits for the element with this role and name in Chromium's accessibility tree. In Firefox, which takes seconds to
 * build its tree for each query, looks at the page's attributes instead.
 * @param {PageDriver} page @param {string} role @param {string} name
 */
export async function byRole(page, role, name) {
  const tree = /chrome/i.test(await page.page.browser().version());
  for (const start = Date.now(); ; await sleep(100)) {
    const found = tree ? await page.page.$(`::-p-aria([name="${name}"][role="${role}"])`)
      : (await page.page.evaluateHandle(seek, role, name)).asElement();
    if (found) return found;
    assert.ok(Date.now() - start < PATIENCE_MS, `no ${role} "${name}"`);
  }
}

/** Runs in the page. @param {string} role @param {string} name */
function seek(role, name) {
  const implicit = /** @type {Record<string, string>} */ ({ BUTTON: 'button', INPUT: 'slider' });
  return [...document.querySelectorAll('button, input, [role]')].find((node) =>
    (node.getAttribute('role') ?? implicit[node.tagName]) === role
    && (node.getAttribute('aria-label') ?? node.textContent) === name) ?? null;
}

/** Presses an element like an assistive tool. @param {PageDriver} page @param {string} role @param {string} name */
export async function activate(page, role, name) {
  await (await byRole(page, role, name)).evaluate((node) => /** @type {HTMLElement} */ (node).click());
  await settle(page);
}

/** Sets a value like an assistive tool. @param {PageDriver} page @param {string} role @param {string} name @param {string} value */
export async function setValue(page, role, name, value) {
  await (await byRole(page, role, name)).evaluate((node, text) => {
    const input = /** @type {HTMLInputElement} */ (node);
    input.value = text;
    input.dispatchEvent(new Event('input', { bubbles: true }));
    input.dispatchEvent(new Event('change', { bubbles: true }));
  }, value);
  await settle(page);
}

/** Waits until the canvas has drawn the change and the mirror shows it. @param {PageDriver} page */
export async function settle(page) {
  await page.frames(5);
  // In the page, whose own timers come first: on a busy machine they are all late.
  await page.call('rest', () => new Promise((resolve) => { setTimeout(resolve, 300); }));
}

/**
 * Waits until a widget or an element of the page has the keyboard.
 * @param {PageDriver} page @param {string | RegExp} id @param {string} [message]
 */
export async function reached(page, id, message = '') {
  const there = (/** @type {string} */ one) => (typeof id === 'string' ? one === id : id.test(one));
  for (const start = Date.now(); ; await sleep(50)) {
    const one = await active(page);
    if (there(one)) return;
    assert.ok(Date.now() - start < PATIENCE_MS, `${one} has the keyboard, not ${id} ${message}`);
  }
}

/** @param {PageDriver} page */
export const active = (page) => page.call('active', () => {
  const node = /** @type {HTMLElement} */ (document.activeElement);
  return node.dataset.id ?? (node.id || node.tagName.toLowerCase());
});

/** @param {PageDriver} page */
export const scrubbed = async (page) => Number.parseFloat((await page.widgets()).find(({ id }) => id === 'transport/scrub')?.value ?? '');
