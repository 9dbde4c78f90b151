// SPDX-License-Identifier: MIT
// The coordinator's role: runs the search's ask/tell loop, sends each batch to the evaluators in slices, and puts the
// scores back in order. An evaluator that ends a slice already has the next one, so it does not wait for the
// coordinator. The next slice may come from a second batch if the search can name one before it has the scores of the
// first. Core alone decides what to ask and how a score is used, so the result is the same for any number of
// evaluators, even if some die.
import { SCORE_LENGTH } from './engine.js';
import { unreachable } from './messages.js';

/** @typedef {import('./messages.js').Wish} Wish */
/** @typedef {import('./messages.js').OfCoordinator} OfCoordinator */
/** @typedef {import('./messages.js').EvaluatorToCoordinator} EvaluatorToCoordinator */
/** @typedef {import('./messages.js').CoordinatorToEvaluator} CoordinatorToEvaluator */
/** @typedef {import('./messages.js').SearchReport} SearchReport */

/** @typedef {{first: number, count: number}} Span  a range of a batch's genomes */
/** @typedef {Span & {id: number, batch: Batch}} Slice */
/**
 * @typedef {{genomes: Uint16Array, scores: Float32Array, waiting: Slice[], missing: number}} Batch  missing: slices
 * without scores
 */
/**
 * @typedef {object} Hand  an evaluator, as the coordinator sees it
 * @property {MessagePort} port
 * @property {Slice[]} slices        its work, in order
 * @property {number} startedMs      when it began the first slice
 * @property {number} waitedMs       time since then, counted in ticks: a machine's sleep does not count
 */

// Number of motions that the engine simulates side by side. A slice that is not a multiple leaves lanes empty.
const LANES = 4;
// Genomes per evaluator and batch. Larger batches lose less time between batches, but a search that looks ahead wastes
// more, above all at its beginning, when every fourth guess is an improvement. So the size follows the waste, measured
// over several batches. It never changes the result.
const BATCH_SIZES = [LANES, 2 * LANES, 3 * LANES, 5 * LANES, 10 * LANES];
const FIRST_BATCH_SIZE = 2;
const MOST_BATCHES = 2; // batches that may wait for scores at once
const SLICES_AT_HAND = 2;
const BATCHES_PER_MEASURE = 16;
// Simulated ÷ counted. Measured over the first 20,000 evaluations of a population of ten: 1.07 with 40 a batch, 1.17
// with 80.
const MUCH_WASTE = 1.12;
const LITTLE_WASTE = 1.04;
// Longest time for a slice, so that pause and stop take effect soon.
const LONGEST_SLICE_MS = 100;
const TICK_MS = 500;
// An evaluator is replaced after this long without an answer, or after this many times its usual time if that is
// longer.
const SILENCE_MS = 5000;
const SILENCE_RATIO = 50;
const PROGRESS_MS = 34; // at most 30 reports a second
const CHECKPOINT_MS = 900; // at least one a second
const RATE_WINDOW_MS = 3000;
// The spread of thousands takes a millisecond or two. Computing it takes at most a fiftieth of the time.
const SPREAD_REST = 50;

/**
 * Infinite after the clock was set back, so that nothing waits for the clock. @param {number} ms  an earlier time of
 * that clock
 */
const since = (ms) => (performance.now() < ms ? Infinity : performance.now() - ms);

export class Coordinator {
  /** @type {Map<number, Hand>} */
  #hands = new Map();
  /** Batches without all scores, oldest first. @type {Batch[]} */
  #batches = [];
  #lastSlice = 0;

  /** @type {SearchReport['state']} */
  #state = 'running';
  #simulated = 0;
  #batchSize = FIRST_BATCH_SIZE; // index into BATCH_SIZES
  #measure = { batches: 0, simulated: 0, evaluations: 0 }; // counts since the last choice of the batch size
  #genomeMs = 0; // an evaluator's time for one genome, smoothed
  /** Recent progress, for the rate. @type {{ms: number, evaluations: number}[]} */
  #pace = [];
  #progressMs = -Infinity;
  #checkpointMs = performance.now();
  #curveSent = -1;
  #bestSent = NaN;
  /** @type {SearchReport['spread']} */
  #spread = null;
  #spreadMs = -Infinity;
  #spreadRestMs = 0;

