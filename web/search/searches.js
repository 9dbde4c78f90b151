// SPDX-License-Identifier: MIT
// The page's searches: the application requests a search, workers run it, and its progress goes to the application, the
// status line and listeners.
import { NO_REPORT } from '../app/no_report.js';
import { compiledEngine, createWorker, hasWorkers } from './compiled_engine.js';
import { banner } from '../browser/dom.js';
import { algorithms } from '../catalogue/catalogue.js';
import { tr, trSentence } from '../languages/language.js';

/** @typedef {import('../app/app.js').App} App */
/** @typedef {import('./messages.js').SearchReport} SearchReport */

// Each needs memory, and perhaps no search follows.
const MAX_STANDBY = 4;
const STAYS_AFTER_MS = 3000; // a page that is still here was not left

/** @typedef {import('./search_client.js').SearchClient} SearchClient */
/** @typedef {import('../access/status_line.js').SearchWords} SearchWords */
/**
 * A trial of the lab: its title, the number of trials before it, and the total.
 * @typedef {{words: string, finished: number, total: number}} Trial
 */
/** @typedef {{resolve: (report: SearchReport) => void, reject: (error: Error) => void}} Settle */

/**
 * Events: 'progress' (a SearchReport), 'done' ({report, queued}: whether it came from the queue) and 'error' (an
 * Error).
 */
export class Searches extends EventTarget {
  /** @type {Promise<SearchClient> | null} */
  #prepared = null;
  /** @type {SearchClient | null} */
  #client = null;
  #run = 0; // counts starts, to detect results of an outdated start
  /** In core's format. @type {Uint8Array} */
  #curve = new Uint8Array(0);
  /** @type {SearchWords} */
  #words = { doing: () => '', unit: '', workers: 1 };
  /** The running search, if it is a trial of the lab. @type {Trial | null} */
  #trial = null;
  /** Whether the running search came from the queue. */
  #queued = false;
  /** Whether only the application reads the running search's reports. */
  #preview = false;
  #labOver = false; // whether the lab has ended; its last trial may still report
  /** Requests to send once the workers exist. @type {('pause' | 'resume' | 'stop')[]} */
  #pendingRequests = [];
  searching = false;
  /** Whether the browser is leaving the page. It then ends loads and workers, which is no fault of a search. */
  #leaving = false;
  /** Settles when the last search is done, stopped, or replaced by another. @type {Promise<SearchReport>} */
  ended = Promise.resolve(NO_REPORT);
  /** @type {Settle | null} */
  #settle = null;

