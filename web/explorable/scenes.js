// SPDX-License-Identifier: MIT
// The live stages of the explorable, by the kind that its text names.
import { fixed, fixedText, grouped as counted, tr, trLater } from '../languages/language.js';
import { measured, random, searched, withGravity, withLength, withPush, withRules, withSlope, withTau } from './changes.js';

/** @typedef {import('./live_stage.js').LiveStage} LiveStage */
/** The options that the text gives. @typedef {Record<string, any>} Options */

/** @param {number} number */
const metres = (number) => `${fixed(number, 1)} m`;
/** @type {Record<number, string>} */
const PLANETS = { 1.6: trLater('{1} (Moon)'), 3.8: trLater('{1} (Mars)'), 9.8: trLater('{1} (Earth)'), 24.8: trLater('{1} (Jupiter)') };
/** @param {LiveStage} stage */
const wayOf = (stage) => tr('{1} in {2} s.', metres(stage.travel), fixedText(stage.seconds));

/** @type {Record<string, (stage: LiveStage, options: Options) => void>} */
export const SCENES = {
  /** A motion, and its moments. */
  play(stage) {
    stage.show(stage.json);
    stage.slider({ label: tr('Moment'), min: 0, max: stage.seconds, step: 0.05, value: 0, words: (value) => `${fixed(value, 2)} s` }, (value) => stage.seek(value));
    stage.say(wayOf(stage));
  },

  /** Rules that can be thrown away. */
  rules(stage) {
    const count = stage.json.controllers[0].rules.length;
    const kept = new Set(Array.from({ length: count }, (_, i) => i));
    stage.show(stage.json);
    const whole = stage.motion.measures().hash;
    const update = () => {
      if (kept.size === 0) return stage.say(tr('Without a rule there is no motion. Tick one.'));
      stage.show(withRules(stage.json, [...kept].sort()));
      const same = stage.motion.measures().hash === whole;
      const way = kept.size === 1 ? tr('1 rule: {1}.', metres(stage.travel)) : tr('{1} rules: {2}.', kept.size, metres(stage.travel));
      stage.say(same && kept.size < count ? `${way} ${tr('The same motion, bit for bit.')}` : way);
    };
    for (let i = 0; i < count; i++) {
      stage.toggle(tr('rule {1}', i + 1), true, (checked) => {
        if (checked) kept.add(i);
        else kept.delete(i);
        update();
      });
    }
    update();
  },

  /** One number of one rule. */
  tempo(stage, { keep, rule }) {
    const json = withRules(stage.json, keep);
    const update = (/** @type {number} */ percent) => {
      stage.show(withTau(json, rule, 655.35 * percent));
      stage.say(wayOf(stage));
    };
    stage.slider({ label: tr('The kick'), min: 0, max: 100, value: 0, words: (value) => (value === 0 ? tr('as quick as it gets') : tr('{1} % slower', value)) }, update);
    update(0);
  },

  gravity(stage) {
    const update = (/** @type {number} */ gravity) => {
      stage.show(withGravity(stage.json, gravity));
      stage.say(wayOf(stage));
    };
    stage.slider({ label: tr('Gravity'), min: 1.6, max: 24.8, step: 0.2, value: 9.8, words: (value) => tr(PLANETS[value] ?? '{1}', `${fixed(value, 1)} m/s²`) }, update);
    update(9.8);
  },

  /** Rules made of random numbers. */
  random(stage) {
    const update = (/** @type {number} */ seed) => {
      stage.show(random(stage.engine, stage.json, seed));
      stage.say(tr('Random numbers {1}: {2}.', seed, metres(stage.travel)));
    };
    stage.slider({ label: tr('Other numbers'), min: 1, max: 100, value: 1, words: String }, update);
    update(1);
  },

  /** A climb whose moments can be looked at again. */
  climb(stage, { seed, evaluations }) {
    /** @type {import('./changes.js').Climb | null} */
    let climbed = null;
    const moment = stage.slider({ label: tr('After'), min: 0, max: evaluations, step: 50, value: 0, words: (value) => tr('{1} tries', counted(value)) }, (tries) => {
      const found = climbed?.best(tries);
      if (!found) return;
      stage.show(found);
      stage.say(tr('The best after {1} tries: {2}.', counted(tries), metres(stage.travel)));
    });
    stage.show(random(stage.engine, stage.json, seed));
    stage.search(searched(stage.json, { algorithm: 'shc', seed, evaluations }), (climb) => {
      climbed = climb;
      if (document.activeElement === moment.input && !climb.done) return; // someone is looking back
      moment.set(climb.tries);
      const far = tr('{1} tries: {2}.', counted(climb.tries), metres(stage.travel));
      stage.say(climb.done ? `${far} ${tr('Drag the slider back to see how it came about.')}` : far);
    });
  },

  /** The same climb from different starts. */
  seeds(stage, { evaluations }) {
    /** @type {((label: string, value: number, unit: string) => void) | null} */
    let bars = null;
    const run = (/** @type {number} */ seed) => stage.search(searched(stage.json, { algorithm: 'shc', seed, evaluations }), (climb) => {
      stage.say(tr('Seed {1}, {2} tries: {3}.', seed, counted(climb.tries), metres(stage.travel)));
      bars?.(tr('seed {1}', seed), stage.travel, 'm');
    });
    stage.slider({ label: tr('Seed'), min: 1, max: 8, value: 6, words: String }, run);
    bars = stage.bars();
    stage.show(random(stage.engine, stage.json, 6));
    run(6);
  },

  /** One climber against a population. */
  crowd(stage, { evaluations }) {
    /** @type {((label: string, value: number, unit: string) => void) | null} */
    let bars = null;
    const race = (/** @type {number} */ seed) => {
      const run = (/** @type {string} */ algorithm, /** @type {string} */ who, /** @type {() => void} */ then) => stage.search(searched(stage.json, { algorithm, seed, evaluations }), (climb) => {
        stage.say(tr('Seed {1}, {2}: {3} m high after {4} tries.', seed, who, fixed(climb.search.bestFitness, 1), counted(climb.tries)));
        bars?.(tr('{1}, seed {2}', who, seed), climb.search.bestFitness, 'm');
        if (climb.done) then();
      });
      run('shc', tr('one climber'), () => setTimeout(() => run('sphc', tr('population'), () => {})));
    };
    stage.slider({ label: tr('Seed'), min: 1, max: 5, value: 4, words: String }, race);
    bars = stage.bars();
    stage.show(stage.json);
    race(4);
  },

  /** What is paid for besides the distance. */
  pay(stage, { term, max, step, slider, evaluations, says }) {
    const run = (/** @type {number} */ weight) => stage.search(searched(stage.json, { algorithm: 'pose-cycle', seed: 1, evaluations, weights: { [term]: weight } }), (climb) => {
      stage.say(`${metres(measured(stage.motion, 'distance'))}, ${fixed(measured(stage.motion, term), 1)} ${says}${climb.done ? '.' : ' …'}`);
    });
    stage.show(stage.json);
    stage.slider({ label: slider, min: 0, max, step, value: 0, words: (value) => (value === 0 ? tr('nothing') : tr('{1} m each', value)) }, run);
    run(0);
  },

  /** A push at a moment that one chooses. */
  push(stage, { impulse }) {
    const update = (/** @type {number} */ seconds) => {
      stage.show(withPush(stage.json, seconds, impulse));
      stage.say(tr('Pushed at {1} s: {2}.', fixed(seconds, 1), metres(stage.travel)));
    };
    stage.slider({ label: tr('Push at'), min: 2, max: 6, step: 0.1, value: 3, words: (value) => `${fixed(value, 1)} s` }, update);
    stage.seek(2);
    update(3);
  },

  slope(stage) {
    const json = withPush(stage.json, 0, 0);
    const update = (/** @type {number} */ degrees) => {
      stage.show(withSlope(json, degrees));
      const way = metres(stage.travel);
      stage.say(degrees === 0 ? tr('Level ground: {1}.', way) : degrees > 0 ? tr('{1}° uphill: {2}.', degrees, way) : tr('{1}° downhill: {2}.', -degrees, way));
    };
    stage.slider({ label: tr('Slope'), min: -10, max: 10, value: 0, unit: '°' }, update);
    update(0);
  },

  /** A figure of one's own: lengths of limbs, and a search for them. */
  own(stage, { rods, names, min, max, evaluations, duration_steps: steps }) {
    let json = stage.json;
    const run = () => stage.search(searched(json, { algorithm: 'pose-cycle', seed: 1, evaluations, task: { kind: 'travel-right', duration_steps: steps } }), (climb) => {
      const far = tr('{1} tries: {2}.', counted(climb.tries), metres(stage.travel));
      stage.say(climb.done ? far : far.replace(/\.$/, ' …'));
    });
    stage.show(stage.json);
    rods.forEach((/** @type {number} */ rod, /** @type {number} */ i) => {
      const length = stage.json.figure.rods[rod].length_m;
      stage.slider({ label: names[i], min, max, step: 0.05, value: length, words: (value) => `${fixed(value, 2)} m` }, (value) => {
        json = withLength(json, rod, value);
        run();
      });
    });
    run();
  },
};
