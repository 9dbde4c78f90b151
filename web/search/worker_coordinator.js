// SPDX-License-Identifier: MIT
// The coordinator's role: runs the search's ask/tell loop, sends each batch to the evaluators in slices, and puts the
// scores back in order. An evaluator that ends a slice already has the next one, so it does not wait for the
// coordinator. The next slice may come from a second batch if the search can propose one before it has the scores of
// the first. A small batch is scored here: sending it takes longer. Only core decides which genomes to score and how to
// use a score. So the result is the same for any number of evaluators, even if some die.
import { SCORE_LENGTH } from './engine.js';
import { unreachable } from './messages.js';
import { BatchSize, cut, LANES } from './worker_batches.js';

/** @typedef {import('./messages.js').SearchRequest} SearchRequest */
/** @typedef {import('./messages.js').CoordinatorMessage} CoordinatorMessage */
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
 * @typedef {object} Evaluator  an evaluator, with its outstanding work
 * @property {MessagePort} port
 * @property {Slice[]} slices        its work, in order
 * @property {number} startedMs      when it began the first slice
 * @property {number} waitedMs       time since then, counted in ticks so that a machine's sleep does not count
 */

const MAX_BATCHES = 2; // batches that may wait for scores at once
const SLICES_PER_EVALUATOR = 2;
// Longest time for a slice, so that pause and stop take effect soon.
const LONGEST_SLICE_MS = 100;
// A batch is scored here if that takes less than this: two messages between busy cores take longer.
const MESSAGES_MS = 4;
const MOST_HERE = 4 * LANES; // genomes of such a batch
// After this long messages are read between batches that are scored here.
const HERE_MS = 50;
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
 * Time since `ms`. Infinite after the clock was set back, so that nothing waits for the clock.
 * @param {number} ms  an earlier performance.now()
 */
const since = (ms) => (performance.now() < ms ? Infinity : performance.now() - ms);
/** @param {number} before  0: nothing @param {number} now */
const smooth = (before, now) => (before > 0 ? 0.8 * before + 0.2 * now : now);

export class Coordinator {
  /** @type {Map<number, Evaluator>} */
  #evaluators = new Map();
  /** Batches without all scores, oldest first. @type {Batch[]} */
  #batches = [];
  #lastSlice = 0;

  /** @type {SearchReport['state']} */
  #state = 'running';
  #simulated = 0;
  /** @type {BatchSize} */
  #batchSize;
  #genomeMs = 0; // an evaluator's time for one genome, smoothed
  #hereMs = 0; // the same here, without messages
  /** Recent progress, for the rate. @type {{ms: number, evaluations: number}[]} */
  #rateSamples = [];
  #progressMs = -Infinity;
  #checkpointMs = performance.now();
  #curveSent = -1;
  #bestSent = NaN;
  /** The first genome of the last batch. @type {Uint16Array | null} */
  #attempt = null;
  /** @type {SearchReport['spread']} */
  #spread = null;
  #spreadMs = -Infinity;
  #spreadRestMs = 0;
  /** Comes back to batches that are scored here after messages. */
  #again = new MessageChannel();
  #comesBack = false; // a message of #again is on its way

  /**
   * @param {import('./engine.js').Engine} engine
   * @param {import('./messages.js').Coordinate} role
   * @param {(message: CoordinatorMessage, transfer?: Transferable[]) => void} post
   * @param {(error: unknown) => void} die  ends the role after an error
   * @param {number} [longestMs]  longest time for a slice
   */
  constructor(engine, { document, state, workers, breeds }, post, die, longestMs = LONGEST_SLICE_MS) {
    this.longestMs = longestMs;
    this.die = die;
    this.search = breeds ? engine.brood(document) : engine.search(document);
    this.#again.port1.onmessage = () => {
      this.#comesBack = false;
      this.#act(() => this.#assignWork());
    };
    if (state) this.search.load(state);
    this.workers = workers;
    this.#batchSize = new BatchSize(this.search.evaluations);
    this.post = post;
    this.ticker = setInterval(() => this.#act(() => this.#tick()), TICK_MS);
  }

