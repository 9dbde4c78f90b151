// SPDX-License-Identifier: MIT
// Exported pictures that move, in the programs that play them: the browser itself, and Lottie's player.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { ONE_BROWSER, PageDriver } from '../../page_driver.mjs';
import { ROOT } from '../../browsers.mjs';

/** @typedef {import('../all.mjs').Visit} Visit */

const { unzipSync } = createRequire(join(ROOT, 'web/package.json'))('fflate');
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

/** The browser decodes a PNG that moves, and shows what the film has. @param {Visit} visit */
async function playsPng(visit) {
  const page = await emptyPage(visit);
  const { count, shares, width } = await page.evaluate(async (site, motionText) => {
    const [{ Engine }, { Film }] = await Promise.all([import(`${site}search/engine.js`), import(`${site}share/film.js`)]);
    const engine = await Engine.load();
    const motion = engine.motion(engine.documentFromText(motionText));
    const blob = new Blob([motion.bytes('apng')], { type: 'image/apng' });
    const image = new Image();
    image.src = URL.createObjectURL(blob);
    await image.decode();
    document.body.append(image);
    const decoder = new ImageDecoder({ data: await blob.arrayBuffer(), type: 'image/png' });
    await decoder.completed;
    const film = new Film(motion, '');
    const canvas = new OffscreenCanvas(film.width, film.height);
    const context = /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext('2d', { willReadFrequently: true }));
    /** Which pixels are as dark as the figure. @param {Uint8ClampedArray} rgba */
    const dark = (rgba) => Array.from({ length: rgba.length / 4 }, (_, i) => rgba[4 * i] + rgba[4 * i + 1] + rgba[4 * i + 2] < 200);
    const found = [];
    for (const frameIndex of [0, 34, 100, 183, 250]) {
      context.drawImage((await decoder.decode({ frameIndex })).image, 0, 0);
      film.draw(4 * frameIndex);
      const [theirs, ours] = [dark(context.getImageData(0, 0, canvas.width, canvas.height).data), dark(film.pixels())];
      const both = theirs.filter((is, i) => is && ours[i]).length, either = theirs.filter((is, i) => is || ours[i]).length;
      found.push({ either, share: both / either });
    }
    return { count: decoder.tracks.selectedTrack?.frameCount, shares: found, width: image.naturalWidth };
  }, visit.address, await readFile(MOTION, 'utf8'));
  assert.deepEqual([count, width], [251, 640]);
  for (const { either, share } of shares) assert.ok(either > 500 && share > 0.9, `the pictures share ${share} of ${either} dark pixels`);
  await page.screenshot({ path: join(ROOT, 'build/screenshots/apng.png') });
  await page.browserContext().close();
}

/** A sprite has the figure as the stage shows it to a guest. @param {Visit} visit */
async function spriteIsStage({ browser, address }) {
  const own = await PageDriver.open(browser, address);
  const link = await own.link();
  await own.close();
  const page = await PageDriver.open(browser, link, { newcomer: true });
  await page.page.setViewport({ width: 1920, height: 1080 });
  await page.call('start', () => window.gaitsmith.run('motion/start'));
  await page.frames(60); // until the view rests
  const stage = await page.placeOf('stage'), button = await page.placeOf('stage/make');
  const clip = { x: stage.x, y: stage.y + 120, width: stage.width, height: button.y - stage.y - 168 }; // between texts and buttons
  const shot = await page.page.screenshot({ encoding: 'base64', clip });
  await page.page.screenshot({ path: join(ROOT, 'build/screenshots/stage-for-sprite.png'), clip });
  const archive = await page.page.evaluate(async (site) => {
    const { Engine } = await import(`${site}search/engine.js`);
    const engine = await Engine.load();
    const motion = engine.motion(engine.documentFromText(JSON.stringify(window.gaitsmith.document())));
    const files = motion.sprites(256, 256);
    motion.close();
    return [...files];
  }, address);
  const files = unzipSync(Uint8Array.from(archive));
  const [{ frame: first }] = JSON.parse(new TextDecoder().decode(files['sprites.json'])).frames;
  const { share, pixels } = await page.page.evaluate(async (picture, sheetPng, frame) => {
    const bitmap = async (/** @type {string} */ base64) => createImageBitmap(new Blob([Uint8Array.from(atob(base64), (byte) => byte.charCodeAt(0))], { type: 'image/png' }));
    /** The figure's outline as a grid of 96 by 96 over its bounds. @param {ImageBitmap} image @param {(rgba: Uint8ClampedArray) => boolean} isFigure */
    const grid = (image, isFigure) => {
      const canvas = new OffscreenCanvas(image.width, image.height);
      const context = /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext('2d'));
      context.drawImage(image, 0, 0);
      const { data } = context.getImageData(0, 0, image.width, image.height);
      const at = (/** @type {number} */ x, /** @type {number} */ y) => isFigure(data.subarray(4 * (y * image.width + x), 4 * (y * image.width + x) + 4));
      let [x0, x1, y0, y1, count] = [image.width, 0, image.height, 0, 0];
      for (let y = 0; y < image.height; y++) {
        for (let x = 0; x < image.width; x++) {
          if (!at(x, y)) continue;
          count++;
          [x0, x1, y0, y1] = [Math.min(x0, x), Math.max(x1, x), Math.min(y0, y), Math.max(y1, y)];
        }
      }
      const cells = Array.from({ length: 96 * 96 }, (_, i) => at(Math.round(x0 + ((i % 96) + 0.5) * (x1 - x0) / 96), Math.round(y0 + (Math.floor(i / 96) + 0.5) * (y1 - y0) / 96)));
      return { cells, count };
    };
    const shown = grid(await bitmap(picture), ([r, g, b]) => r + g + b < 200 || b > r + 80); // with the dots on its joints
    const sheet = await createImageBitmap(await bitmap(sheetPng), frame.x, frame.y, frame.w, frame.h);
    const sprite = grid(sheet, (rgba) => rgba[3] > 127);
    const both = shown.cells.filter((is, i) => is && sprite.cells[i]).length, either = shown.cells.filter((is, i) => is || sprite.cells[i]).length;
    return { share: both / either, pixels: [shown.count, sprite.count] };
  }, shot, Buffer.from(files['sprites.png']).toString('base64'), first);
  assert.ok(Math.min(...pixels) > 1000, `${pixels} pixels`);
  assert.ok(share > 0.9, `they share ${share} of their outline`);
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** @type {import('../all.mjs').Scenario[]} */
export const MOVING_PICTURE_SCENARIOS = [
  ['an exported SVG moves as the motion does, and stands still where a reader wants that', playsSvg],
  ['Lottie’s player shows an exported motion as the film has it', playsLottie, ONE_BROWSER],
  ['the browser shows an exported PNG that moves as the film has it', playsPng, ONE_BROWSER],
  ['a sprite has the figure as the stage shows it', spriteIsStage, ONE_BROWSER],
];
