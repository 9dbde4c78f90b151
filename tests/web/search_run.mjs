// SPDX-License-Identifier: MIT
// Runs complete searches with the page's client, under Node, for the tests.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { after } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { NodeWorker } from './web_worker.mjs';

const HERE = fileURLToPath(new URL('.', import.meta.url));
const WEB = process.env.GAITSMITH_WEB ?? join(HERE, '../../build/wasm/web');

/** @typedef {import('../../web/search/messages.js').SearchReport} SearchReport */
/** @typedef {import('../../web/search/search_client.js').SearchClient} SearchClient */
/** @typedef {{reports: SearchReport[], incidents: string[], last: SearchReport, genome: Uint16Array}} Run */

/** A script of the page. @param {string} name @returns {Promise<any>} */
export const fromWeb = (name) => import(pathToFileURL(join(WEB, name)).href);

export const compiled = await WebAssembly.compile(await readFile(join(WEB, 'search/engine_module.wasm')));
/** @type {import('../../web/search/engine.js').Engine} */
export const engine = await (await fromWeb('search/engine.js')).Engine.load(compiled);
const { SearchClient: Client } = await fromWeb('search/search_client.js');
const figure = JSON.parse(await readFile(join(HERE, '../../examples/figures/mr-star-man.json'), 'utf8'));

export const newWorker = () => new NodeWorker(join(WEB, 'search/worker.js'));

/** @param {object} settings  of the search @param {object} [others]  of the document */
export function problem(settings, others = {}) {
  return engine.documentFromText(JSON.stringify({ figure, ...others, search: { seed: 7, evaluations: 3000, ...settings } }));
}

/**
 * A client with worker threads, or other replacements for workers.
 * @param {import('../../web/search/search_client.js').SearchListener} listener
 * @param {() => any} [createWorker]
 * @param {WebAssembly.Module} [module]
 * @returns {SearchClient}
 */
export function newClient(listener, createWorker = newWorker, module = compiled) {
  const client = new Client({ engine: module, createWorker, listener });
  after(() => client.close());
  return client;
}

/**
 * Runs a search to its end.
 * @template [W=NodeWorker]
 * @param {Uint8Array} document
 * @param {number} workers
 * @param {(client: SearchClient, report: SearchReport, team: W[]) => void} [meddle]  called at every report
 * @param {{module?: WebAssembly.Module, createWorker?: () => W}} [options]
 * @returns {Promise<Run>}
 */
export function run(document, workers, meddle, { module = compiled, createWorker = /** @type {() => any} */ (newWorker) } = {}) {
  return new Promise((resolve, reject) => {
    /** @type {W[]} */
    const team = [];
    /** @type {SearchReport[]} */
    const reports = [];
    /** @type {string[]} */
    const incidents = [];
    const client = newClient({
      progress: (report) => {
        reports.push(report);
        if (report.state === 'done' || report.state === 'stopped') {
          resolve({ reports, incidents, last: report, genome: report.bestGenome ?? new Uint16Array() });
        } else {
          meddle?.(client, report, team);
        }
      },
      incident: (sentence) => incidents.push(sentence),
      failed: reject,
    }, () => team[team.push(createWorker()) - 1], module);
    client.start(document, workers);
  });
}

/** @param {Run} a @param {Run} b */
export function assertSame(a, b) {
  assert.ok(a.genome.length > 0);
  assert.deepEqual(a.genome, b.genome);
  assert.equal(a.last.bestFitness, b.last.bestFitness);
  assert.equal(a.last.evaluations, b.last.evaluations);
  assert.deepEqual(a.last.curve, b.last.curve);
}
