// SPDX-License-Identifier: MIT
// What a person seems to like, learned from picks and answers. This browser keeps the comparisons, since a taste is for
// all figures: traits count in sizes of the figure. The model is core's (core/breeding/taste.h).
import { element } from '../browser/dom.js';
import { fixed, tr } from '../languages/language.js';
import { remember, remembered } from '../browser/storage.js';
import { traitWords } from './traits.js';
import { TRAITS } from '../search/engine.js';

/** @typedef {import('../search/engine.js').Engine} Engine */
/** @typedef {import('../search/engine.js').Comparison} Comparison */
/** @typedef {import('./nursery.js').Child} Child */
/** @typedef {{traits: Float32Array}} Seen */

const KEY = 'gaitsmith-taste';
const MOST = 600; // comparisons, the newest
const SHOWN = 6;
const FULL = 3; // log-odds that fill half of a bar
const SVG = 'http://www.w3.org/2000/svg';

export class Likes {
  /** @type {Comparison[]} */
  #comparisons = stored();

  /** @param {Engine} engine */
  constructor(engine) {
    this.engine = engine;
    this.traits = engine.traits;
    this.taste = engine.taste(this.#comparisons);
  }

  get count() { return this.#comparisons.length; }

  /** Each picked motion is preferred to each that was left. @param {Seen[]} picked @param {Seen[]} left */
  learn(picked, left) {
    this.#add(picked.flatMap((one) => left.map((other) => ({ first: one.traits, second: other.traits, verdict: 0 }))));
  }

  /** @param {Child} first @param {Child} second @param {0 | 1 | 2} verdict */
  answer(first, second, verdict) { this.#add([{ first: first.traits, second: second.traits, verdict }]); }

  forget() {
    this.#comparisons = [];
    this.#add([]);
  }

  /** The two motions whose comparison would tell most. @param {Child[]} children @returns {[Child, Child] | null} */
  question(children) {
    let best = /** @type {[Child, Child] | null} */ (null);
    let most = 0.02; // nats: less is not worth a question
    for (const [i, first] of children.entries()) {
      for (const second of children.slice(i + 1)) {
        const telling = this.taste.telling(first.traits, second.traits);
        if (telling > most) [best, most] = [[first, second], telling];
      }
    }
    return best;
  }

  /** Shows the traits that matter most. */
  draw() {
    const { weights, doubts } = this.taste;
    const rows = this.traits.map(({ name }, i) => ({ name, weight: weights[i], doubt: doubts[i] }))
      .sort((a, b) => Math.abs(b.weight) / b.doubt - Math.abs(a.weight) / a.doubt).slice(0, this.count ? SHOWN : 0);
    element('likes').replaceChildren(...rows.map(bar));
    element('likes-from').textContent = this.count === 1 ? tr('Guessed from one comparison.')
      : this.count ? tr('Guessed from {1} comparisons. Grey: not sure yet.', this.count)
        : tr('Nothing is known yet. Each pick counts as better than the others.');
    for (const id of ['likes-search', 'likes-use', 'likes-forget']) element(id).hidden = this.count === 0;
  }

  close() { this.taste.close(); }

  /** @param {Comparison[]} comparisons */
  #add(comparisons) {
    this.#comparisons = [...this.#comparisons, ...comparisons].slice(-MOST);
    this.taste.close();
    this.taste = this.engine.taste(this.#comparisons);
    remember(KEY, this.count === 0 ? null : JSON.stringify(this.#comparisons.map(({ first, second, verdict }) => [...first, ...second, verdict].map((value) => Number(value.toPrecision(6))))));
  }
}

/** @param {{name: string, weight: number, doubt: number}} row */
function bar({ name, weight, doubt }) {
  const item = document.createElement('li');
  const sure = Math.abs(weight) > doubt;
  item.className = `${weight < 0 ? 'less' : ''} ${sure ? '' : 'unsure'}`;
  const share = (/** @type {number} */ value) => 50 + 50 * Math.min(1, Math.max(-1, value / FULL));
  const picture = document.createElement('span');
  picture.className = 'bar';
  const svg = document.createElementNS(SVG, 'svg');
  svg.setAttribute('viewBox', '0 0 100 14');
  svg.setAttribute('preserveAspectRatio', 'none');
  svg.setAttribute('aria-hidden', 'true');
  svg.append(shape('rect', { x: Math.min(50, share(weight)), y: 1, width: Math.abs(share(weight) - 50), height: 12 }),
    shape('line', { x1: share(weight - doubt), x2: share(weight + doubt), y1: 7, y2: 7 }));
  picture.append(svg);
  const value = document.createElement('b');
  const number = Math.min(10, Math.max(-10, Math.round((10 * weight) / FULL)));
  value.textContent = `${number > 0 ? '+' : ''}${fixed(number, 0)}`;
  value.title = tr('{1}, give or take {2}', fixed((10 * weight) / FULL, 1), fixed((10 * doubt) / FULL, 1));
  item.append(traitWords(name), picture, value);
  return item;
}

/** @param {string} name @param {Record<string, number>} attributes */
function shape(name, attributes) {
  const node = document.createElementNS(SVG, name);
  for (const [attribute, value] of Object.entries(attributes)) node.setAttribute(attribute, String(value));
  return node;
}

/** The comparisons of earlier visits; none if the storage has anything else. @returns {Comparison[]} */
function stored() {
  try {
    const rows = /** @type {unknown} */ (JSON.parse(remembered(KEY) ?? '[]'));
    if (!Array.isArray(rows)) return [];
    return rows.filter((row) => Array.isArray(row) && row.length === 2 * TRAITS + 1 && row.every(Number.isFinite)).slice(-MOST).map((row) => ({
      first: Float32Array.from(row.slice(0, TRAITS)), second: Float32Array.from(row.slice(TRAITS, 2 * TRAITS)), verdict: row[2 * TRAITS],
    }));
  } catch {
    return [];
  }
}