  /**
   * @param {import('./engine.js').Engine} engine
   * @param {import('./messages.js').Coordinate} role
   * @param {(message: OfCoordinator, transfer?: Transferable[]) => void} post
   * @param {(error: unknown) => void} die  ends the role after an error
   * @param {number} [longestMs]  longest time for a slice
   */
  constructor(engine, { document, state, workers }, post, die, longestMs = LONGEST_SLICE_MS) {
    this.longestMs = longestMs;
    this.die = die;
    this.search = engine.search(document);
    if (state) this.search.load(state);
    this.workers = workers;
    this.#measure.evaluations = this.search.evaluations;
    this.post = post;
    this.ticker = setInterval(() => this.#attempt(() => this.#tick()), TICK_MS);
  }

  /** @param {Wish} message */
  receive(message) {
    switch (message.type) {
      case 'add-evaluator':
        this.#add(message.evaluator, message.port);
        break;
      case 'remove-evaluator':
        this.#remove(message.evaluator);
        break;
      case 'pause':
      case 'resume':
        this.#state = message.type === 'pause' ? 'paused' : 'running';
        this.#pace = [];
        this.#report();
        break;
      case 'stop':
        this.#finish('stopped');
        break;
      default:
        unreachable(message);
    }
    this.#deal();
  }

  /** @param {number} evaluator @param {MessagePort} port */
  #add(evaluator, port) {
    if (this.#hands.has(evaluator)) return; // a repeated message: it already has work
    /** @type {Hand} */
    const hand = { port, slices: [], startedMs: 0, waitedMs: 0 };
    this.#hands.set(evaluator, hand);
    /** @param {MessageEvent<EvaluatorToCoordinator>} event */
    port.onmessage = ({ data }) => this.#attempt(() => this.#take(hand, data));
    // Some browsers report that the other end has died, so there is no need to wait for its silence.
    port.addEventListener('close', () => {
      this.#attempt(() => { if (this.#hands.get(evaluator) === hand) this.#giveUp(evaluator); });
    });
  }

  /** Runs an action between messages to the role. @param {() => void} action */
  #attempt(action) {
    try {
      action();
    } catch (error) {
      this.die(error);
    }
  }

