// SPDX-License-Identifier: MIT
// The family tree: each round with poses of those who became parents, or of its first children. Generations stand side
// by side, branches below one another.
import { mixed, paintBody } from '../share/body_painting.js';
import { FAR_SHARE, pageColours } from '../share/motion_picture.js';
import { icon } from './icon.js';
import { tr } from '../languages/language.js';

/** @typedef {import('./family.js').Family} Family */
/** @typedef {import('./nursery.js').Child} Child */
/** A moment of a child, to be painted at any time. @typedef {{body: Float32Array, x: number, height: number}} Pose */

const SHOWN = 3;
const GROUND = 0.86;

export class FamilyTree {
  /** @type {Map<Child, Pose>} */
  #poses = new Map();

  /**
   * @param {HTMLElement} list
   * @param {{simulate: (child: Child) => import('../search/engine.js').RecordedMotion, show: (round: number) => void, name: (name: string) => void}} uses
   * name: names the shown round
   */
  constructor(list, { simulate, show, name }) {
    this.list = list;
    this.name = name;
    this.simulate = simulate;
    this.show = show;
  }

  /** @param {Family} family */
  draw(family) {
    const places = placesOf(family);
    const picks = picksOf(family);
    const inside = this.list.contains(document.activeElement);
    this.list.replaceChildren(...family.rounds.map((round, i) => {
      const { column, row, branch } = places[i];
      const item = document.createElement('li');
      item.className = column === 1 ? 'first' : branch ? 'branch' : '';
      item.style.gridColumn = String(column);
      item.style.gridRow = String(row);
      const button = Object.assign(document.createElement('button'), { type: 'button' });
      const label = document.createElement('small');
      label.textContent = round.name || tr('Generation {1}', column);
      if (i === family.shown) button.ariaCurrent = 'true';
      const poses = document.createElement('div');
      const children = family.grown(i) ?? [];
      const chosen = children.map((_, at) => at).filter((at) => (picks[i] >> at) & 1);
      const rest = children.map((_, at) => at).filter((at) => !chosen.includes(at));
      for (const at of [...chosen, ...rest].slice(0, SHOWN)) poses.append(this.#picture(children[at], chosen.includes(at)));
      button.append(label, poses);
      button.ariaLabel = chosen.length ? tr('{1}, {2} picked', label.textContent, chosen.length) : label.textContent;
      button.addEventListener('click', () => this.show(i));
      item.append(button);
      if (i === family.shown) item.append(this.#pen(item, label.textContent, round.name ?? ''));
      return item;
    }));
    const current = this.list.querySelector('[aria-current]');
    if (inside && current instanceof HTMLElement) current.focus();
    current?.scrollIntoView({ block: 'nearest', inline: 'nearest' });
    requestAnimationFrame(() => this.paint());
  }

  /** Paints all poses anew, in another theme for example. */
  paint() {
    for (const canvas of this.list.querySelectorAll('canvas')) {
      const pose = this.#painted.get(canvas);
      if (pose) paint(canvas, pose);
    }
  }

  /** @type {WeakMap<HTMLCanvasElement, Pose>} */
  #painted = new WeakMap();

  /** A button that turns into a field for the name. @param {HTMLElement} item @param {string} shown @param {string} name */
  #pen(item, shown, name) {
    const pen = Object.assign(document.createElement('button'), { type: 'button', className: 'icon', ariaLabel: tr('Name “{1}”', shown), title: tr('Name “{1}”', shown) });
    pen.append(icon('M4 13.5 13 4.5l2.5 2.5-9 9H4z', ''));
    pen.addEventListener('click', () => {
      const field = Object.assign(document.createElement('input'), { type: 'text', value: name, placeholder: shown, maxLength: 40, ariaLabel: tr('Name of the generation') });
      let over = false;
      const end = (/** @type {boolean} */ keep) => {
        if (over) return;
        over = true;
        field.replaceWith(pen);
        if (keep && field.value.trim() !== name) this.name(field.value.trim());
        const next = this.list.querySelector('[aria-current]');
        if (next instanceof HTMLElement) next.focus();
      };
      field.addEventListener('keydown', (event) => {
        if (event.key !== 'Enter' && event.key !== 'Escape') return;
        event.stopPropagation();
        end(event.key === 'Enter');
      });
      field.addEventListener('blur', () => end(true));
      pen.replaceWith(field);
      field.select();
    });
    item.classList.add('named');
    return pen;
  }

  /** @param {Child} child @param {boolean} picked */
  #picture(child, picked) {
    const canvas = Object.assign(document.createElement('canvas'), { ariaHidden: 'true', className: picked ? 'picked' : '' });
    let pose = this.#poses.get(child);
    if (!pose) this.#poses.set(child, pose = this.#poseOf(child));
    this.#painted.set(canvas, pose);
    return canvas;
  }

  /** The highest moment. @param {Child} child @returns {Pose} */
  #poseOf(child) {
    const motion = this.simulate(child);
    const { numbers, stride, frames, endpoints } = motion;
    const frame = Array.from({ length: frames }, (_, i) => i).reduce((best, i) => (numbers[i * stride + 2] > numbers[best * stride + 2] ? i : best), 0);
    const tops = Array.from({ length: endpoints }, (_, k) => numbers[frame * stride + 4 + 2 * k]);
    const pose = { body: motion.body(frame), x: numbers[frame * stride + 1], height: Math.max(0.1, ...tops) };
    motion.close();
    return pose;
  }
}

/** @param {HTMLCanvasElement} canvas @param {Pose} pose */
function paint(canvas, { body, x, height }) {
  const density = Math.min(2, devicePixelRatio || 1);
  const side = canvas.clientWidth;
  canvas.width = canvas.height = Math.round(side * density);
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  context.scale(density, density);
  const { paper, ink, soft } = pageColours();
  context.fillStyle = soft;
  context.fillRect(0, GROUND * side, side, side);
  const scale = (0.78 * side) / height;
  paintBody(context, body, { left: side / 2 - x * scale, ground: GROUND * side, scale }, { body: ink, far: mixed(paper, ink, FAR_SHARE), eye: paper });
}

/** For each round the children that later rounds picked, as bits. @param {Family} family @returns {number[]} */
function picksOf({ rounds }) {
  const picks = rounds.map(() => 0);
  for (const { parent = -1, picks: bits = 1 } of rounds) {
    if (parent >= 0) picks[parent] |= bits;
  }
  return picks;
}

/** The place of each round: generations from left to right, each further child of a round in a row of its own. @param {Family} family */
function placesOf({ rounds }) {
  const places = /** @type {{column: number, row: number, branch: boolean}[]} */ ([]);
  let rows = 0;
  const heirs = new Set(); // rounds whose row is continued
  const place = (/** @type {number} */ i) => {
    const { parent = -1 } = rounds[i];
    const continues = parent >= 0 && !heirs.has(parent);
    if (continues) heirs.add(parent);
    places[i] = { column: parent < 0 ? 1 : places[parent].column + 1, row: continues ? places[parent].row : ++rows, branch: !continues && parent >= 0 };
    for (const [j, round] of rounds.entries()) {
      if ((round.parent ?? -1) === i) place(j);
    }
  };
  for (const [i, round] of rounds.entries()) {
    if ((round.parent ?? -1) < 0) place(i);
  }
  return places;
}
