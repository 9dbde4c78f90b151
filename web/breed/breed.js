// SPDX-License-Identifier: MIT
// Breeding by eye, over the whole stage: nine motions, of which a person picks some. Loaded on first use. What is bred
// is in the document (family.js), so Undo, storage and links need nothing from here.
import { Engine } from '../search/engine.js';
import { Family } from './family.js';
import { FamilyTree } from './family_tree.js';
import { Likes } from './likes.js';
import { MotionPicture, pageColours } from '../share/motion_picture.js';
import { Nursery } from './nursery.js';
import { Tiles } from './tiles.js';
import { announce } from '../browser/announcer.js';
import { compiledEngine } from '../search/compiled_engine.js';
import { element, setText, toast } from '../browser/dom.js';
import { followLanguage, grouped, tr, trSentence } from '../languages/language.js';
import { loadPart } from '../dialogs/dialogs.js';

/** @typedef {import('../app/app.js').App} App */
/** @typedef {import('./nursery.js').Child} Child */
/** @typedef {{app: App, changed: EventTarget}} Parts  changed: has the event 'changed' */

const COVERED = ['canvas', 'mirror', 'in-words'];

/** @type {Breed | null} */
let open = null;
/** @type {Promise<{engine: Engine, nursery: Nursery}> | null} */
let loaded = null;

/** Rejected if something could not be loaded; the next call tries again. @param {Parts} parts */
export async function openBreed(parts) {
  loaded ??= load();
  loaded.catch(() => { loaded = null; });
  if (!parts.app.document().timeline?.length) return toast(tr('Teach the figure to move first. Then there is something to breed from.'));
  const { engine, nursery } = await loaded;
  open ??= new Breed(parts, engine, nursery);
}

async function load() {
  const [code] = await Promise.all([compiledEngine(), loadPart(new URL('breed', import.meta.url).href, document.querySelector('main') ?? document.body)]);
  const engine = await Engine.load(code);
  followLanguage(() => open?.translate());
  new MutationObserver(() => open?.tree.paint()).observe(document.documentElement, { attributeFilter: ['data-theme'] });
  return { engine, nursery: new Nursery(code, (tries, budget) => open?.grew(tries, budget)) };
}

class Breed {
  #root = element('breed');
  #difference = element('breed-difference', HTMLInputElement);
  #goal = element('breed-goal', HTMLInputElement);
  #towards = element('breed-towards', HTMLInputElement);
  /** @type {Child[]} */
  #children = [];
  #visit = 0; // counts what is shown, to detect what comes too late
  #generation = 0; // that grows now, for the sentence
  /** @type {[Child, Child] | null} */
  #pair = null;
  /** @type {MotionPicture[]} */
  #pairPictures = [];
  #pairFrame = 0;
  #ending = new AbortController();

