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
/** @typedef {import('./messages.js').CoordinatorMessage} CoordinatorMessage */
/** @typedef {import('./messages.js').EvaluatorToPage} EvaluatorToPage */
/** @typedef {import('./messages.js').SearchRequest} SearchRequest */
/** @typedef {import('./messages.js').Role} Role */
/** @typedef {import('./messages.js').SearchReport} SearchReport */

/**
 * Receives the client's events.
 * @typedef {object} SearchListener
 * @property {(report: SearchReport, litter?: import('./engine.js').Litter | null) => void} progress  at most about 30
 * times a second; the last one has state 'done' or 'stopped', and the children if it breeds
 * @property {(sentence: string) => void} incident      a worker died and was replaced
 * @property {(error: Error) => void} failed            the search is over without a result
 */

/** waitedMs: time since its last sign of life. @typedef {{worker: Worker, ready: boolean, waitedMs: number}} Evaluator */
/**
 * @typedef {object} Team  the workers of one search
 * @property {number} run
 * @property {Worker} coordinator
 * @property {boolean} coordinatorReady
 * @property {boolean} paused     by the coordinator's last report
 * @property {number} silentMs
 * @property {Map<number, Evaluator>} evaluators
 * @property {boolean} intact  none of them has died
 */

const TICK_MS = 1000;
// The coordinator reports at least once a second and lists the evaluators that have work.
const SILENCE_MS = 5000;
// Scripts may load over a slow line. After that a worker needs an engine and a document.
const LOAD_MS = 30000;
const START_MS = 10000;
// A coordinator that has not ended its search by then hangs.
const STOP_MS = 2000;
// More deaths than this, without an evaluation in between, have a lasting cause.
const MAX_DEATHS = 8;
// Workers without a search keep their scripts and engine for the next one. They are ended after this time, since each
// uses memory.
const IDLE_MS = 5 * 60000;

export class SearchClient {
  /** @type {Team | null} */
  #team = null;
  /** Without a search: new ones, or those of the last search if it was done and none died. @type {Worker[]} */
  #idle = [];
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #idleTimer;
  /** @type {Uint8Array} */
  #document = new Uint8Array();
  #workers = 1;
  #breeds = false;
  #paused = false;
  /** Runs from the request to stop until the coordinator has stopped. @type {ReturnType<typeof setTimeout> | null} */
  #stopping = null;
  /** The last report, completed from earlier reports. @type {SearchReport} */
  #lastReport = NO_REPORT;
  /** @type {{state: Uint8Array, evaluations: number} | null} */
  #checkpoint = null;
  #deaths = 0;
  #evaluations = 0;
  #evaluatorNumber = 0;
  #runs = 0;
  /** Workers whose scripts are loaded. @type {WeakSet<Worker>} */
  #loaded = new WeakSet();
  /** @type {ReturnType<typeof setInterval> | undefined} */
  #ticker;

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
    if (this.#team || this.#idle.length > 0) return;
    const idle = Array.from({ length: workers + 1 }, () => this.createWorker());
    for (const worker of idle) worker.postMessage(/** @type {Role} */ ({ type: 'stand-by', engine: this.engine }));
    this.#setIdle(idle);
  }

