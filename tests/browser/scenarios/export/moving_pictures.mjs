// SPDX-License-Identifier: MIT
// Exported pictures that move, in the programs that play them: the browser itself, and Lottie's player.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { ONE_BROWSER } from '../../page_driver.mjs';
import { ROOT } from '../../browsers.mjs';

/** @typedef {import('../all.mjs').Visit} Visit */

const MOTION = join(ROOT, 'examples/star-man-shuffle.json');
const SHOWN = [0, 137, 402, 733, 1000]; // frames

/** A page without scripts, of the site, so that it may load the site's modules. @param {Visit} visit */
async function emptyPage({ browser, address }) {
  const page = await (await browser.createBrowserContext()).newPage();
  await page.setViewport({ width: 900, height: 500, deviceScaleFactor: 1 });
  await page.goto(`${address}imgui.LICENSE.txt`);
  await page.evaluate(() => { document.body.innerHTML = ''; });
  return page;
}

/** A file of the motion, made by the site's engine. @param {import('../../browsers.mjs').Page} page @param {Visit} visit @param {string} id */
const fileOf = async (page, { address }, id) => page.evaluate(async (site, name, text) => {
  const { Engine } = await import(`${site}search/engine.js`);
  const engine = await Engine.load();
  const motion = engine.motion(engine.documentFromText(text));
  try {
    return { file: motion.file(name), numbers: [...motion.numbers], stride: motion.stride, starts: [...motion.starts] };
  } finally {
    motion.close();
  }
}, address, id, await readFile(MOTION, 'utf8'));

/** The browser plays an SVG: every rod is where the motion has it, within a pixel. @param {Visit} visit */
async function playsSvg(visit) {
  const page = await emptyPage(visit);
  const { file, numbers, stride, starts } = await fileOf(page, visit, 'animated-svg');
  const shown = await page.evaluate(async (svg, frames) => {
    document.body.innerHTML = svg;
    const picture = /** @type {SVGSVGElement} */ (document.querySelector('svg'));
    const all = document.getAnimations();
    return { animations: all.length, frames: frames.map((frame) => {
      for (const animation of all) {
        animation.pause();
        animation.currentTime = 10 * frame;
      }
      const own = /** @type {DOMMatrix} */ (picture.getScreenCTM()).inverse();
      return [...picture.querySelectorAll('g[class^="moves b"]')].map((group) => {
        const place = own.multiply(/** @type {DOMMatrix} */ (/** @type {SVGGElement} */ (group).getScreenCTM()));
        return { rod: Number(String(group.getAttribute('class')).replace('moves b', '')), from: [place.e, place.f], along: [place.a, place.b] };
      });
    }) };
  }, file, SHOWN);
  assert.ok(shown.animations >= starts.length + 2); // rods, some in several groups, the figure, the ground
  const scale = Number(/<!-- 1 m = ([\d.]+) px -->/.exec(file)?.[1]);
  const metres = (/** @type {number} */ frame, /** @type {number} */ k) => [numbers[frame * stride + 3 + 2 * k], numbers[frame * stride + 4 + 2 * k]];
  const away = (/** @type {number[]} */ a, /** @type {number[]} */ b) => [b[0] - a[0], b[1] - a[1]];
  SHOWN.forEach((frame, i) => {
    const [root] = shown.frames[i].filter(({ rod }) => rod === 0);
    assert.ok(shown.frames[i].length >= starts.length);
    for (const { rod, from, along } of shown.frames[i]) {
      const [x, y] = away(metres(frame, starts[rod]), metres(frame, rod + 1));
      const length = Math.hypot(x, y);
      assert.ok(length * scale * Math.hypot(along[0] - x / length, along[1] + y / length) <= 1, `the direction of rod ${rod} at frame ${frame}`);
      const [seen, is] = [away(root.from, from), away(metres(frame, 0), metres(frame, starts[rod]))];
      assert.ok(Math.hypot(seen[0] - scale * is[0], seen[1] + scale * is[1]) <= 1, `the start of rod ${rod} at frame ${frame}`);
    }
  });
  // With reduced motion it shows the first frame, and nothing moves.
  if (visit.name === ONE_BROWSER) { // Firefox cannot be told to want it
    await page.emulateMediaFeatures([{ name: 'prefers-reduced-motion', value: 'reduce' }]);
    assert.deepEqual(await page.evaluate(() => [matchMedia('(prefers-reduced-motion: reduce)').matches, document.getAnimations().length]), [true, 0]);
  }
  await page.browserContext().close();
}

/** Lottie's player shows the same picture as the page's own film, but for its title, its trail and its labels. @param {Visit} visit */
async function playsLottie(visit) {
  const page = await emptyPage(visit);
  const { file } = await fileOf(page, visit, 'lottie');
  await page.evaluate(await readFile(join(ROOT, 'web/node_modules/lottie-web/build/player/lottie_canvas.js'), 'utf8'));
  const shares = await page.evaluate(async (site, text, motionText, frames) => {
    const [{ Engine }, { Film }] = await Promise.all([import(`${site}search/engine.js`), import(`${site}share/film.js`)]);
    const engine = await Engine.load();
    const film = new Film(engine.motion(engine.documentFromText(motionText)), '');
    const canvas = document.createElement('canvas');
    canvas.width = film.width;
    canvas.height = film.height;
    document.body.append(canvas, film.canvas);
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d', { willReadFrequently: true }));
    const animation = /** @type {any} */ (window).lottie.loadAnimation({
      renderer: 'canvas', loop: false, autoplay: false, animationData: JSON.parse(text), rendererSettings: { context, clearCanvas: true },
    });
    /** Which pixels are as dark as the figure. @param {Uint8ClampedArray} rgba */
    const dark = (rgba) => Array.from({ length: rgba.length / 4 }, (_, i) => rgba[4 * i] + rgba[4 * i + 1] + rgba[4 * i + 2] < 200);
    return frames.map((frame) => {
      animation.goToAndStop(frame, true);
      film.draw(frame);
      const [theirs, ours] = [dark(context.getImageData(0, 0, canvas.width, canvas.height).data), dark(film.pixels())];
      let both = 0;
      let either = 0;
      theirs.forEach((is, i) => {
        both += is && ours[i] ? 1 : 0;
        either += is || ours[i] ? 1 : 0;
      });
      return { either, share: both / either };
    });
  }, visit.address, file, await readFile(MOTION, 'utf8'), SHOWN);
  shares.forEach(({ either, share }, i) => {
    assert.ok(either > 500, `frame ${SHOWN[i]}: ${either} dark pixels`);
    assert.ok(share > 0.9, `frame ${SHOWN[i]}: the pictures share ${share} of their dark pixels`);
  });
  await page.screenshot({ path: join(ROOT, 'build/screenshots/lottie.png') });
  await page.browserContext().close();
}

/** @type {import('../all.mjs').Scenario[]} */
export const MOVING_PICTURE_SCENARIOS = [
  ['an exported SVG moves as the motion does, and stands still where a reader wants that', playsSvg],
  ['Lottie’s player shows an exported motion as the film has it', playsLottie, ONE_BROWSER],
];