  /** @param {SearchRequest} message */
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
        this.#rateSamples = [];
        this.#report();
        break;
      case 'stop':
        this.#finish('stopped');
        break;
      default:
        unreachable(message);
    }
    this.#assignWork();
  }

  /** @param {number} id @param {MessagePort} port */
  #add(id, port) {
    if (this.#evaluators.has(id)) return; // a repeated message
    /** @type {Evaluator} */
    const evaluator = { port, slices: [], startedMs: 0, waitedMs: 0 };
    this.#evaluators.set(id, evaluator);
    /** @param {MessageEvent<EvaluatorToCoordinator>} event */
    port.onmessage = ({ data }) => this.#act(() => this.#receiveScores(evaluator, data));
    // Some browsers report that the other end has died, so there is no need to wait for its silence.
    port.addEventListener('close', () => {
      this.#act(() => { if (this.#evaluators.get(id) === evaluator) this.#giveUp(id); });
    });
  }

  /** Runs an action that no message to the role has caused. An error ends the role. @param {() => void} action */
  #act(action) {
    try {
      action();
    } catch (error) {
      this.die(error);
    }
  }

  /** @param {number} id */
  #remove(id) {
    const evaluator = this.#evaluators.get(id);
    this.#evaluators.delete(id);
    if (!evaluator) return;
    // Its answers may still arrive. They must not count, since another evaluator scores the same slices.
    for (const slice of evaluator.slices.splice(0)) slice.batch.waiting.unshift(slice);
    closePort(evaluator);
  }

  /** @param {number} id */
  #giveUp(id) {
    this.#remove(id);
    this.post({ type: 'silent', evaluator: id });
    this.#assignWork();
  }

  /**
   * Scores small batches, as long as such come. Another batch waits for #assignWork.
   * @returns {boolean} whether it goes on after messages were read
   */
  #scoreHere() {
    const start = performance.now();
    while (this.#state === 'running' && this.#batches.length === 0) {
      if (since(start) > HERE_MS) {
        if (!this.#comesBack) this.#again.port2.postMessage(null);
        this.#comesBack = true;
        return true;
      }
      const batch = this.#ask();
      const count = batch ? batch.genomes.length / this.search.genes : 0;
      if (!batch || !this.#fitsHere(count)) return false;
      this.#batches = [];
      const begin = performance.now();
      this.search.scoreHere();
      this.#hereMs = smooth(this.#hereMs, since(begin) / count);
      this.#simulated += count;
      this.#batchDone(batch);
    }
    return false;
  }

  /** @param {number} count  of a batch's genomes */
  #fitsHere(count) {
    return count <= LANES || (!this.search.asksAhead && count <= MOST_HERE && count * this.#hereMs <= MESSAGES_MS);
  }

  /** Gives every evaluator work until it has enough. Those with the least work come first. */
  #assignWork() {
    if (this.#evaluators.size > 0 && this.#scoreHere()) return;
    for (let level = 0; level < SLICES_PER_EVALUATOR; level++) {
      for (const evaluator of this.#evaluators.values()) {
        if (evaluator.slices.length > level) continue;
        if (this.#state !== 'running') return;
        const slice = this.#next();
        if (!slice) return;
        const genes = this.search.genes;
        const { id, batch, first, count } = slice;
        const genomes = /** @type {Uint16Array<ArrayBuffer>} */ (batch.genomes.slice(first * genes, (first + count) * genes));
        if (evaluator.slices.push(slice) === 1) this.#startClock(evaluator);
        /** @type {CoordinatorToEvaluator} */
        const message = { type: 'score', slice: id, genomes };
        evaluator.port.postMessage(message, [genomes.buffer]);
      }
    }
  }

  /** @param {Evaluator} evaluator */
  #startClock(evaluator) {
    evaluator.startedMs = performance.now();
    evaluator.waitedMs = 0;
  }

  /**
   * @returns {Slice | undefined} a slice of the oldest batch that has one, or of a new batch if the search can propose it
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
    const pending = this.#batches.length;
    if (pending > 0 && (pending >= MAX_BATCHES || !this.search.asksAhead)) return null;
    if (this.search.done) {
      if (pending === 0) this.#finish('done');
      return null;
    }
    const genomes = this.search.ask(this.#batchSize.perEvaluator * this.workers);
    const count = genomes.length / this.search.genes;
    if (count === 0) return null;
    const share = Math.ceil(count / Math.max(1, this.#evaluators.size));
    const soon = this.#genomeMs > 0 ? LANES * Math.max(1, Math.floor(this.longestMs / this.#genomeMs / LANES)) : LANES;
    /** @type {Batch} */
    const batch = { genomes, scores: new Float32Array(SCORE_LENGTH * count), waiting: [], missing: 0 };
    batch.waiting = cut(count, Math.min(share, soon)).map((span) => ({ ...span, id: ++this.#lastSlice, batch }));
    batch.missing = batch.waiting.length;
    this.#batches.push(batch);
    return batch;
  }

  /** @param {Evaluator} evaluator @param {EvaluatorToCoordinator} result */
  #receiveScores(evaluator, { slice: id, scores }) {
    const slice = evaluator.slices[0];
    if (slice?.id !== id) return; // the slice was taken back from an evaluator that seemed dead
    evaluator.slices.shift();
    // Limited by ticks, since the clock may jump.
    const ms = Math.min(since(evaluator.startedMs), evaluator.waitedMs + TICK_MS) / slice.count;
    this.#startClock(evaluator);
    this.#genomeMs = smooth(this.#genomeMs, ms);
    this.#simulated += slice.count;
    const { batch } = slice;
    batch.scores.set(scores, SCORE_LENGTH * slice.first);
    batch.missing--;
    while (this.#batches.length > 0 && this.#batches[0].missing === 0) {
      const done = /** @type {Batch} */ (this.#batches.shift());
      this.search.tell(done.scores);
      this.#batchDone(done);
    }
    this.#assignWork();
  }

  /** @param {Batch} done  whose scores the search was told */
  #batchDone(done) {
    this.#attempt = done.genomes.slice(0, this.search.genes);
    this.#batchSize.fit(this.#simulated, this.search.evaluations);
    const now = performance.now();
    if (now < (this.#rateSamples.at(-1)?.ms ?? 0)) this.#rateSamples = [];
    this.#rateSamples.push({ ms: now, evaluations: this.search.evaluations });
    while (this.#rateSamples[0].ms < now - RATE_WINDOW_MS) this.#rateSamples.shift();
    if (since(this.#checkpointMs) >= CHECKPOINT_MS) {
      this.#checkpointMs = now;
      const state = this.search.save();
      this.post({ type: 'checkpoint', state, evaluations: this.search.evaluations }, [state.buffer]);
    }
    if (since(this.#progressMs) >= PROGRESS_MS) this.#report();
  }

  #tick() {
    for (const [id, evaluator] of [...this.#evaluators]) {
      if (evaluator.slices.length === 0) continue;
      evaluator.waitedMs += TICK_MS;
      const usualMs = this.#genomeMs * evaluator.slices[0].count;
      if (evaluator.waitedMs > Math.max(SILENCE_MS, SILENCE_RATIO * usualMs)) this.#giveUp(id);
    }
    // Without reports the page would replace the coordinator.
    if (since(this.#progressMs) >= TICK_MS) this.#report();
  }

  #report() {
    this.#progressMs = performance.now();
    this.post({ type: 'progress', report: this.#summary(false), evaluators: [...this.#evaluators.keys()] });
  }

  /** @param {'done' | 'stopped'} state */
  #finish(state) {
    this.#state = state;
    this.disconnect();
    this.post({ type: 'finished', report: this.#summary(true), litter: this.search.litter });
  }

  /** Stops receiving messages. */
  disconnect() {
    clearInterval(this.ticker);
    this.#again.port1.close();
    for (const evaluator of this.#evaluators.values()) closePort(evaluator);
    this.#evaluators.clear();
  }

  free() { this.search.close(); }

  /** At max fifty times as old as the time it takes to compute. @param {boolean} refresh */
  #spreadNow(refresh) {
    if (refresh || since(this.#spreadMs) >= this.#spreadRestMs) {
      this.#spreadMs = performance.now();
      this.#spread = this.search.spread;
      this.#spreadRestMs = SPREAD_REST * Math.min(since(this.#spreadMs), TICK_MS);
    }
    return this.#spread;
  }

  /** @param {boolean} complete @returns {SearchReport} */
  #summary(complete) {
    const { search } = this;
    const { evaluations, budget, bestFitness, curveLength } = search;
    const rateSamples = this.#rateSamples;
    const spanMs = rateSamples.length > 1 ? rateSamples[rateSamples.length - 1].ms - rateSamples[0].ms : 0;
    const rate = spanMs > 0 ? (1000 * (rateSamples[rateSamples.length - 1].evaluations - rateSamples[0].evaluations)) / spanMs : 0;
    const sendBest = complete || bestFitness !== this.#bestSent;
    const sendCurve = complete || curveLength !== this.#curveSent;
    const bestGenome = sendBest ? search.bestGenome : null;
    if (bestGenome?.length) this.#bestSent = bestFitness;
    this.#curveSent = curveLength;
    const attempt = this.#attempt;
    this.#attempt = null;
    return {
      state: this.#state,
      evaluations,
      budget,
      simulated: this.#simulated,
      rate,
      secondsLeft: rate > 0 ? (budget - evaluations) / rate : 0,
      bestFitness,
      bestGenome: bestGenome?.length ? bestGenome : null,
      attempt,
      curve: sendCurve ? search.curve : null,
      spread: this.#spreadNow(complete),
      saved: complete ? search.save() : null,
    };
  }
}

/** Without a listener, because an earlier message still arrives if both ends are in one page. @param {Evaluator} evaluator */
function closePort({ port }) {
  port.onmessage = null;
  port.close();
}