  get searching() { return this.#team !== null; }

  /**
   * Runs the document's search and drops a running one.
   * @param {Uint8Array} document  binary form
   * @param {number} workers       evaluators, at least 1
   * @param {boolean} [breeds]     whether the document is a nursery, whose children are wanted
   */
  start(document, workers, breeds = false) {
    this.release();
    this.#document = document;
    this.#workers = Math.max(1, Math.floor(workers));
    this.#breeds = breeds;
    this.#paused = false;
    this.#lastReport = NO_REPORT;
    this.#checkpoint = null;
    this.#deaths = 0;
    this.#evaluations = 0;
    try {
      this.#startTeam();
    } catch (error) {
      this.#endTeam(); // the browser allows no more workers
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
    if (!this.#team || this.#stopping !== null) return;
    this.#stopping = setTimeout(() => this.#reportStopped(), STOP_MS);
    this.#send({ type: 'stop' });
  }

  /** Ends all workers at once. @returns {SearchReport} the latest report of their search, with state 'stopped' */
  close() {
    this.#endIdle();
    return this.drop();
  }

  /** Ends the running search and its workers at once. @returns {SearchReport} as close() does */
  drop() {
    const lastReport = this.#team ? this.#lastReport : NO_REPORT;
    this.#endTeam();
    return { ...lastReport, state: 'stopped', rate: 0, secondsLeft: 0 };
  }

  /**
   * Ends the running search and keeps its workers for the next one, if they answer.
   * @returns {SearchReport} as close() does
   */
  release() {
    const team = this.#team;
    if (!team?.coordinatorReady || team.silentMs > TICK_MS) return this.drop();
    this.#send({ type: 'stop' });
    const report = this.#lastReport;
    this.#makeIdle(team);
    return { ...report, state: 'stopped', rate: 0, secondsLeft: 0 };
  }

  // Workers of a search.

  #startTeam() {
    clearTimeout(this.#idleTimer);
    const coordinator = this.#takeWorker();
    /** @type {Team} */
    const team = { run: ++this.#runs, coordinator, coordinatorReady: false, paused: false, silentMs: 0, evaluators: new Map(), intact: true };
    this.#team = team;
    /** @param {MessageEvent<CoordinatorToPage>} event */
    coordinator.onmessage = ({ data }) => {
      if (data.type === 'loaded') this.#loaded.add(coordinator);
      else if (team === this.#team && data.run === team.run) this.#onMessage(team, data);
    };
    coordinator.onerror = (event) => {
      event.preventDefault?.();
      if (team === this.#team) this.#coordinatorDied(event.message);
    };
    /** @type {Role} */
    const role = {
      type: 'coordinate',
      run: team.run,
      engine: this.engine,
      document: this.#document,
      state: this.#checkpoint?.state ?? null,
      workers: this.#workers,
      breeds: this.#breeds,
    };
    coordinator.postMessage(role);
    if (this.#paused) this.#send({ type: 'pause' });
    for (let i = 0; i < this.#workers; i++) this.#addEvaluator(team);
    this.#endIdle(); // ends surplus workers
    this.#ticker = setInterval(() => this.#tick(team), TICK_MS);
  }

  #takeWorker() { return this.#idle.shift() ?? this.createWorker(); }

  /** Keeps the workers of a finished search for the next one, also those that still load. @param {Team} team */
  #makeIdle(team) {
    if (team.intact) {
      this.#team = null; // keeps the workers from being ended
      this.#setIdle([team.coordinator, ...[...team.evaluators.values()].map(({ worker }) => worker)]);
    }
    this.#endTeam();
  }

  /** @param {Worker[]} workers  coordinator first */
  #setIdle(workers) {
    this.#idle = workers;
    for (const worker of workers) {
      worker.onmessage = ({ data }) => { if (data.type === 'loaded') this.#loaded.add(worker); };
      worker.onerror = () => this.#endIdle();
    }
    this.#idleTimer = setTimeout(() => this.#endIdle(), IDLE_MS);
  }

  #endIdle() {
    clearTimeout(this.#idleTimer);
    for (const worker of this.#idle.splice(0)) worker.terminate();
  }

  #endTeam() {
    clearInterval(this.#ticker);
    if (this.#stopping !== null) clearTimeout(this.#stopping);
    this.#stopping = null;
    this.#team?.coordinator.terminate();
    for (const { worker } of this.#team?.evaluators.values() ?? []) worker.terminate();
    this.#team = null;
  }

  /** @param {Team} team */
  #addEvaluator(team) {
    const evaluator = this.#evaluatorNumber++;
    const worker = this.#takeWorker();
    const { port1, port2 } = new MessageChannel();
    const entry = { worker, ready: false, waitedMs: 0 };
    team.evaluators.set(evaluator, entry);
    /** @param {MessageEvent<EvaluatorToPage>} event */
    worker.onmessage = ({ data }) => {
      if (data.type === 'loaded') {
        this.#loaded.add(worker);
        entry.waitedMs = 0;
        return;
      }
      if (team !== this.#team || data.run !== team.run) return;
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
      if (team === this.#team) this.#replace(team, evaluator, event.message);
    };
    /** @type {Role} */
    const role = { type: 'evaluate', run: team.run, engine: this.engine, document: this.#document, port: port1, breeds: this.#breeds };
    worker.postMessage(role, [port1]);
  }

  /** @param {Team} team @param {CoordinatorMessage} message */
  #onMessage(team, message) {
    team.silentMs = 0;
    team.coordinatorReady = true;
    switch (message.type) {
      case 'ready':
        break;
      case 'progress':
        team.paused = message.report.state === 'paused';
        for (const evaluator of message.evaluators) {
          const entry = team.evaluators.get(evaluator);
          if (entry) entry.waitedMs = 0;
        }
        if (message.report.evaluations > this.#evaluations) this.#deaths = 0;
        this.#evaluations = Math.max(this.#evaluations, message.report.evaluations);
        this.#lastReport = {
          ...message.report,
          bestGenome: message.report.bestGenome ?? this.#lastReport.bestGenome,
          curve: message.report.curve ?? this.#lastReport.curve,
        };
        this.listener.progress(message.report);
        break;
      case 'finished':
        if (message.report.state === 'done') this.#makeIdle(team);
        else this.#endTeam();
        this.listener.progress(message.report, message.litter);
        break;
      case 'checkpoint':
        this.#checkpoint = message;
        break;
      case 'silent':
        this.#replace(team, message.evaluator);
        break;
      case 'failed':
        this.#fail(new EngineError(message.fault));
        break;
      default:
        unreachable(message);
    }
  }

  // Dead workers.

  /** @param {Team} team */
  #tick(team) {
    // Counts ticks instead of reading a clock, so that a sleeping laptop makes no worker late.
    team.silentMs += TICK_MS;
    if (team.silentMs > this.#maxSilenceMs(team.coordinator, team.coordinatorReady)) {
      this.#coordinatorDied();
      return;
    }
    if (team.coordinatorReady && team.paused !== this.#paused) this.#send({ type: this.#paused ? 'pause' : 'resume' });
    for (const [evaluator, entry] of [...team.evaluators]) {
      if (entry.ready && !team.coordinatorReady) continue; // the coordinator cannot know this evaluator yet
      if ((entry.waitedMs += TICK_MS) > this.#maxSilenceMs(entry.worker, entry.ready)) this.#replace(team, evaluator);
    }
  }

  /** @param {Worker} worker @param {boolean} ready */
  #maxSilenceMs(worker, ready) { return ready ? SILENCE_MS : this.#loaded.has(worker) ? START_MS : LOAD_MS; }

  /** @param {Team} team @param {number} evaluator @param {string} [reason] */
  #replace(team, evaluator, reason) {
    const entry = team.evaluators.get(evaluator);
    if (!entry) return; // already replaced: an error and a timeout may report the same death
    entry.worker.terminate();
    team.evaluators.delete(evaluator);
    team.intact = false;
    this.#send({ type: 'remove-evaluator', evaluator });
    if (this.#stopping !== null) return;
    if (!this.#countDeath(reason)) return;
    this.listener.incident(tr('A search worker stopped. Another one took over and repeats its work.'));
    this.#attempt(() => this.#addEvaluator(team));
  }

  /** @param {string} [reason] */
  #coordinatorDied(reason) {
    if (this.#stopping !== null) {
      this.#reportStopped();
      return;
    }
    this.#endTeam();
    if (!this.#countDeath(reason)) return;
    const from = grouped(this.#checkpoint?.evaluations ?? 0);
    this.listener.incident(tr('The coordinator of the search stopped. Another one continues from evaluation {1}.', from));
    this.#attempt(() => this.#startTeam());
  }

  /** @param {() => void} action */
  #attempt(action) {
    try {
      action();
    } catch (error) {
      this.#fail(error instanceof Error ? error : new Error(String(error)));
    }
  }

  /** Ends a search whose coordinator cannot report its end. */
  #reportStopped() { this.listener.progress(this.drop()); }

  /** @param {string} [reason]  the browser's message @returns {boolean} false: too many deaths, the search has failed */
  #countDeath(reason = '') {
    if (++this.#deaths <= MAX_DEATHS) return true;
    this.#fail(new Error(/memory|\bOOM\b/i.test(reason) ? trLater('there is not enough memory for this search')
      : trLater('the search workers stopped too often')));
    return false;
  }

  /** @param {Error} error */
  #fail(error) {
    this.#endTeam();
    this.listener.failed(error);
  }

  /** @param {SearchRequest} request @param {Transferable[]} [transfer] */
  #send(request, transfer = []) {
    this.#team?.coordinator.postMessage({ ...request, run: this.#team.run }, transfer);
  }
}
