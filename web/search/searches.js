// SPDX-License-Identifier: MIT
// Searches as the page knows them: the application asks for one, workers run it, and application, status line and
// listeners hear how far it is.
import { NO_REPORT } from '../app/no_report.js';
import { compiledEngine, createWorker, hasWorkers } from './compiled_engine.js';
import { banner } from '../browser/dom.js';
import { algorithms } from '../catalogue/catalogue.js';
import { tr, trSentence } from '../languages/language.js';

/** @typedef {import('../app/app.js').App} App */
/** @typedef {import('./messages.js').SearchReport} SearchReport */

// Each holds some memory, and a search is not certain.
const MOST_STANDING_BY = 4;

/** @typedef {import('./search_client.js').SearchClient} SearchClient */
/** @typedef {import('../access/status_line.js').SearchWords} SearchWords */
/** A trial of the lab: how it is told, and how many come before and are in all. @typedef {{words: string, finished: number, total: number}} Trial */
/** @typedef {{resolve: (report: SearchReport) => void, reject: (error: Error) => void}} End */

/** Tells its listeners 'progress' (a SearchReport), 'done' ({report, queued}: whether it came from the queue) and 'error' (an Error). */
export class Searches extends EventTarget {
  /** @type {Promise<SearchClient> | null} */
  #prepared = null;
  /** @type {SearchClient | null} */
  #client = null;
  #run = 0; // counts starts: what a slow start finds out may be outdated
  /** As core stores it. @type {Uint8Array} */
  #curve = new Uint8Array(0);
  /** @type {SearchWords} */
  #words = { doing: () => '', unit: '', workers: 1 };
  /** What runs is a trial of the lab. @type {Trial | null} */
  #trial = null;
  /** What runs came from the queue. */
  #queued = false;
  #labOver = false; // its last trial may still report
  /** What to do once the workers exist. @type {('pause' | 'resume' | 'stop')[]} */
  #later = [];
  searching = false;
  /** How the search started last ends: done, stopped, or replaced by another. @type {Promise<SearchReport>} */
  ended = Promise.resolve(NO_REPORT);
  /** @type {End | null} */
  #end = null;

  /** @param {App} app @param {import('../access/status_line.js').StatusLine} statusLine */
  constructor(app, statusLine) {
    super();
    this.app = app;
    this.statusLine = statusLine;
  }

  /** What only a search needs: the engine, compiled once for all workers, and the client that looks after them. */
  #prepare() {
    this.#prepared ??= Promise.all([compiledEngine(), import('./search_client.js')]).then(([engine, { SearchClient }]) => new SearchClient({
      engine,
      createWorker,
      listener: {
        progress: (report) => this.#hear(report),
        incident: (sentence) => this.statusLine.say(sentence),
        failed: (error) => this.#fail(error),
      },
    }));
    this.#prepared.catch(() => { this.#prepared = null; }); // try again next time
    return this.#prepared;
  }

  /** Loads all that the first search will need, while nothing else is to be done. A failure is that search's to tell. */
  async standBy() {
    const client = await this.#prepare().catch(() => null);
    if (!this.searching && hasWorkers) client?.standBy(Math.min(navigator.hardwareConcurrency || 2, MOST_STANDING_BY));
  }

  /** Of the document on the page, which changes as it improves. */
  get improving() { return this.searching && this.#trial === null && !this.#queued; }

  /**
   * @param {Uint8Array} document @param {number} workers
   * @param {{trial?: Trial, queued?: string}} [as]  of the lab; or of the queue, and what it is
   */
  async start(document, workers, { trial, queued } = {}) {
    const run = ++this.#run;
    this.#end?.resolve(this.#client?.drop() ?? { ...NO_REPORT, state: 'stopped' });
    this.ended = new Promise((resolve, reject) => { this.#end = { resolve, reject }; });
    this.ended.catch(() => {}); // the banner tells, even if nobody waits
    this.searching = true;
    this.#later = [];
    this.#curve = new Uint8Array(0);
    this.#trial = trial ?? null;
    this.#queued = queued !== undefined;
    this.#labOver = false;
    if (trial) {
      this.#words = { doing: (paused) => trialWords(trial, paused), unit: '', workers };
      if (trial.finished === 0) this.statusLine.say('');
    } else {
      this.#words = queued === undefined ? { ...wordsOf(this.app), workers }
        : { doing: (paused) => (paused ? tr('Paused: queue: {1}', queued) : tr('Queue: {1}', queued)), unit: '', workers };
      this.statusLine.say('');
      this.statusLine.show(NO_REPORT, this.#words);
    }
    try {
      const client = await this.#prepare();
      if (run !== this.#run) return;
      this.#client = client;
      if (!hasWorkers) this.statusLine.say(tr('This frame has no workers: the search runs in the page itself, and takes longer.'));
      this.#client.start(document, hasWorkers ? workers : 1);
      for (const wish of this.#later.splice(0)) this.#client[wish]();
    } catch (error) {
      if (run === this.#run) this.#fail(error instanceof Error ? error : new Error(String(error)));
    }
  }

  /** The application wants no more trials. */
  labEnded() {
    this.#labOver = true;
    this.statusLine.clear();
  }

  /** The application takes no more reports. @param {Error} error */
  abandon(error) {
    this.#run++;
    this.#client?.close();
    this.searching = false;
    this.#end?.reject(error);
    this.#end = null;
    this.statusLine.clear();
  }

  pause() { this.#wish('pause'); }
  resume() { this.#wish('resume'); }
  stop() { this.#wish('stop'); }

  /** @param {'pause' | 'resume' | 'stop'} wish */
  #wish(wish) {
    if (this.#client?.searching) this.#client[wish]();
    else if (this.searching) this.#later.push(wish);
  }

  /** @param {SearchReport} report */
  #hear(report) {
    const ended = report.state === 'done' || report.state === 'stopped';
    if (report.curve) this.#curve = report.curve;
    const trial = this.#trial;
    const words = this.#words;
    const queued = this.#queued;
    const end = this.#end;
    if (ended) {
      this.searching = false;
      this.#end = null;
    }
    try {
      this.app.searchProgress({ ...report, curve: this.#curve }); // at the end of one the next of lab or queue begins in here
    } catch (error) {
      this.#client?.drop();
      this.#end = end;
      return this.#fail(error instanceof Error ? error : new Error(String(error)));
    }
    if (trial) {
      if (!ended && !this.#labOver) this.statusLine.show(ofAll(report, trial), words);
      return;
    }
    if (!(ended && this.searching)) this.statusLine.show(report, words);
    this.dispatchEvent(new CustomEvent('progress', { detail: report }));
    if (!ended) return;
    end?.resolve(report);
    this.dispatchEvent(new CustomEvent('done', { detail: { report, queued } }));
  }

  /** @param {Error} error */
  #fail(error) {
    const end = this.#end;
    const fault = trSentence(error.message);
    const told = this.#queued ? tr('The search failed: {1}. What it had found is kept; the queue goes on.', fault)
      : tr('The search failed: {1}. What it had found is kept; you can start it again.', fault);
    this.searching = false;
    this.#end = null;
    this.app.searchFailed(); // the next of the queue may begin in here
    if (!this.searching) this.statusLine.clear();
    banner(told);
    end?.reject(error);
    this.dispatchEvent(new CustomEvent('error', { detail: error }));
  }
}

/**
 * A trial's report as one of the whole lab. Its best is nobody's: the next trial begins anew.
 * @param {SearchReport} report @param {Trial} trial
 */
function ofAll(report, { finished, total }) {
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
    unit: styled ? '' : ' m', // every goal alone is a length
  };
}
