// SPDX-License-Identifier: MIT
// Texts from strangers never become markup or scripts, and malicious documents are refused like other invalid ones.
import assert from 'node:assert/strict';
import { PageDriver } from '../page_driver.mjs';

/** @typedef {import('./all.mjs').Visit} Visit */

const EVIL = '<img src=x onerror="window.testOwned=1">{1}</title>';

/** Signs that injected markup or scripts took effect. @param {PageDriver} page */
const owned = (page) => page.call('owned', () => [
  /** @type {any} */ (window).testOwned ?? 0, document.querySelectorAll('img, iframe, object, embed').length,
  Object.keys(Object.prototype).length, document.querySelectorAll('script').length,
]);

/** @param {Visit} visit */
async function hostileTexts({ browser, address }) {
  const page = await PageDriver.open(browser, `${address}?goal=${encodeURIComponent(`${EVIL} >= 1`)}&panels=${encodeURIComponent(EVIL)}`);
  await page.until('what the address asks for', () => document.querySelector('#banner-text')?.textContent?.includes('<img') ?? false);
  const before = await owned(page);
  assert.deepEqual(before.slice(0, 3), [0, 0, 0]);
  await page.clickElement('#banner-close');
  await page.page.evaluate((evil) => {
    const document = window.gaitsmith.document();
    const named = { ...document, hash: undefined, title: evil.slice(0, 70), figure: { ...document.figure, name: evil.slice(0, 60) } };
    window.gaitsmith.open(named);
    window.gaitsmith.keep();
    window.gaitsmith.enqueue({ evaluations: 10 });
  }, EVIL);
  assert.equal(await page.text('#title'), EVIL.slice(0, 70));
  await page.page.evaluate(() => void window.gaitsmith.run('document/share'));
  await page.until('the lines', () => /** @type {HTMLTextAreaElement | null} */ (document.querySelector('#share-snippet'))?.value.includes('&lt;img') ?? false);
  await page.press('Escape');
  for (const id of ['help/commands', 'document/export']) {
    await page.page.evaluate((command) => void window.gaitsmith.run(command), id);
    await page.until('a dialog', () => document.querySelector('dialog[open]') !== null);
    await page.press('Escape');
  }
  await page.page.evaluate(() => window.gaitsmith.run('panel/Search'));
  await page.frames();
  await page.reload(); // the stored work is offered by its title
  assert.deepEqual(await owned(page), before);
  await page.close();
}

/** @param {Visit} visit */
async function hostileDocuments({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const hash = await page.hash();
  const before = await owned(page);
  const faults = await page.call('open', () => {
    const texts = [
      '{"__proto__": {"polluted": 1}}', '{"constructor": {"prototype": {"polluted": 1}}}', '{"figure": {"__proto__": []}}',
      '['.repeat(200000), `${'{"figure":'.repeat(50000)}`, `{"title": "${'a'.repeat(1e6)}"}`,
      '{"figure": {"rods": [{"length_m": 1e999}]}}', '{"figure": {"rods": [{"length_m": -0.0}]}}', '{"duration_steps": 1e9}',
      `{"figure": {"rods": [${'{},'.repeat(1000)}{}]}}`, `{"timeline": [${'{},'.repeat(5000)}{}]}`, '{"rules": 2147483648}', '{"rules": NaN}',
      '{"search": {"evaluations": 1e300}}', '\u0000', '\ud800', '{"title": "\\ud800"}', '{"title": "a\\u0000b"}',
    ];
    return texts.map((text) => {
      try {
        window.gaitsmith.open(text);
        return `opened: ${text.slice(0, 60)}`;
      } catch (error) {
        return error instanceof Error && error.message.length > 5 && error.message.length < 400 ? '' : `${text.slice(0, 60)}: ${error}`;
      }
    });
  });
  assert.deepEqual(faults.filter((fault) => fault !== ''), []);
  assert.equal(await page.hash(), hash);
  assert.deepEqual(await owned(page), before);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @param {Visit} visit */
async function onlyOwnScripts({ browser, address }) {
  const page = await PageDriver.open(browser, address);
  const tried = await page.call('scripts', async () => {
    const tries = /** @type {Record<string, () => unknown>} */ ({
      // With Trusted Types a plain text is not accepted as a script's address.
      worker: () => new Worker('search/worker.js'),
      markup: () => { document.createElement('p').innerHTML = '<b>x</b>'; },
      policy: () => /** @type {any} */ (window).trustedTypes.createPolicy('another', {}),
    });
    const trusted = 'trustedTypes' in window;
    const refused = Object.entries(tries).map(([name, attempt]) => {
      try {
        attempt();
        return '';
      } catch {
        return name;
      }
    });
    const inline = document.createElement('script');
    try {
      inline.src = 'data:text/javascript,window.testOwned=1';
      document.head.append(inline);
    } catch { /* as it should be */ }
    const strange = await fetch('https://example.com/').then(() => 'fetched', () => 'refused');
    await new Promise((resolve) => setTimeout(resolve, 200));
    return { trusted, refused, owned: /** @type {any} */ (window).testOwned ?? 0, strange };
  });
  if (tried.trusted) assert.deepEqual(tried.refused, ['worker', 'markup', 'policy']);
  assert.deepEqual([tried.owned, tried.strange], [0, 'refused']);
  assert.ok(page.complaints.some((complaint) => /Content.Security.Policy|CSP|Trusted/i.test(complaint)), 'the browser says why');
  await page.close();
}

/** @type {typeof import('./all.mjs').SCENARIOS} */
export const SECURITY_SCENARIOS = [
  ['texts of strangers never become markup', hostileTexts],
  ['documents that mean harm are refused, and change nothing', hostileDocuments],
  ['no script but its own, and no other host', onlyOwnScripts],
];