  /** @param {App} app @param {import('../access/status_line.js').StatusLine} statusLine */
  constructor(app, statusLine) {
    super();
    this.app = app;
    this.statusLine = statusLine;
    for (const type of ['beforeunload', 'pagehide']) addEventListener(type, () => { this.#leaving = true; });
    // Firefox ends loads before 'pagehide'. After 'beforeunload' the page may also stay.
    addEventListener('beforeunload', () => setTimeout(() => { this.#leaving = false; }, STAYS_AFTER_MS));
    addEventListener('pageshow', () => { this.#leaving = false; });
  }

  /** Loads what only a search needs: the engine, compiled once for all workers, and the client that manages them. */
  #prepare() {
    this.#prepared ??= Promise.all([compiledEngine(), import('./search_client.js')]).then(([engine, { SearchClient }]) => new SearchClient({
      engine,
      createWorker,
      listener: {
        progress: (report) => this.#onProgress(report),
        incident: (sentence) => this.statusLine.say(sentence),
        failed: (error) => this.#fail(error),
      },
    }));
    this.#prepared.catch(() => { this.#prepared = null; }); // lets the next call try again
    return this.#prepared;
  }

  /** Loads what the first search needs while the page is idle. A failure is reported by that search. */
  async standBy() {
    const client = await this.#prepare().catch(() => null);
    if (!this.searching && hasWorkers) client?.standBy(Math.min(navigator.hardwareConcurrency || 2, MAX_STANDBY));
  }

  /** Whether a search improves the document on the page. */
  get improving() { return this.searching && this.#trial === null && !this.#queued && !this.#preview; }

  /**
   * @param {Uint8Array} document @param {number} workers
   * @param {{trial?: Trial, queued?: string, preview?: boolean}} [as]  a trial of the lab, the title of a queued search,
   * or one whose reports only the application reads
   */
  async start(document, workers, { trial, queued, preview = false } = {}) {
    const run = ++this.#run;
    this.#settle?.resolve(this.#client?.release() ?? { ...NO_REPORT, state: 'stopped' });
    this.ended = new Promise((resolve, reject) => { this.#settle = { resolve, reject }; });
    this.ended.catch(() => {}); // the banner shows the error even if no caller awaits this
    this.searching = true;
    this.#pendingRequests = [];
    this.#curve = new Uint8Array(0);
    this.#trial = trial ?? null;
    this.#queued = queued !== undefined;
    this.#preview = preview;
    this.#labOver = false;
    if (trial) {
      this.#words = { doing: (paused) => trialWords(trial, paused), unit: '', workers };
      if (trial.finished === 0) this.statusLine.say('');
    } else if (!preview) {
      this.#words = queued === undefined ? { ...wordsOf(this.app), workers }
        : { doing: (paused) => (paused ? tr('Paused: queue: {1}', queued) : tr('Queue: {1}', queued)), unit: '', workers };
      this.statusLine.say('');
      this.statusLine.show(NO_REPORT, this.#words);
    }
    try {
      const client = await this.#prepare();
      if (run !== this.#run) return;
      this.#client = client;
      if (!hasWorkers) this.statusLine.say(tr('This frame has no workers. The search runs in the page itself and takes longer.'));
      this.#client.start(document, hasWorkers ? workers : 1);
      for (const request of this.#pendingRequests.splice(0)) this.#client[request]();
    } catch (error) {
      if (run === this.#run) this.#fail(error instanceof Error ? error : new Error(String(error)));
    }
  }

  /** The application has no more trials. */
  labEnded() {
    this.#labOver = true;
    this.statusLine.clear();
  }

  /** The application accepts no more reports. @param {Error} error */
  abandon(error) {
    this.#run++;
    this.#client?.close();
    this.searching = false;
    this.#settle?.reject(error);
    this.#settle = null;
    this.statusLine.clear();
  }

  pause() { this.#request('pause'); }
  resume() { this.#request('resume'); }
  stop() { this.#request('stop'); }

  /** @param {'pause' | 'resume' | 'stop'} request */
  #request(request) {
    if (this.#client?.searching) this.#client[request]();
    else if (this.searching) this.#pendingRequests.push(request);
  }

  /** @param {SearchReport} report */
  #onProgress(report) {
    const ended = report.state === 'done' || report.state === 'stopped';
    if (report.curve) this.#curve = report.curve;
    const trial = this.#trial;
    const words = this.#words;
    const queued = this.#queued;
    const preview = this.#preview;
    const settle = this.#settle;
    if (ended) {
      this.searching = false;
      this.#settle = null;
    }
    try {
      // At the end of a search, the application starts the next search of lab or queue in this call.
      this.app.searchProgress({ ...report, curve: this.#curve });
    } catch (error) {
      this.#client?.drop();
      this.#settle = settle;
      return this.#fail(error instanceof Error ? error : new Error(String(error)));
    }
    if (preview) {
      if (ended) settle?.resolve(report);
      return;
    }
    if (trial) {
      if (!ended && !this.#labOver) this.statusLine.show(labReport(report, trial), words);
      return;
    }
    if (!(ended && this.searching)) this.statusLine.show(report, words);
    this.dispatchEvent(new CustomEvent('progress', { detail: report }));
    if (!ended) return;
    settle?.resolve(report);
    this.dispatchEvent(new CustomEvent('done', { detail: { report, queued } }));
  }

  /** @param {Error} error */
  #fail(error) {
    if (this.#leaving) return;
    const settle = this.#settle;
    const fault = trSentence(error.message);
    const message = this.#queued ? tr('The search failed: {1}. Its best motion is kept. The queue continues.', fault)
      : tr('The search failed: {1}. Its best motion is kept. You can start the search again.', fault);
    this.searching = false;
    this.#settle = null;
    this.app.searchFailed(); // the application may start the next search of the queue in this call
    if (!this.searching) this.statusLine.clear();
    banner(message);
    settle?.reject(error);
    this.dispatchEvent(new CustomEvent('error', { detail: error }));
  }
}

/**
 * A trial's report as a report of the whole lab, without a best genome, since each trial starts anew.
 * @param {SearchReport} report @param {Trial} trial
 */
function labReport(report, { finished, total }) {
  const evaluations = finished * report.budget + report.evaluations;
  const budget = total * report.budget;
  const secondsLeft = report.rate > 0 ? (budget - evaluations) / report.rate : 0;
  return { ...report, evaluations, budget, secondsLeft, bestFitness: -Infinity };
}

/** @param {Trial} trial @param {boolean} paused */
function trialWords({ words, finished, total }, paused) {
  return paused ? tr('Paused: lab: trial {1} of {2}, {3}', finished + 1, total, words) : tr('Lab: trial {1} of {2}, {3}', finished + 1, total, words);
}

/** @param {App} app */
function wordsOf(app) {
  const { task, search } = app.document();
  const styled = Object.values(task?.weights ?? {}).some((weight) => weight !== 0);
  const algorithm = search?.algorithm ?? 'sphc';
  const name = () => tr(algorithms.find(({ name: known }) => known === algorithm)?.label ?? algorithm);
  return {
    doing: (/** @type {boolean} */ paused) => (paused ? tr('Paused: searching with {1}', name()) : tr('Searching with {1}', name())),
    unit: styled ? '' : ' m', // every goal is a length if no style term is added
  };
}
