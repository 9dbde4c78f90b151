// SPDX-License-Identifier: MIT
// The page: starts the application in the canvas and connects it with address, workers, header and footer.
import { Address } from './address.js';
import { App } from './app.js';
import { Controls } from './controls.js';
import { Gaitsmith } from './api.js';
import { Lab } from './lab.js';
import { Searches } from './searches.js';
import { StatusLine } from './status_line.js';
import { banner, element, offerFile, onClick, setText } from './dom.js';
import { guardKeys, leaveCanvas } from './keys.js';
import { startSharing } from './sharing.js';
import { followTheme, startTheme } from './theme.js';

const HINT_AFTER_MS = 5000;
const canvas = element('canvas', HTMLCanvasElement);

const gaitsmith = new Gaitsmith();
window.gaitsmith = gaitsmith;
startTheme();
guardKeys();
startHeader();
start().catch((error) => {
  element('loading').hidden = true;
  const reason = error instanceof Error ? error.message : String(error);
  banner(`Gaitsmith cannot start here: ${reason}. Reload the page, or try another browser.`, { reload: true });
  gaitsmith.cannotRun(error instanceof Error ? error : new Error(reason));
});

async function start() {
  setTimeout(() => { element('loading-hint').hidden = false; }, HINT_AFTER_MS);
  const statusLine = new StatusLine();
  /** @type {{app: App, searches: Searches, lab: Lab, address: Address, controls: Controls, canvas: HTMLCanvasElement} | null} */
  let parts = null;

  const { default: createApp } = await import('./app.mjs');
  const module = await createApp({
    canvas,
    onAbort: () => banner('Gaitsmith stopped working. Your last state is in the address: reload to go on.', { reload: true }),
    page: {
      maxWorkers: () => navigator.hardwareConcurrency || 2,
      startSearch: (document, workers) => {
        parts?.controls.searching(true);
        void parts?.searches.start(document, workers);
      },
      startTrial: (document, workers, trial) => {
        parts?.controls.searching(true);
        void parts?.searches.start(document, workers, trial);
      },
      labEnded: () => {
        parts?.controls.searching(false);
        parts?.searches.labEnded();
        parts?.lab.ended();
      },
      saveText: (name, text) => offerFile(name, text, 'text/csv'),
      pauseSearch: () => parts?.searches.pause(),
      resumeSearch: () => parts?.searches.resume(),
      stopSearch: () => parts?.searches.stop(),
      status: (sentence) => statusLine.say(sentence),
      documentChanged: (title) => {
        showTitle(title);
        parts?.address.changed();
        parts?.controls.documentChanged();
      },
      firstFrame: () => {
        element('loading').hidden = true;
        performance.mark('gaitsmith-first-frame');
        // Now the line is free.
        setTimeout(() => parts?.searches.standBy(), 1000);
        gaitsmith.firstFrame();
      },
      leaveCanvas: (direction) => leaveCanvas(canvas, direction),
    },
  });

  const app = new App(module);
  if (!app.running()) throw new Error('this browser has no WebGL 2');
  const searches = new Searches(app, statusLine);
  const address = new Address(app, () => searches.improving);
  followTheme((dark) => app.setTheme(dark));
  address.open();
  showTitle(app.title());
  parts = { app, searches, lab: new Lab(app), address, controls: new Controls(app), canvas };
  gaitsmith.begin(parts);
  gaitsmith.fps = Number(new URLSearchParams(location.search).get('fps'));
  for (const end of ['done', 'error']) searches.addEventListener(end, () => parts?.controls.searching(false));
  searches.addEventListener('done', () => address.changed());
  startSharing(app, address);
  element('undo').hidden = false;
  statusLine.welcome('Press Synthesize to search for a better motion');
  if (matchMedia('(prefers-reduced-motion: reduce)').matches) app.play(false);

  canvas.addEventListener('webglcontextlost', () => {
    address.write();
    banner('The graphics of this page were lost. Your work is in the address: reload to go on.', { reload: true });
  });
}

/** @param {string} title */
function showTitle(title) {
  setText(element('title'), title);
  document.title = title ? `${title} — Gaitsmith` : 'Gaitsmith';
}

function startHeader() {
  onClick('banner-close', () => banner(''));
  onClick('banner-reload', () => location.reload());
  const more = element('more');
  const menu = element('menu');
  const show = (/** @type {boolean} */ shown) => {
    menu.classList.toggle('shown', shown);
    more.setAttribute('aria-expanded', String(shown));
  };
  more.addEventListener('click', (event) => {
    event.stopPropagation();
    show(!menu.classList.contains('shown'));
  });
  for (const type of ['click', 'pointerdown']) {
    document.addEventListener(type, (event) => {
      if (type === 'click' || !(event.target instanceof Node && (menu.contains(event.target) || more.contains(event.target)))) show(false);
    });
  }
  menu.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape') return;
    show(false);
    more.focus();
  });
}
