// SPDX-License-Identifier: MIT
// Brings the live stages of a text to life: one engine for all, and only what is in sight works.
import createSmall from '../search/small_engine_module.js';
import { tr, trSentence } from '../languages/language.js';
import { Engine } from '../search/engine.js';
import { LiveStage } from './live_stage.js';
import { SCENES } from './scenes.js';

const FRAME_MS = 1000 / 40;
const figures = /** @type {HTMLElement[]} */ ([...document.querySelectorAll('figure.stage')]);
const calm = matchMedia('(prefers-reduced-motion: reduce)');
/** @type {Map<Element, LiveStage>} */
const stages = new Map();

/** @param {Engine} engine @param {HTMLElement} figure */
function begin(engine, figure) {
  const { kind = '', open = '', options = '{}' } = figure.dataset;
  const stage = new LiveStage(figure, engine, engine.json(engine.documentFromText(open)));
  stages.set(figure, stage);
  SCENES[kind](stage, JSON.parse(options));
  figure.classList.add('live');
}

try {
  const engine = await Engine.load(undefined, createSmall);
  // A stage begins when it is first seen, so that the first one moves at once and none searches in vain.
  const sight = new IntersectionObserver((changes) => {
    for (const { target, isIntersecting } of changes) {
      if (isIntersecting && !stages.has(target)) begin(engine, /** @type {HTMLElement} */ (target));
      const stage = stages.get(target);
      if (stage) stage.inSight = isIntersecting;
    }
  }, { rootMargin: '80px' });
  for (const figure of figures) sight.observe(figure);
  let painted = 0;
  const frame = (/** @type {number} */ ms) => {
    requestAnimationFrame(frame);
    if (ms - painted < FRAME_MS) return;
    painted = ms;
    for (const stage of stages.values()) if (stage.inSight) stage.frame(ms, calm.matches);
    if (stages.size > 0) performance.mark('gaitsmith-first-frame');
  };
  requestAnimationFrame(frame);
} catch (error) {
  for (const figure of figures) {
    const line = figure.querySelector('.said');
    if (line) line.textContent = tr('The stage cannot run here: {1}', trSentence(error instanceof Error ? error.message : String(error)));
  }
}
