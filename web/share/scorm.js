// SPDX-License-Identifier: MIT
// Reports to a learning system, by SCORM 1.2 or 2004 (4th edition): whether the goals are reached, a score, and the work
// as it is, which the system gives back at the next visit.

/**
 * What is reported. score: 0 to 100; state: at most MOST_STATE characters are kept
 * @typedef {{reached: boolean, score: number, state: string}} Report
 */
/** Functions of a learning system. They take and return strings, 'true' or 'false' where they succeed or fail. @typedef {Record<string, (...values: string[]) => string>} Api */

const DEPTH = 20; // of frames; a loop among them would have no end
/** Characters of suspend data. */
const MOST_STATE = { 1.2: 4096, 2004: 64000 };
const NAMES = /** @type {const} */ ({
  1.2: { begin: 'LMSInitialize', get: 'LMSGetValue', set: 'LMSSetValue', save: 'LMSCommit', end: 'LMSFinish', fault: 'LMSGetLastError', words: 'LMSGetErrorString' },
  2004: { begin: 'Initialize', get: 'GetValue', set: 'SetValue', save: 'Commit', end: 'Terminate', fault: 'GetLastError', words: 'GetErrorString' },
});

/** The learning system that shows this page: in a frame above it, or in the window that opened it. @param {Window} [start] */
export function findApi(start = window) {
  for (let chain of [start.parent === start ? null : start.parent, start.opener, start.top?.opener]) {
    for (let depth = 0; chain && depth < DEPTH; depth++) {
      try {
        const { API_1484_11: newer, API: older } = /** @type {any} */ (chain);
        if (newer) return new Learning('2004', newer);
        if (older) return new Learning('1.2', older);
        chain = chain.parent === chain ? null : chain.parent;
      } catch {
        break; // another origin, which no learning system is here
      }
    }
  }
  return null;
}

export class Learning {
  #names;
  #began = Date.now();
  #open = false;

  /** @param {'1.2' | '2004'} version @param {Api} api */
  constructor(version, api) {
    this.version = version;
    this.api = api;
    this.#names = NAMES[version];
  }

  /** Begins a visit. @returns {string} the state of the last one, '' if there is none. Throws what the system says. */
  begin() {
    this.#call('begin', '');
    this.#open = true;
    const kept = this.#get('cmi.suspend_data');
    if (this.version === '1.2') {
      if (['', 'not attempted', 'unknown'].includes(this.#get('cmi.core.lesson_status'))) this.#set('cmi.core.lesson_status', 'incomplete');
    } else if (this.#get('cmi.completion_status') !== 'completed') this.#set('cmi.completion_status', 'incomplete');
    addEventListener('pagehide', () => this.end());
    return kept;
  }

  /** Whether this state fits. @param {string} state */
  holds(state) { return state.length <= MOST_STATE[this.version]; }

  /** Reports how far the learner is. A lesson that was passed stays passed. Throws what the system says. @param {Report} report */
  report({ reached, score, state }) {
    if (!this.#open) return;
    if (!this.holds(state)) throw new Error(`${state.length} characters, and the learning system keeps ${MOST_STATE[this.version]}`);
    this.#set('cmi.suspend_data', state);
    if (this.version === '1.2') {
      this.#set('cmi.core.score.min', '0');
      this.#set('cmi.core.score.max', '100');
      this.#set('cmi.core.score.raw', String(Math.round(score)));
      if (reached) this.#set('cmi.core.lesson_status', 'passed');
    } else {
      this.#set('cmi.score.min', '0');
      this.#set('cmi.score.max', '100');
      this.#set('cmi.score.raw', String(Math.round(score)));
      this.#set('cmi.score.scaled', String(Math.round(score) / 100));
      if (reached) {
        this.#set('cmi.completion_status', 'completed');
        this.#set('cmi.success_status', 'passed');
      }
    }
    this.#call('save', '');
  }

  /** Ends the visit; the state is kept for the next one. */
  end() {
    if (!this.#open) return;
    this.#open = false;
    const seconds = Math.round((Date.now() - this.#began) / 1000);
    try {
      const clock = (/** @type {number} */ number) => String(number).padStart(2, '0');
      if (this.version === '1.2') {
        this.#set('cmi.core.session_time', `${String(Math.floor(seconds / 3600)).padStart(4, '0')}:${clock(Math.floor(seconds / 60) % 60)}:${clock(seconds % 60)}`);
        this.#set('cmi.core.exit', 'suspend');
      } else {
        this.#set('cmi.session_time', `PT${seconds}S`);
        this.#set('cmi.exit', 'suspend');
      }
      this.#call('save', '');
      this.#call('end', '');
    } catch {
      // The page is being left: no one could read why.
    }
  }

  /** @param {string} element */
  #get(element) {
    const value = this.#raw('get', element);
    return typeof value === 'string' ? value : String(value ?? '');
  }

  /** @param {string} element @param {string} value */
  #set(element, value) { this.#call('set', element, value); }

  /** @param {keyof typeof NAMES['1.2']} name @param {string[]} values */
  #call(name, ...values) {
    if (String(this.#raw(name, ...values)) === 'true') return;
    const fault = String(this.#raw('fault'));
    if (fault === '0') return; // some systems return nothing after a success
    throw new Error(`${this.#names[name]} ${values[0] ?? ''}: ${this.#raw('words', fault) || `error ${fault}`}`);
  }

  /** @param {keyof typeof NAMES['1.2']} name @param {string[]} values */
  #raw(name, ...values) { return this.api[this.#names[name]](...values); }
}
