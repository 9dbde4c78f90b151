// SPDX-License-Identifier: MIT
// The page's side of the lab. The application plans the trials and requests them one after another, the search workers
// run them, and a script that started the lab receives the rows.

/** @typedef {import('../app/app.js').App} App */
/** @typedef {import('../app/app.js').LabOptions} LabOptions */

/** A point of a trial's curve. @typedef {{problem: string, search: string, seed: number, evaluation: number, best: number}} LabRow */
/**
 * The result of a run. If the run was stopped, its rows so far. csv: in the format of `gaitsmith compare --curves`.
 * @typedef {{state: 'done' | 'stopped', rows: LabRow[], csv: string}} LabResult
 */

export class Lab {
  /** @type {{resolve: (result: LabResult) => void, reject: (error: Error) => void} | null} */
  #end = null;

  /** @param {App} app */
  constructor(app) {
    this.app = app;
  }

  /**
   * Runs the lab for the current document, after stopping a running lab.
   * @param {LabOptions} options
   * @returns {Promise<LabResult>}
   */
  run(options) {
    const fault = this.app.lab(options); // ends a running lab
    if (fault) return Promise.reject(new Error(fault));
    return new Promise((resolve, reject) => { this.#end = { resolve, reject }; });
  }

  /** Called by the application when the run is over. */
  ended() {
    const end = this.#end;
    this.#end = null;
    if (!end) return;
    const state = this.app.labState();
    if (state === 'failed') return end.reject(new Error('the lab failed'));
    const csv = this.app.labCsv();
    end.resolve({ state: state === 'done' ? 'done' : 'stopped', rows: rowsOf(csv), csv });
  }
}

/** @param {string} csv @returns {LabRow[]} */
function rowsOf(csv) {
  return csv.trimEnd().split('\n').slice(2).map((line) => {
    const [problem, search, seed, evaluation, best] = line.split(',');
    return { problem, search, seed: Number(seed), evaluation: Number(evaluation), best: Number(best) };
  });
}
