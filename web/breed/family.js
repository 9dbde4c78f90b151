// SPDX-License-Identifier: MIT
// The family of the open document: its lineage, and the children of each round, which follow from the picks and are
// grown when they are needed. The document is the only place where a lineage is kept.

/** @typedef {import('../app/app.js').App} App */
/** @typedef {import('../app/app.js').DocumentJson} DocumentJson */
/** @typedef {import('./nursery.js').Child} Child */
/** A round of docs/formats.md. @typedef {{name?: string, parent?: number, picks?: number, seed?: number, difference?: number, keep_goal?: boolean, kept_rules?: number, kept_joints?: number, task?: object}} Round */
/** @typedef {{founders: object[], rounds: Round[], shown?: number}} Lineage */
/** What a person wishes of children. task: what they become better at @typedef {{difference: number, keepGoal: boolean, keptRules: number, keptJoints: number, task: object}} Wish */

const MOST_ROUNDS = 128; // as kMaxBreedRounds of core/document/lineage.h, which refuses more
const MOST_GROWN = 256;

/** The children of rounds, by what they follow from. @type {Map<string, Child[]>} */
const litters = new Map();

export class Family {
  /** @type {DocumentJson} */
  #document;
  /** @type {Lineage} */
  #lineage;

  /**
   * @param {App} app @param {import('../search/engine.js').Engine} engine
   * @param {import('./nursery.js').Nursery} nursery
   */
  constructor(app, engine, nursery) {
    this.app = app;
    this.engine = engine;
    this.nursery = nursery;
    this.#document = app.document();
    this.#lineage = lineageOf(this.#document);
  }

