// SPDX-License-Identifier: MIT
// The built site with workers that fail on request. The page's scripts are unchanged.
import { rmSync } from 'node:fs';
import { cp, mkdtemp, readFile, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { execFile } from 'node:child_process';
import { promisify } from 'node:util';
import { ROOT } from './browsers.mjs';
import { PageDriver } from './page_driver.mjs';
import { PlainServer } from './plain_server.mjs';

/** @typedef {import('./worker_faults.mjs').Fault} Fault */

/** @type {Promise<PlainServer> | null} */
let server = null;

/** A server with such a site, shared by all tests. @param {string} [site] */
export function faultySite(site = process.argv[2] ?? join(ROOT, 'build/site')) {
  server ??= start(site);
  return server;
}

/** @param {string} site */
async function start(site) {
  const folder = await mkdtemp(join(tmpdir(), 'faulty-site-'));
  process.on('exit', () => rmSync(folder, { recursive: true }));
  await cp(site, folder, { recursive: true });
  await cp(join(ROOT, 'tests/browser/worker_faults.mjs'), join(folder, 'search/worker_faults.js'));
  const worker = join(folder, 'search/worker.js');
  await writeFile(worker, `import './worker_faults.js';\n${await readFile(worker, 'utf8')}`);
  await promisify(execFile)(process.execPath, [join(ROOT, 'web/build/seal.mjs'), folder]);
  const host = new PlainServer(folder, '/');
  await host.start();
  host.server.unref();
  return host;
}

/** Opens the site. @param {import('./browsers.mjs').Browser} browser @param {{before?: () => void}} [options] */
export async function openFaulty(browser, { before } = {}) {
  const address = (await faultySite()).address();
  const page = await PageDriver.open(browser, address, { before: before ?? countWorkers });
  return page;
}

/** Makes these faults happen in new workers of the page. @param {PageDriver} page @param {Fault[]} faults */
export const expectFaults = (page, faults) => page.page.evaluate((list) => {
  Object.assign(window, { testFaults: list });
  // End idle workers, which were created without faults.
  for (const worker of /** @type {any} */ (window).testWorkers) worker.onerror?.(new ErrorEvent('error', { message: 'sent home by a test' }));
}, faults);

/** The number of live workers. @param {PageDriver} page @returns {Promise<number>} */
export const liveWorkers = (page) => page.call('workers', () => /** @type {any} */ (window).testLive.size);

/** Runs in the page before its scripts: passes the expected faults to new workers and records live workers. */
export function countWorkers() {
  const live = new Set();
  const RealWorker = window.Worker;
  const channel = new BroadcastChannel('faults');
  Object.assign(window, { testLive: live, testFaults: [], testMet: 0,
    Worker: class extends RealWorker {
      /** @param {string | URL} url @param {WorkerOptions} [options] */
      constructor(url, options) {
        const { testFaults } = /** @type {any} */ (window);
        super(url, { ...options, name: testFaults.length > 0 ? JSON.stringify(testFaults) : '' });
        live.add(this);
      }

      terminate() {
        live.delete(this);
        super.terminate();
      }
    } });
  channel.onmessage = ({ data }) => {
    if (data.jumpMs) return;
    const state = /** @type {any} */ (window);
    state.testMet++;
    state.testFaults = state.testFaults.filter((/** @type {Fault} */ { id }) => id !== data.id);
  };
}