  /** @param {Parts} parts @param {Engine} engine @param {Nursery} nursery */
  constructor({ app, changed }, engine, nursery) {
    this.app = app;
    this.engine = engine;
    this.nursery = nursery;
    this.family = new Family(app, engine, nursery);
    this.likes = new Likes(engine);
    const simulate = (/** @type {Child} */ child) => engine.motion(this.family.childDocument(child));
    this.simulate = simulate;
    this.tiles = new Tiles(element('breed-tiles'), { simulate, traits: this.likes.traits, picked: () => this.#update(), menu: (child, from) => this.#menu(child, from), signal: this.#ending.signal });
    this.tree = new FamilyTree(element('breed-rounds'), { simulate, show: (round) => this.#go(() => this.family.show(round)), name: (name) => this.#name(name) });
    this.wasPlaying = app.playing();
    app.play(false);
    for (const id of COVERED) element(id).inert = true;
    this.#root.hidden = false;
    this.#listen(changed);
    this.#offerParts();
    void this.#show().then(() => this.tiles.focus());
  }

  /** @param {number} tries @param {number} budget */
  grew(tries, budget) {
    if (this.#root.dataset.busy === undefined) return;
    const count = tr('{1} of {2} tries', grouped(Math.min(tries, budget)), grouped(budget));
    setText(element('breed-hint'), this.#generation > 0 ? tr('Generation {1} grows: {2}', this.#generation, count) : count);
  }

  /** @param {EventTarget} changed */
  #listen(changed) {
    const { signal } = this.#ending;
    const listen = (/** @type {string} */ id, /** @type {() => void} */ action) => element(id).addEventListener('click', () => {
      if (element(id).ariaDisabled !== 'true') action();
    }, { signal });
    listen('breed-next', () => this.#next());
    listen('breed-others', () => this.#go(() => this.family.breedOthers(this.#wish())));
    listen('breed-done', () => this.close());
    listen('likes-forget', () => {
      this.likes.forget();
      this.#ask();
    });
    listen('likes-use', () => this.#useTaste());
    listen('likes-search', () => {
      if (!this.#useTaste()) return;
      this.close();
      this.app.run('search/synthesize');
    });
    for (const [id, verdict] of /** @type {[string, 0 | 1 | 2][]} */ ([['pair-first', 0], ['pair-second', 1], ['pair-neither', 2]])) {
      listen(id, () => {
        if (!this.#pair) return;
        this.likes.answer(...this.#pair, verdict);
        this.#ask();
      });
    }
    // After a click beside all controls the page's body has the keyboard.
    document.addEventListener('keydown', (event) => {
      if (event.target === document.body || (event.target instanceof Node && this.#root.contains(event.target))) this.#key(event);
    }, { signal });
    // Undo, Redo, and documents that scripts open.
    changed.addEventListener('changed', () => {
      if (!this.app.document().timeline?.length) this.close();
      else if (this.family.follow()) void this.#show();
      else this.tree.draw(this.family);
    }, { signal });
  }

  translate() {
    this.tiles.describe();
    this.tree.draw(this.family);
    this.likes.draw();
    this.#update();
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    if (event.target instanceof HTMLInputElement && event.target.type === 'text') return; // has keys of its own
    const control = event.ctrlKey || event.metaKey;
    const letter = event.key.toLowerCase();
    let done = true;
    if (control && letter === 'z') this.app[event.shiftKey ? 'redo' : 'undo']();
    else if (control && letter === 'y') this.app.redo();
    else if (control || event.altKey) done = false;
    else if (event.key === 'Escape') element('breed-menu').matches(':popover-open') ? element('breed-menu').hidePopover() : this.close();
    else if (/^[1-9]$/.test(event.key)) this.tiles.toggle(Number(event.key) - 1);
    else if (letter === 'n') this.#next();
    else done = false;
    if (done) event.preventDefault();
  }

  /** Shows the children of the family's present round. */
  async #show() {
    const visit = ++this.#visit;
    this.#root.dataset.busy = '';
    this.#generation = 0;
    this.#update();
    try {
      const children = await this.family.children(this.family.shown, (generation) => { this.#generation = generation; });
      if (visit !== this.#visit) return;
      delete this.#root.dataset.busy;
      this.#children = children;
      this.tiles.show(children);
      this.tree.draw(this.family);
      this.#root.scrollTop = 0; // on phones all of it scrolls, and the new motions are at its top
      this.#update();
      this.#ask();
      announce(children.length === 0 ? tr('None of the children moves. Pick others, or let them differ less.')
        : tr('Generation {1}: {2} motions.', this.family.line(this.family.shown).length, children.length));
    } catch (error) {
      if (visit !== this.#visit || open !== this) return;
      delete this.#root.dataset.busy;
      this.#update();
      toast(trSentence(error instanceof Error ? error.message : String(error)));
    }
  }

  /** Runs a change of the family. @param {() => string} change  returns a fault, or nothing */
  #go(change) {
    if (this.#root.dataset.busy !== undefined) return;
    const fault = change();
    if (fault) toast(trSentence(fault));
    else void this.#show();
  }

  /** Names the shown round. @param {string} name */
  #name(name) {
    const fault = this.family.name(name);
    if (fault) toast(trSentence(fault));
    this.tree.draw(this.family);
  }

  #next() {
    const { picks } = this.tiles;
    if (picks === 0 || this.family.full || this.#root.dataset.busy !== undefined) return;
    const picked = this.#children.filter((_, i) => (picks >> i) & 1);
    this.likes.learn(picked, this.#children.filter((child) => !picked.includes(child)));
    this.#go(() => this.family.breed(picks, picked[0], this.#wish()));
  }

  #wish() {
    const bits = (/** @type {string} */ id) => [...element(id).querySelectorAll('input')].reduce((sum, { checked }, i) => sum | (checked ? 1 << i : 0), 0) >>> 0;
    return { difference: Number(this.#difference.value), keepGoal: this.#goal.checked, keptRules: bits('breed-rules'), keptJoints: bits('breed-limbs'), task: this.#task() };
  }

  /** What children become better at: the document's goal, with what the person likes if that is wished. */
  #task() {
    const { task = {} } = this.family.document;
    if (!this.#towards.checked || this.likes.count === 0) return task;
    return /** @type {import('../app/app.js').DocumentJson} */ (this.engine.json(this.#weighed())).task ?? task;
  }

  /** The document with the taste as its weights. */
  #weighed() { return this.likes.taste.weigh(this.engine.documentFromText(this.app.documentText())); }

  /** @returns {boolean} whether the document has the learned weights now */
  #useTaste() {
    const fault = this.app.open(this.engine.link(this.#weighed()), true);
    toast(fault ? trSentence(fault) : tr('What you like is the style of the next search now. Undo takes it back.'));
    this.family.follow();
    return !fault;
  }

  /** Offers each limb or muscle, and each rule, to be kept. */
  #offerParts() {
    const { figure, rules = 10, kind } = this.family.document;
    const boxes = (/** @type {number} */ count) => Array.from({ length: count }, (_, i) => {
      const label = document.createElement('label');
      label.append(Object.assign(document.createElement('input'), { type: 'checkbox' }), ` ${i + 1}`);
      return label;
    });
    const moved = figure.springs ? figure.springs.filter(({ min_rest = 1, max_rest = 1 }) => min_rest < max_rest).length : (figure.rods?.length ?? 1) - 1;
    element('breed-limbs').replaceChildren(...boxes(moved));
    element('breed-rules').replaceChildren(...boxes(rules));
    element('breed-keep').hidden = kind === 'network';
  }

  #update() {
    const busy = this.#root.dataset.busy !== undefined;
    const picks = this.tiles.picks.toString(2).replaceAll('0', '').length;
    element('breed-next').ariaDisabled = String(busy || picks === 0 || this.family.full);
    element('breed-others').ariaDisabled = String(busy || this.family.full);
    setText(element('breed-count'), picks > 0 ? tr('{1} picked', picks) : '');
    if (!busy) setText(element('breed-hint'), this.family.full ? tr('This family is full. Go back to an ancestor, or press Done and begin another.')
      : picks > 0 ? tr('Their children come next.') : tr('Pick any number. Their children come next.'));
  }

  /** Asks about the pair that tells most. */
  #ask() {
    this.likes.draw();
    cancelAnimationFrame(this.#pairFrame);
    for (const picture of this.#pairPictures) picture.close();
    this.#pair = this.likes.question(this.#children);
    element('pair').hidden = this.#pair === null;
    this.#pairPictures = (this.#pair ?? []).map((child) => new MotionPicture(this.simulate(child)));
    const canvases = [...element('pair-motions').querySelectorAll('canvas')];
    const calm = matchMedia('(prefers-reduced-motion: reduce)').matches;
    const began = performance.now();
    const tick = (/** @type {number} */ now) => {
      if (this.#pairPictures.length === 0) return;
      for (const [i, picture] of this.#pairPictures.entries()) {
        if (calm) picture.strip(canvases[i], pageColours());
        else picture.play(canvases[i], Math.max(0, now - began) / 1000, pageColours());
      }
      if (!calm) this.#pairFrame = requestAnimationFrame(tick);
    };
    this.#pairFrame = requestAnimationFrame(tick);
  }

  /** What else can be done with a motion. @param {Child} child @param {HTMLElement} from */
  #menu(child, from) {
    const menu = element('breed-menu');
    const entries = /** @type {[string, () => void][]} */ ([
      [tr('Watch it on the stage'), () => this.#take(child)],
      [tr('More like this'), () => {
        this.tiles.pick(1 << this.#children.indexOf(child));
        this.#next();
      }],
      [tr('Less like this'), () => {
        this.likes.learn(this.#children.filter((other) => other !== child), [child]);
        this.#ask();
        toast(tr('Noted: you prefer the others to this one.'));
      }],
      [tr('Add to timeline'), () => {
        const fault = this.family.chain(child);
        toast(fault ? trSentence(fault) : tr('Added to the end of the timeline. Undo takes it away.'));
      }],
      [tr('Save to the results'), () => this.#take(child, 'found/keep')],
    ]);
    menu.replaceChildren(...entries.map(([label, run]) => {
      const button = Object.assign(document.createElement('button'), { type: 'button', textContent: label });
      button.addEventListener('click', () => {
        menu.hidePopover();
        run();
      });
      return button;
    }));
    menu.showPopover();
    const [at, box] = [from.getBoundingClientRect(), menu.getBoundingClientRect()];
    menu.style.left = `${Math.max(8, Math.min(at.right - box.width, innerWidth - box.width - 8))}px`;
    menu.style.top = `${Math.max(8, at.top - box.height - 4 > 8 ? at.top - box.height - 4 : at.bottom + 4)}px`;
    menu.querySelector('button')?.focus();
  }

  /** Makes a child the document's motion. @param {Child} child @param {string} [command]  to run then; without: leaves for the stage */
  #take(child, command) {
    const fault = this.family.use(child);
    if (fault) {
      toast(trSentence(fault));
    } else if (command) {
      this.app.run(command);
      toast(tr('Saved to the results.'));
    } else {
      this.close();
      this.app.play(true);
    }
  }

  close() {
    if (open !== this) return;
    open = null;
    this.#visit++;
    this.#ending.abort();
    this.nursery.close();
    this.tiles.close();
    cancelAnimationFrame(this.#pairFrame);
    for (const picture of this.#pairPictures.splice(0)) picture.close();
    this.likes.close();
    for (const id of COVERED) element(id).inert = false;
    this.#root.hidden = true;
    if (this.wasPlaying) this.app.play(true);
    element('canvas').focus();
  }
}
