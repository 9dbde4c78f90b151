// SPDX-License-Identifier: MIT
// The page's side of a search: starts one coordinator and N evaluators, and replaces those that die. If an evaluator
// dies, its slice is scored again. If the coordinator dies, a new one continues from the last checkpoint. Neither
// changes the result. If a worker dies while the search is being stopped, the search ends with the latest results. A
// lost message looks like a dead worker or a request without an answer, and is handled in the same way.
import { EngineError } from './engine.js';
import { grouped, tr, trLater } from '../languages/language.js';
import { NO_REPORT } from '../app/no_report.js';
import { unreachable } from './messages.js';

/** @typedef {import('./messages.js').CoordinatorToPage} CoordinatorToPage */
/** @typedef {import('./messages.js').OfCoordinator} OfCoordinator */
/** @typedef {import('./messages.js').EvaluatorToPage} EvaluatorToPage */
/** @typedef {import('./messages.js').Wish} Wish */
/** @typedef {import('./messages.js').Role} Role */
/** @typedef {import('./messages.js').SearchReport} SearchReport */

/**
 * Receives the client's events.
 * @typedef {object} SearchListener
 * @property {(report: SearchReport) => void} progress  at most about 30 times a second; the last one has state 'done'
 * or 'stopped'
 * @property {(sentence: string) => void} incident      a worker died and was replaced
 * @property {(error: Error) => void} failed            the search is over without a result
 */

/**
 * @typedef {{worker: Worker, ready: boolean, waitedMs: number}} Evaluator  waitedMs: time since its last sign of life
 */
/**
 * @typedef {object} Crew  the workers of one search
 * @property {number} run
 * @property {Worker} coordinator
 * @property {boolean} coordinatorReady
 * @property {boolean} paused     by the coordinator's last report
 * @property {number} silentMs
 * @property {Map<number, Evaluator>} evaluators
 * @property {boolean} sound  none of them has died
 */

const TICK_MS = 1000;
// The coordinator reports at least once a second and lists the evaluators that have work.
const SILENCE_MS = 5000;
// Scripts may load over a slow line. After that a worker needs an engine and a document.
const LOAD_MS = 30000;
const BEGIN_MS = 10000;
// A coordinator that has not ended its search by then hangs.
const STOP_MS = 2000;
// More deaths than this without an evaluation in between are not an accident.
const MOST_DEATHS = 8;
// Workers without a search keep their scripts and engine for the next one. They are ended after this time, since each
// uses memory.
const REST_MS = 5 * 60000;

export class SearchClient {
  /** @type {Crew | null} */
  #crew = null;
  /**
   * Workers without a search: new ones, or those of the last search if it was done and no worker died. @type {Worker[]}
   */
  #rested = [];
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #rest;
  /** @type {Uint8Array} */
  #document = new Uint8Array();
  #workers = 1;
  #paused = false;
  /** Runs from the request to stop until the coordinator has stopped. @type {ReturnType<typeof setTimeout> | null} */
  #stopping = null;
  /** The last report, completed from earlier reports. @type {SearchReport} */
  #known = NO_REPORT;
  /** @type {{state: Uint8Array, evaluations: number} | null} */
  #checkpoint = null;
  #deaths = 0;
  #evaluations = 0;
  #evaluatorNumber = 0;
  #runs = 0;
  /** Workers whose scripts are loaded. @type {WeakSet<Worker>} */
  #loaded = new WeakSet();
  /** @type {ReturnType<typeof setInterval> | undefined} */
  #watch;

  /**
   * @param {object} options
   * @param {WebAssembly.Module} options.engine  compiled engine_module.wasm; sent to every worker
   * @param {() => Worker} options.createWorker  of worker.js
   * @param {SearchListener} options.listener
   */
  constructor({ engine, createWorker, listener }) {
    this.engine = engine;
    this.createWorker = createWorker;
    this.listener = listener;
  }

