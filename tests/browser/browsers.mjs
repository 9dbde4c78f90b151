// SPDX-License-Identifier: MIT
// Starts the page's server, Chromium (headless), Firefox and WebKit (in a virtual display, because they have no WebGL
// without one), each with a new profile.
import { spawn } from 'node:child_process';
import { existsSync } from 'node:fs';
import { createRequire } from 'node:module';
import { createServer } from 'node:net';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const ROOT = join(dirname(fileURLToPath(import.meta.url)), '../..');

/** @typedef {import('../../web/node_modules/puppeteer-core/lib/types.d.ts').Browser} Browser */
/** @typedef {import('../../web/node_modules/puppeteer-core/lib/types.d.ts').Page} Page */

/** @type {import('../../web/node_modules/puppeteer-core/lib/types.d.ts').PuppeteerNode} */
const puppeteer = createRequire(join(ROOT, 'web/package.json'))('puppeteer-core');

/** Child processes, ended by stopAll(). @type {import('node:child_process').ChildProcess[]} */
const children = [];

/**
 * Starts a program and waits for the first line it prints.
 * @param {string} program @param {string[]} options @param {import('node:child_process').StdioOptions} stdio
 * @param {number} channel  of stdio, where the line arrives
 * @returns {Promise<string>}
 */
function firstLine(program, options, stdio, channel) {
  return new Promise((resolve, reject) => {
    const child = spawn(program, options, { stdio });
    children.push(child);
    child.once('error', reject);
    child.once('exit', (code) => reject(new Error(`${program} ended with ${code}`)));
    let text = '';
    child.stdio[channel]?.on('data', (data) => {
      text += data;
      if (text.includes('\n')) resolve(text.trim());
    });
  });
}

/** Serves a folder. @param {string} folder @returns {Promise<string>} its address */
export function serve(folder) {
  return firstLine(process.execPath, [join(ROOT, 'web/build/serve.mjs'), folder, '0'], ['ignore', 'pipe', 'inherit'], 1);
}

export function stopAll() {
  for (const child of children) child.kill();
}

/** @param {string[]} paths */
const firstOf = (...paths) => paths.find((path) => path && existsSync(path));

/**
 * No background traffic, and WebGL in software, which Chromium does not offer without a flag. The page around the canvas
 * is then put together without OpenGL, as on a machine that has no graphics card: a frame costs a third less.
 */
const CHROMIUM_FLAGS = ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
  '--disable-component-update', '--disable-sync', '--use-gl=angle', '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader', '--disable-gpu-compositing'];

/** @typedef {{width: number, height: number, deviceScaleFactor?: number, isMobile?: boolean, hasTouch?: boolean}} Viewport */

/** @param {Viewport} [viewport] @returns {Promise<Browser | null>} null: not installed */
export async function startChromium(viewport = { width: 1280, height: 720 }) {
  // The headless shell is the same engine without a browser's windows, each of which costs as much as opening our page.
  const executablePath = process.env.CHROMIUM ?? firstOf('/usr/bin/chromium-headless-shell', '/usr/bin/chromium', '/usr/bin/google-chrome',
    '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome');
  if (!executablePath) return null;
  return puppeteer.launch({ executablePath, headless: executablePath.endsWith('shell') ? 'shell' : true, args: CHROMIUM_FLAGS, defaultViewport: viewport });
}

/** @type {string | undefined} */
let display;

/** The environment of a browser that needs a display. */
async function withDisplay() {
  if (existsSync('/usr/bin/Xvfb')) {
    display ??= `:${await firstLine('/usr/bin/Xvfb', ['-screen', '0', '1920x1200x24', '-nolisten', 'tcp', '-displayfd', '3'],
      ['ignore', 'ignore', 'ignore', 'pipe'], 3)}`;
  }
  return { ...process.env, ...(display ? { DISPLAY: display } : {}) };
}

/** @returns {Promise<Browser | null>} null: not installed */
export async function startFirefox() {
  const executablePath = process.env.FIREFOX ?? firstOf('/usr/bin/firefox-esr', '/usr/bin/firefox',
    '/Applications/Firefox.app/Contents/MacOS/firefox');
  if (!executablePath) return null;
  return puppeteer.launch({
    browser: 'firefox',
    executablePath,
    headless: false,
    defaultViewport: { width: 1280, height: 720 },
    env: await withDisplay(),
    // Half of the pixels a side, because software graphics need most of the time.
    extraPrefsFirefox: { 'webgl.force-enabled': true, 'layout.css.devPixelsPerPx': '0.5' },
  });
}

const webKitDriver = () => process.env.WEBKIT_DRIVER ?? firstOf('/usr/bin/WebKitWebDriver');
export const hasWebKit = () => webKitDriver() !== undefined;

/** Starts WebKitGTK's driver, for one browser. @returns {Promise<{address: string, stop: () => void} | null>} null: not installed */
export async function startWebKit() {
  const program = webKitDriver();
  if (!program) return null;
  const port = await freePort();
  const child = spawn(program, [`--port=${port}`], { stdio: 'ignore', env: await withDisplay() });
  children.push(child);
  return { address: `http://127.0.0.1:${port}`, stop: () => child.kill() };
}

/** @returns {Promise<number>} */
function freePort() {
  return new Promise((resolve) => {
    const server = createServer();
    server.listen(0, '127.0.0.1', () => {
      const address = server.address();
      server.close(() => resolve(typeof address === 'object' && address ? address.port : 0));
    });
  });
}
