// SPDX-License-Identifier: MIT
// How a lesson or an assignment sets up the page: the shown panels, the locks, the goal and the task. They come from the address
// (?panels=style,search&lock=figure&goal=distance>=8), as do whether Live is on (?live=off) and whether a learning system is around the page (?scorm), or from a script. docs/embedding.md documents them.
import { banner, element, setText } from '../browser/dom.js';
import { dialogs } from '../dialogs/dialogs.js';
import { sentence } from '../share/address.js';
import { followLanguage, tr } from '../languages/language.js';

/** @typedef {import('../app/app.js').App} App */
/** Options that are left out stay as they are. task: '': none. @typedef {{panels?: string, lock?: string, goal?: string, live?: string, task?: string}} ArrangementOptions */

const NAMES = /** @type {const} */ (['panels', 'lock', 'goal', 'live', 'task']);
const MOST_TASK = 500; // characters

/** The example that the address asks for: ?open=there-and-back */
export const namedExample = () => new URLSearchParams(location.search).get('open') ?? '';

/** Whether the address sets up the page, as lessons do. */
export function arranged() {
  const address = new URLSearchParams(location.search);
  return NAMES.some((name) => name !== 'live' && address.has(name));
}

/**
 * Whether the address asks for the viewer (?view) or the workbench (?edit), whatever link it holds.
 * @returns {'view' | 'edit' | '' | null}  '': for neither; null: both, or one with a value
 */
export function askedMode() {
  const address = new URLSearchParams(location.search);
  const asked = /** @type {const} */ (['view', 'edit']).filter((mode) => address.has(mode));
  if (!asked.length) return '';
  return asked.length === 1 && !address.get(asked[0]) ? asked[0] : null;
}

export class Arrangement {
  /** @type {import('./goal.js').GoalBar | null} */
  #bar = null;
  #pending = Promise.resolve();
  /** To a learning system. @type {import('./assignment_report.js').AssignmentReport | null} */
  #report = null;

  /** @param {App} app @param {import('./api.js').Gaitsmith} gaitsmith  dispatches the 'goal' events */
  constructor(app, gaitsmith) {
    this.app = app;
    this.gaitsmith = gaitsmith;
    gaitsmith.addEventListener('changed', () => this.#bar?.update());
    followLanguage(() => this.#bar?.update());
  }

  /** Applies the options in the address. Invalid options are reported together and do not stop the others. */
  async begin() {
    const address = new URLSearchParams(location.search);
    /** @type {string[]} */
    const faults = [];
    for (const name of NAMES) {
      const value = address.get(name);
      if (value !== null) await this.set({ [name]: value }).catch(({ message }) => { faults.push(sentence(message)); });
    }
    const example = namedExample();
    if (example && !this.app.commands().some(({ id }) => id === `example/${example}`)
      && !Object.hasOwn((await import('../share/examples.js')).EXAMPLES, example)) {
      faults.push(tr('There is no example “{1}”.', example));
    }
    if (address.has('scorm')) await this.#startReport(address.get('goal') ?? '').catch(({ message }) => { faults.push(sentence(message)); });
    if (askedMode() === null) faults.push(tr('“view” and “edit” take no value, and exclude each other.'));
    if (faults.length) banner(tr('The address of this page has a mistake: {1}', faults.join(' ')));
  }

  /** @param {ArrangementOptions} options @returns {Promise<void>} rejected with a sentence, and nothing changed, if they are invalid */
  set(options) {
    const done = this.#pending.then(() => this.#set(options)); // one at a time
    this.#pending = done.catch(() => {});
    return done;
  }

  /** @param {ArrangementOptions} options */
  async #set({ goal, task, ...shown }) {
    if (task !== undefined && (typeof task !== 'string' || task.length > MOST_TASK)) throw new Error(tr('task: at most {1} characters', MOST_TASK));
    const bar = goal ? new (await import('./goal.js')).GoalBar(this.app, this.gaitsmith, goal) : null; // throws
    const fault = this.app.arrange(shown);
    if (fault) throw new Error(fault);
    if (task !== undefined) this.#showTask(task);
    if (goal === undefined) return;
    this.#bar?.close();
    this.#bar = bar;
    bar?.show();
  }

  /** For an assignment in a SCORM package. @param {string} goal */
  async #startReport(goal) {
    if (goal === '') throw new Error(tr('“scorm” needs a goal, because it reports when the goal is reached'));
    const { AssignmentReport } = await import('./assignment_report.js');
    const report = new AssignmentReport(this.app, this.gaitsmith, goal);
    this.#showTask(element('task-text').textContent ?? '');
    element('task').hidden = false;
    this.#report = report;
    report.begin();
  }

  /** @param {string} task */
  #showTask(task) {
    element('task').hidden = task === '';
    setText(element('task-text'), task);
    element('task-hand-in', HTMLButtonElement).onclick = async () => {
      await dialogs();
      (await import('./hand_in.js')).openHandIn(() => this.gaitsmith.link(), this.#report);
    };
  }
}
