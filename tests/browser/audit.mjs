// SPDX-License-Identifier: MIT
// Runs Lighthouse on the built site, served on the same machine: `./dev audit`. Prints a table of scores and the audits
// that cost points. Fails if accessibility, best practices or the installable app score less than docs/performance.md
// promises. Prints speed, too, but never fails because of it, since it depends on the machine.
import { execFile } from 'node:child_process';
import { mkdir, readFile } from 'node:fs/promises';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { ROOT } from './browsers.mjs';
import { PlainServer } from './plain_server.mjs';

const LIGHTHOUSE = join(ROOT, '.toolchain/audit/node_modules/.bin/lighthouse');
const PAGES = ['', 'book/index.html', 'book/gallery.html', 'book/lessons/1-a-rule.html', 'book/physics.html'];
const MIN_SCORES = /** @type {Record<string, number>} */ ({ accessibility: 95, 'best-practices': 95, pwa: 100, seo: 90 });
const FLAGS = '--headless=new --no-sandbox --disable-quic --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader';

const site = join(ROOT, 'build/site');
const out = join(ROOT, 'build/audit');
await mkdir(out, { recursive: true });
const server = new PlainServer(site, '/gaitsmith/');
await server.start();
let failed = false;
for (const page of PAGES.filter((path) => existsSync(join(site, path || 'index.html')))) {
  const file = join(out, `${page.replaceAll('/', '-') || 'playground'}.json`);
  // Only the playground is an installable app, not the book.
  const wanted = ['performance', 'accessibility', 'best-practices', 'seo', ...(page ? [] : ['pwa'])];
  await promisify(execFile)(LIGHTHOUSE, [server.address() + page, '--quiet', '--output=json', `--output-path=${file}`,
    `--only-categories=${wanted.join()}`, '--preset=desktop', `--chrome-flags=${FLAGS}`],
  { env: { ...process.env, CHROME_PATH: process.env.CHROMIUM ?? '/usr/bin/chromium' }, timeout: 180000 });
  const { categories, audits } = JSON.parse(await readFile(file, 'utf8'));
  const scores = Object.entries(categories).map(([name, { score }]) => `${name} ${Math.round(100 * score)}`);
  console.log(`${page || 'playground'}: ${scores.join(', ')}`);
  for (const [name, category] of Object.entries(categories)) {
    const low = Math.round(100 * category.score) < (MIN_SCORES[name] ?? 0);
    failed ||= low;
    for (const { id, weight } of category.auditRefs) {
      const { score, title, displayValue = '' } = audits[id];
      if (weight > 0 && score !== null && score < 0.9) console.log(`        ${name}: ${title} ${displayValue}`);
    }
  }
}
server.close();
process.exitCode = failed ? 1 : 0;