  get rounds() { return this.#lineage.rounds; }
  /** Index of the round whose children are looked at. */
  get shown() { return this.#lineage.shown ?? 0; }
  get round() { return this.rounds[this.shown]; }
  get document() { return this.#document; }
  get full() { return this.rounds.length >= MOST_ROUNDS; }

  /** Reads the document anew, after Undo for example. @returns {boolean} whether the family is another one, or shows another round */
  follow() {
    const before = this.#key(this.shown);
    this.#document = this.app.document();
    this.#lineage = lineageOf(this.#document);
    return this.#key(this.shown) !== before;
  }

  /** Rounds from the founders to this one. @param {number} round @returns {number[]} */
  line(round) {
    const line = [round];
    while ((this.rounds[line[0]].parent ?? -1) >= 0) line.unshift(/** @type {number} */ (this.rounds[line[0]].parent));
    return line;
  }

  /** The children of a round, if they are grown. @param {number} round @returns {Child[] | undefined} */
  grown(round) { return litters.get(this.#key(round)); }

  /**
   * The children of a round. Grows those before it as well.
   * @param {number} round @param {(generation: number) => void} begin  called before a generation is grown
   * @returns {Promise<Child[]>}
   */
  async children(round, begin) {
    const line = this.line(round);
    let litter = /** @type {Child[]} */ ([]);
    for (const [generation, at] of line.entries()) {
      const key = this.#key(at);
      const known = litters.get(key);
      if (!known) {
        begin(generation + 1);
        const nursery = this.engine.nursery(this.#bytes(this.#lineage), at, litter.map(({ genome }) => genome));
        if (litters.size >= MOST_GROWN) litters.clear();
        litters.set(key, await this.nursery.grow(nursery));
      }
      litter = /** @type {Child[]} */ (litters.get(key));
    }
    return litter;
  }

  /** A document that shows a child, with the whole lineage. @param {Child} child @returns {Uint8Array} */
  childDocument(child) { return this.engine.child(this.#bytes(this.#lineage), child.genome); }

  /**
   * Adds a round, or goes to the same one if there is one already, and makes the first pick the document's motion.
   * @param {number} picks  bits of the shown round's children @param {Child} first  of them @param {Wish} wish
   * @returns {string} empty, or a sentence, with nothing changed
   */
  breed(picks, first, wish) {
    return this.#add({ ...this.#wished(wish), parent: this.shown, picks, seed: 1 }, first);
  }

  /** Adds a round with the same parents as the shown one. @param {Wish} wish @returns {string} as of breed */
  breedOthers(wish) {
    const { parent = -1, picks = 1 } = this.round;
    const seeds = this.rounds.filter((round) => (round.parent ?? -1) === parent && (round.picks ?? 1) === picks).map(({ seed = 1 }) => seed);
    return this.#add({ ...this.#wished(wish), parent, picks, seed: Math.max(...seeds) + 1 }, null);
  }

  /** Goes to a round. @param {number} round @returns {string} as of breed */
  show(round) { return this.#open({ ...this.#lineage, shown: round }, null); }
  /** Names the shown round. @param {string} name @returns {string} as of breed */
  name(name) {
    const rounds = this.rounds.map((round, i) => (i === this.shown ? { ...round, name } : round));
    return this.#open({ ...this.#lineage, rounds }, null);
  }

  /** Makes a child the document's motion. @param {Child} child @returns {string} as of breed */
  use(child) { return this.#open(this.#lineage, child); }

  /** Adds a child to the end of the document's timeline. @param {Child} child @returns {string} as of breed */
  chain(child) {
    const { controllers = [], timeline = [], duration_steps: end = 500, task = {} } = this.#document;
    const { controllers: [added] = [] } = /** @type {DocumentJson} */ (this.engine.json(this.childDocument(child)));
    const fault = this.app.open(JSON.stringify({
      ...this.#document, hash: undefined, controllers: [...controllers, added],
      timeline: [...timeline, { controller: controllers.length, start_step: end }], duration_steps: end + (task.duration_steps ?? 500),
    }), true);
    this.follow();
    return fault;
  }

  /** @param {Wish} wish @returns {Round} */
  #wished({ difference, keepGoal, keptRules, keptJoints, task }) {
    return { difference, keep_goal: keepGoal, kept_rules: keptRules, kept_joints: keptJoints, task };
  }

  /** @param {Round} round @param {Child | null} child */
  #add(round, child) {
    const same = this.rounds.findIndex((other) => canonical(other) === canonical(round));
    if (same >= 0) return this.show(same);
    const rounds = [...this.rounds, round];
    return this.#open({ ...this.#lineage, rounds, shown: rounds.length - 1 }, child);
  }

  /** @param {Lineage} lineage @param {Child | null} child  the document's new motion, or none @returns {string} */
  #open(lineage, child) {
    const bytes = this.#bytes(lineage);
    const fault = this.app.open(this.engine.link(child ? this.engine.child(bytes, child.genome) : bytes), true);
    if (!fault) this.follow();
    return fault;
  }

  /** @param {Lineage} lineage */
  #bytes(lineage) { return this.engine.documentFromText(JSON.stringify({ ...this.#document, hash: undefined, lineage })); }

  /** All that the children of a round follow from. @param {number} round */
  #key(round) {
    const { figure, environment, start } = this.#document;
    return JSON.stringify([figure, environment, start, this.#lineage.founders, this.line(round).map((at) => canonical({ ...this.rounds[at], parent: 0 }))]);
  }
}

/** A round without what does not matter to its children. @param {Round} round */
function canonical({ parent = -1, picks = 1, seed = 1, difference = 0.3, keep_goal = false, kept_rules = 0, kept_joints = 0, task }) {
  return JSON.stringify([parent, picks, seed, Math.fround(difference), keep_goal, kept_rules, kept_joints, task]);
}

/** The document's lineage, or one that begins with its motion. @param {DocumentJson} document @returns {Lineage} */
function lineageOf(document) {
  if (document.lineage?.rounds?.length) return document.lineage;
  const first = document.controllers?.[document.timeline?.[0]?.controller ?? 0] ?? {};
  return { founders: [{ ...first, name: undefined }], rounds: [{ task: document.task }] };
}