  /**
   * Lets workers load what they need before a search is requested, so that it starts at once.
   * @param {number} workers  evaluators
   */
  standBy(workers) {
    if (this.#crew || this.#rested.length > 0) return;
    const standing = Array.from({ length: workers + 1 }, () => this.createWorker());
    for (const worker of standing) worker.postMessage(/** @type {Role} */ ({ type: 'stand-by', engine: this.engine }));
    this.#rests(standing);
  }

  get searching() { return this.#crew !== null; }

  /**
   * Runs the document's search and drops a running one.
   * @param {Uint8Array} document  binary form
   * @param {number} workers       evaluators, at least 1
   */
  start(document, workers) {
    this.#dismiss();
    this.#document = document;
    this.#workers = Math.max(1, Math.floor(workers));
    this.#paused = false;
    this.#known = NO_REPORT;
    this.#checkpoint = null;
    this.#deaths = 0;
    this.#evaluations = 0;
    try {
      this.#hire();
    } catch (error) {
      this.#dismiss(); // the browser allows no more workers
      throw error;
    }
  }

  pause() {
    if (this.#stopping !== null) return;
    this.#paused = true;
    this.#send({ type: 'pause' });
  }

  resume() {
    if (this.#stopping !== null) return;
    this.#paused = false;
    this.#send({ type: 'resume' });
  }

  /** The last report has state 'stopped', even if the workers hang or die now. */
  stop() {
    if (!this.#crew || this.#stopping !== null) return;
    this.#stopping = setTimeout(() => this.#stopped(), STOP_MS);
    this.#send({ type: 'stop' });
  }

  /** Ends all workers at once. @returns {SearchReport} the latest report of their search, with state 'stopped' */
  close() {
    this.#sendHome();
    return this.drop();
  }

  /** Ends the running search and its workers at once. @returns {SearchReport} as of close() */
  drop() {
    const known = this.#crew ? this.#known : NO_REPORT;
    this.#dismiss();
    return { ...known, state: 'stopped', rate: 0, secondsLeft: 0 };
  }

  // The crew.

  #hire() {
    clearTimeout(this.#rest);
    const coordinator = this.#worker();
    /** @type {Crew} */
    const crew = { run: ++this.#runs, coordinator, coordinatorReady: false, paused: false, silentMs: 0, evaluators: new Map(), sound: true };
    this.#crew = crew;
    /** @param {MessageEvent<CoordinatorToPage>} event */
    coordinator.onmessage = ({ data }) => {
      if (data.type === 'loaded') this.#loaded.add(coordinator);
      else if (crew === this.#crew && data.run === crew.run) this.#hear(crew, data);
    };
    coordinator.onerror = (event) => {
      event.preventDefault?.();
      if (crew === this.#crew) this.#coordinatorDied(event.message);
    };
    /** @type {Role} */
    const role = {
      type: 'coordinate',
      run: crew.run,
      engine: this.engine,
      document: this.#document,
      state: this.#checkpoint?.state ?? null,
      workers: this.#workers,
    };
    coordinator.postMessage(role);
    if (this.#paused) this.#send({ type: 'pause' });
    for (let i = 0; i < this.#workers; i++) this.#addEvaluator(crew);
    this.#sendHome(); // ends surplus workers
    this.#watch = setInterval(() => this.#tick(crew), TICK_MS);
  }

  #worker() { return this.#rested.shift() ?? this.createWorker(); }

  /** Keeps the workers of a search that is done. @param {Crew} crew */
  #letRest(crew) {
    const evaluators = [...crew.evaluators.values()];
    if (crew.sound && evaluators.every(({ ready }) => ready)) {
      this.#crew = null; // keeps the workers from being ended
      this.#rests([crew.coordinator, ...evaluators.map(({ worker }) => worker)]);
    }
    this.#dismiss();
  }

  /** @param {Worker[]} workers  coordinator first */
  #rests(workers) {
    this.#rested = workers;
    for (const worker of workers) {
      worker.onmessage = ({ data }) => { if (data.type === 'loaded') this.#loaded.add(worker); };
      worker.onerror = () => this.#sendHome();
    }
    this.#rest = setTimeout(() => this.#sendHome(), REST_MS);
  }

  #sendHome() {
    clearTimeout(this.#rest);
    for (const worker of this.#rested.splice(0)) worker.terminate();
  }

  #dismiss() {
    clearInterval(this.#watch);
    if (this.#stopping !== null) clearTimeout(this.#stopping);
    this.#stopping = null;
    this.#crew?.coordinator.terminate();
    for (const { worker } of this.#crew?.evaluators.values() ?? []) worker.terminate();
    this.#crew = null;
  }

  /** @param {Crew} crew */
  #addEvaluator(crew) {
    const evaluator = this.#evaluatorNumber++;
    const worker = this.#worker();
    const { port1, port2 } = new MessageChannel();
    const entry = { worker, ready: false, waitedMs: 0 };
    crew.evaluators.set(evaluator, entry);
    /** @param {MessageEvent<EvaluatorToPage>} event */
    worker.onmessage = ({ data }) => {
      if (data.type === 'loaded') {
        this.#loaded.add(worker);
        entry.waitedMs = 0;
        return;
      }
      if (crew !== this.#crew || data.run !== crew.run) return;
      switch (data.type) {
        case 'ready':
          if (entry.ready) return; // a repeated message: the port was already sent
          entry.ready = true;
          entry.waitedMs = 0;
          this.#send({ type: 'add-evaluator', evaluator, port: port2 }, [port2]);
          break;
        case 'failed':
          this.#fail(new EngineError(data.fault));
          break;
        default:
          unreachable(data);
      }
    };
    worker.onerror = (event) => {
      event.preventDefault?.();
      if (crew === this.#crew) this.#replace(crew, evaluator, event.message);
    };
    /** @type {Role} */
    const role = { type: 'evaluate', run: crew.run, engine: this.engine, document: this.#document, port: port1 };
    worker.postMessage(role, [port1]);
  }

  /** @param {Crew} crew @param {OfCoordinator} message */
  #hear(crew, message) {
    crew.silentMs = 0;
    crew.coordinatorReady = true;
    switch (message.type) {
      case 'ready':
        break;
      case 'progress':
        crew.paused = message.report.state === 'paused';
        for (const evaluator of message.evaluators) {
          const entry = crew.evaluators.get(evaluator);
          if (entry) entry.waitedMs = 0;
        }
        if (message.report.evaluations > this.#evaluations) this.#deaths = 0;
        this.#evaluations = Math.max(this.#evaluations, message.report.evaluations);
        this.#known = {
          ...message.report,
          bestGenome: message.report.bestGenome ?? this.#known.bestGenome,
          curve: message.report.curve ?? this.#known.curve,
        };
        this.listener.progress(message.report);
        break;
      case 'finished':
        if (message.report.state === 'done') this.#letRest(crew);
        else this.#dismiss();
        this.listener.progress(message.report);
        break;
      case 'checkpoint':
        this.#checkpoint = message;
        break;
      case 'silent':
        this.#replace(crew, message.evaluator);
        break;
      case 'failed':
        this.#fail(new EngineError(message.fault));
        break;
      default:
        unreachable(message);
    }
  }

  // Dead workers.

  /** @param {Crew} crew */
  #tick(crew) {
    // Counts ticks instead of reading a clock, so that a sleeping laptop makes no worker late.
    crew.silentMs += TICK_MS;
    if (crew.silentMs > this.#patienceMs(crew.coordinator, crew.coordinatorReady)) {
      this.#coordinatorDied();
      return;
    }
    if (crew.coordinatorReady && crew.paused !== this.#paused) this.#send({ type: this.#paused ? 'pause' : 'resume' });
    for (const [evaluator, entry] of [...crew.evaluators]) {
      if (entry.ready && !crew.coordinatorReady) continue; // the coordinator cannot know this evaluator yet
      if ((entry.waitedMs += TICK_MS) > this.#patienceMs(entry.worker, entry.ready)) this.#replace(crew, evaluator);
    }
  }

  /** @param {Worker} worker @param {boolean} ready */
  #patienceMs(worker, ready) { return ready ? SILENCE_MS : this.#loaded.has(worker) ? BEGIN_MS : LOAD_MS; }

  /** @param {Crew} crew @param {number} evaluator @param {string} [reason] */
  #replace(crew, evaluator, reason) {
    const entry = crew.evaluators.get(evaluator);
    if (!entry) return; // already replaced: an error and a silence may report the same death
    entry.worker.terminate();
    crew.evaluators.delete(evaluator);
    crew.sound = false;
    this.#send({ type: 'remove-evaluator', evaluator });
    if (this.#stopping !== null) return;
    if (!this.#survives(reason)) return;
    this.listener.incident(tr('A search worker stopped; another one took over and repeats its work.'));
    this.#attempt(() => this.#addEvaluator(crew));
  }

  /** @param {string} [reason] */
  #coordinatorDied(reason) {
    if (this.#stopping !== null) {
      this.#stopped();
      return;
    }
    this.#dismiss();
    if (!this.#survives(reason)) return;
    const from = grouped(this.#checkpoint?.evaluations ?? 0);
    this.listener.incident(tr('The coordinator of the search stopped; another one continues from evaluation {1}.', from));
    this.#attempt(() => this.#hire());
  }

  /** @param {() => void} hire */
  #attempt(hire) {
    try {
      hire();
    } catch (error) {
      this.#fail(error instanceof Error ? error : new Error(String(error)));
    }
  }

  /** Ends a search whose coordinator cannot report its end. */
  #stopped() { this.listener.progress(this.drop()); }

  /** @param {string} [reason]  the browser's message; it differs between browsers */
  #survives(reason = '') {
    if (++this.#deaths <= MOST_DEATHS) return true;
    this.#fail(new Error(/memory|\bOOM\b/i.test(reason) ? trLater('there is not enough memory for this search; it was given up')
      : trLater('the search workers keep stopping; the search was given up')));
    return false;
  }

  /** @param {Error} error */
  #fail(error) {
    this.#dismiss();
    this.listener.failed(error);
  }

  /** @param {Wish} wish @param {Transferable[]} [transfer] */
  #send(wish, transfer = []) {
    this.#crew?.coordinator.postMessage({ ...wish, run: this.#crew.run }, transfer);
  }
}