  /** @param {number} evaluator */
  #remove(evaluator) {
    const hand = this.#hands.get(evaluator);
    this.#hands.delete(evaluator);
    if (!hand) return;
    // Its answers may still arrive. They must not count, since another evaluator scores the same slices.
    for (const slice of hand.slices.splice(0)) slice.batch.waiting.unshift(slice);
    hangUp(hand);
  }

  /** @param {number} evaluator */
  #giveUp(evaluator) {
    this.#remove(evaluator);
    this.post({ type: 'silent', evaluator });
    this.#deal();
  }

  /** Gives every evaluator work until it has enough, those with the least first. */
  #deal() {
    for (let level = 0; level < SLICES_AT_HAND; level++) {
      for (const hand of this.#hands.values()) {
        if (hand.slices.length > level) continue;
        if (this.#state !== 'running') return;
        const slice = this.#next();
        if (!slice) return;
        const genes = this.search.genes;
        const { id, batch, first, count } = slice;
        const genomes = /** @type {Uint16Array<ArrayBuffer>} */ (batch.genomes.slice(first * genes, (first + count) * genes));
        if (hand.slices.push(slice) === 1) this.#begin(hand);
        /** @type {CoordinatorToEvaluator} */
        const message = { type: 'score', slice: id, genomes };
        hand.port.postMessage(message, [genomes.buffer]);
      }
    }
  }

  /** @param {Hand} hand */
  #begin(hand) {
    hand.startedMs = performance.now();
    hand.waitedMs = 0;
  }

  /**
   * @returns {Slice | undefined} a slice of the oldest batch that has one, or of a new batch if the search can name it
   */
  #next() {
    const batch = this.#batches.find(({ waiting }) => waiting.length > 0) ?? this.#ask();
    return batch?.waiting.shift();
  }

  /**
   * @returns {Batch | null} null at the end of the search, or while every proposal depends on scores that have not
   * arrived
   */
  #ask() {
    const underWay = this.#batches.length;
    if (underWay > 0 && (underWay >= MOST_BATCHES || !this.search.asksAhead)) return null;
    if (this.search.done) {
      if (underWay === 0) this.#finish('done');
      return null;
    }
    const genomes = this.search.ask(BATCH_SIZES[this.#batchSize] * this.workers);
    const count = genomes.length / this.search.genes;
    if (count === 0) return null;
    const share = Math.ceil(count / Math.max(1, this.#hands.size));
    const soon = this.#genomeMs > 0 ? LANES * Math.max(1, Math.floor(this.longestMs / this.#genomeMs / LANES)) : LANES;
    /** @type {Batch} */
    const batch = { genomes, scores: new Float32Array(SCORE_LENGTH * count), waiting: [], missing: 0 };
    batch.waiting = cut(count, Math.min(share, soon)).map((span) => ({ ...span, id: ++this.#lastSlice, batch }));
    batch.missing = batch.waiting.length;
    this.#batches.push(batch);
    return batch;
  }

  /** @param {Hand} hand @param {EvaluatorToCoordinator} result */
  #take(hand, { slice: id, scores }) {
    const slice = hand.slices[0];
    if (slice?.id !== id) return; // the slice was taken back from an evaluator that seemed dead
    hand.slices.shift();
    // Limited by ticks, since the clock may jump.
    const ms = Math.min(since(hand.startedMs), hand.waitedMs + TICK_MS) / slice.count;
    this.#begin(hand);
    this.#genomeMs = this.#genomeMs > 0 ? 0.8 * this.#genomeMs + 0.2 * ms : ms;
    this.#simulated += slice.count;
    const { batch } = slice;
    batch.scores.set(scores, SCORE_LENGTH * slice.first);
    batch.missing--;
    while (this.#batches.length > 0 && this.#batches[0].missing === 0) {
      this.search.tell(/** @type {Batch} */ (this.#batches.shift()).scores);
      this.#batchDone();
    }
    this.#deal();
  }

  #batchDone() {
    this.#fitBatchSize();
    const now = performance.now();
    if (now < (this.#pace.at(-1)?.ms ?? 0)) this.#pace = [];
    this.#pace.push({ ms: now, evaluations: this.search.evaluations });
    while (this.#pace[0].ms < now - RATE_WINDOW_MS) this.#pace.shift();
    if (since(this.#checkpointMs) >= CHECKPOINT_MS) {
      this.#checkpointMs = now;
      const state = this.search.save();
      this.post({ type: 'checkpoint', state, evaluations: this.search.evaluations }, [state.buffer]);
    }
    if (since(this.#progressMs) >= PROGRESS_MS) this.#report();
  }

  #fitBatchSize() {
    if (++this.#measure.batches < BATCHES_PER_MEASURE) return;
    const { evaluations } = this.search;
    const waste = (this.#simulated - this.#measure.simulated) / Math.max(1, evaluations - this.#measure.evaluations);
    if (waste > MUCH_WASTE) this.#batchSize = Math.max(0, this.#batchSize - 1);
    if (waste < LITTLE_WASTE) this.#batchSize = Math.min(BATCH_SIZES.length - 1, this.#batchSize + 1);
    this.#measure = { batches: 0, simulated: this.#simulated, evaluations };
  }

  #tick() {
    for (const [evaluator, hand] of [...this.#hands]) {
      if (hand.slices.length === 0) continue;
      hand.waitedMs += TICK_MS;
      const usualMs = this.#genomeMs * hand.slices[0].count;
      if (hand.waitedMs > Math.max(SILENCE_MS, SILENCE_RATIO * usualMs)) this.#giveUp(evaluator);
    }
    // Without reports the page would replace the coordinator.
    if (since(this.#progressMs) >= TICK_MS) this.#report();
  }

  #report() {
    this.#progressMs = performance.now();
    this.post({ type: 'progress', report: this.#summary(false), evaluators: [...this.#hands.keys()] });
  }

  /** @param {'done' | 'stopped'} state */
  #finish(state) {
    this.#state = state;
    this.letGo();
    this.post({ type: 'finished', report: this.#summary(true) });
  }

  /** Stops receiving messages. */
  letGo() {
    clearInterval(this.ticker);
    for (const hand of this.#hands.values()) hangUp(hand);
    this.#hands.clear();
  }

  free() { this.search.close(); }

  /** At most fifty times as old as the time it takes to compute. @param {boolean} anew */
  #spreadNow(anew) {
    if (anew || since(this.#spreadMs) >= this.#spreadRestMs) {
      this.#spreadMs = performance.now();
      this.#spread = this.search.spread;
      this.#spreadRestMs = SPREAD_REST * Math.min(since(this.#spreadMs), TICK_MS);
    }
    return this.#spread;
  }

  /** @param {boolean} everything @returns {SearchReport} */
  #summary(everything) {
    const { search } = this;
    const { evaluations, budget, bestFitness, curveLength } = search;
    const pace = this.#pace;
    const spanMs = pace.length > 1 ? pace[pace.length - 1].ms - pace[0].ms : 0;
    const rate = spanMs > 0 ? (1000 * (pace[pace.length - 1].evaluations - pace[0].evaluations)) / spanMs : 0;
    const newBest = everything || bestFitness !== this.#bestSent;
    const newCurve = everything || curveLength !== this.#curveSent;
    const bestGenome = newBest ? search.bestGenome : null;
    if (bestGenome?.length) this.#bestSent = bestFitness;
    this.#curveSent = curveLength;
    return {
      state: this.#state,
      evaluations,
      budget,
      simulated: this.#simulated,
      rate,
      secondsLeft: rate > 0 ? (budget - evaluations) / rate : 0,
      bestFitness,
      bestGenome: bestGenome?.length ? bestGenome : null,
      curve: newCurve ? search.curve : null,
      spread: this.#spreadNow(everything),
      saved: everything ? search.save() : null,
    };
  }
}

/** Closing is not enough: between two ends in one page a message sent before still arrives. @param {Hand} hand */
function hangUp({ port }) {
  port.onmessage = null;
  port.close();
}

/**
 * Cuts `count` genomes into slices of at most `most`, as evenly as whole lanes allow.
 * @param {number} count @param {number} most
 * @returns {Span[]}
 */
export function cut(count, most) {
  const rows = Math.ceil(count / LANES);
  const slices = Math.max(1, Math.ceil(rows / Math.ceil(most / LANES)));
  return Array.from({ length: slices }, (_, i) => {
    const first = LANES * Math.floor((i * rows) / slices);
    return { first, count: Math.min(count, LANES * Math.floor(((i + 1) * rows) / slices)) - first };
  });
}
