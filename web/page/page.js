// SPDX-License-Identifier: MIT
// Starts the application in the canvas and connects it with address, workers, header and footer.
import { Address } from '../share/address.js';
import { App } from '../app/app.js';
import { Arrangement, arranged, askedMode, namedExample } from './arrangement.js';
import { Autosave } from '../storage/autosave.js';
import { Commands } from './commands.js';
import { Gaitsmith } from './api.js';
import { Lab } from './lab.js';
import { Mirror } from '../access/mirror.js';
import { Rest } from '../app/rest.js';
import { Searches } from '../search/searches.js';
import { StatusLine } from '../access/status_line.js';
import { banner, element, offerFile, onClick, setText } from '../browser/dom.js';
import { HistoryButtons, followViewer, startHeader } from './header.js';
import { KeptResults } from '../storage/kept_results.js';
import { compiledEngine, createWorker } from '../search/compiled_engine.js';
import { compiledModule } from '../browser/compiled_module.js';
import { dialogs } from '../dialogs/dialogs.js';
import { guardKeys } from '../access/keys.js';
import { followLanguage, tr, trLater, trSentence } from '../languages/language.js';
import { LANGUAGES, chooseLanguage, startLanguage } from '../languages/language_choice.js';
import { startPageWords } from '../languages/page_words.js';
import { startSharing } from '../share/sharing.js';
import { chooseTheme, followTheme, nextTheme, startTheme, THEMES } from './theme.js';

const HINT_AFTER_MS = 5000;
const REST_MS = 1000;
const canvas = element('canvas', HTMLCanvasElement);
const embedded = window.parent !== window;

const gaitsmith = new Gaitsmith();
window.gaitsmith = gaitsmith;
/** @type {Commands | null} */
let commands = null;
startPageWords();
startTheme();
const statusLine = new StatusLine();
const languageReady = startLanguage((sentence) => statusLine.say(sentence));
guardKeys((event) => commands !== null && (commands.mirror.keys.intercept(event) || commands.handle(event)));
startHeader();
start().catch((error) => {
  element('loading').hidden = true;
  const reason = error instanceof Error ? error.message : String(error);
  banner(tr('Gaitsmith cannot start here: {1}. Reload the page, or try another browser.', trSentence(reason)), { reload: true });
  gaitsmith.cannotRun(error instanceof Error ? error : new Error(reason));
});

async function start() {
  setTimeout(() => { element('loading-hint').hidden = false; }, HINT_AFTER_MS);
  /** @type {{app: App, searches: Searches, lab: Lab, arrangement: Arrangement, address: Address, autosave: Autosave, results: KeptResults, buttons: HistoryButtons, commands: Commands, canvas: HTMLCanvasElement} | null} */
  let parts = null;

  /** @type {Promise<import('../search/transition_maps.js').TransitionMaps> | null} */
  let transitions = null;
  const loadTransitionMaps = async () => {
    const { TransitionMaps } = await import('../search/transition_maps.js');
    return new TransitionMaps({
      engine: compiledEngine,
      createWorker,
      listener: { mapped: (part) => parts?.app.transitionsMapped(part), failed: (generation) => parts?.app.transitionsFailed(generation) },
    });
  };

  /** @type {Promise<import('../plan/plans.js').Plans> | null} */
  let plans = null;
  const loadPlans = async () => {
    const { Plans } = await import('../plan/plans.js');
    return new Plans({ reported: (report) => parts?.app.planReported(report), failed: (generation) => parts?.app.planFailed(generation) });
  };

  // A trap may have left the application's data inconsistent, so none of it is saved from now on.
  const crashed = (/** @type {Error} */ error) => {
    parts?.autosave.end();
    parts?.address.end();
    parts?.searches.abandon(error);
    banner(tr('Gaitsmith stopped working. Your last state is in the address: reload to continue.'), { reload: true });
  };
  addEventListener('error', ({ error }) => { if (error instanceof WebAssembly.RuntimeError) crashed(error); });
  addEventListener('unhandledrejection', ({ reason }) => { if (reason instanceof WebAssembly.RuntimeError) crashed(reason); });

  const example = location.hash.length < 2 ? namedExample() : '';
  const shipped = example ? import('../share/examples.js').then(({ firstText }) => firstText(example, statusLine), () => '') : '';
  const rest = new Rest(crashed);
  // The door does without the rest at first. Everything else may show a panel at once.
  const atTheDoor = location.hash.length < 2 && location.search === '';
  if (!atTheDoor) rest.ask();
  // Load language and application in parallel. The first frame needs both.
  const [{ default: createApp }, code, text] = await Promise.all([import('../app/app_module.js'), compiledModule(new URL('../app/app_module.wasm', import.meta.url)), shipped, languageReady]);
  const module = await createApp({
    canvas,
    instantiateWasm: (imports, receive) => {
      void WebAssembly.instantiate(code, { ...imports, placeholder: rest.placeholder }).then(async (instance) => {
        rest.begin(instance, code);
        if (!atTheDoor) await rest.load().catch(crashed);
        receive(instance, code);
      });
      return {};
    },
    onAbort: () => crashed(new Error('aborted')),
    page: {
      maxWorkers: () => navigator.hardwareConcurrency || 2,
      startSearch: (document, workers) => void parts?.searches.start(document, workers),
      startTrial: (document, workers, trial) => void parts?.searches.start(document, workers, { trial }),
      startPreview: (document, workers) => void parts?.searches.start(document, workers, { preview: true }),
      startQueued: (document, workers, title) => void parts?.searches.start(document, workers, { queued: title }),
      openDialog: (command) => commands?.runOwn(command),
      askName: (id, name, usual) => {
        void openDialog(async () => (await import('./naming.js')).askName(app, id, name, usual));
      },
      learnFrom: (id, more) => {
        void openDialog(async () => (await import('../breed/judge.js')).learnFrom({ app, changed: gaitsmith }, id, more), trLater('Breeding could not be loaded.'));
      },
      storeFound: (id, text) => parts?.results.store(id, text),
      labEnded: () => {
        parts?.searches.labEnded();
        parts?.lab.ended();
      },
      saveText: (name, text) => offerFile(name, text, 'text/csv'),
      pauseSearch: () => parts?.searches.pause(),
      resumeSearch: () => parts?.searches.resume(),
      stopSearch: () => parts?.searches.stop(),
      startTransitionMap: (document, generation) => {
        transitions ??= loadTransitionMaps();
        void transitions.then((maps) => maps.start(document, generation), () => {
          transitions = null;
          parts?.app.transitionsFailed(generation);
        });
      },
      stopTransitionMap: () => void transitions?.then((maps) => maps.stop(), () => {}),
      startPlan: (document, generation) => {
        plans ??= loadPlans();
        void plans.then((each) => each.start(document, generation), () => {
          plans = null;
          parts?.app.planFailed(generation);
        });
      },
      stopPlan: () => void plans?.then((each) => each.stop(), () => {}),
      status: (sentence) => statusLine.say(sentence),
      documentChanged: (title) => {
        showTitle(title);
        gaitsmith.documentChanged(title);
        if (parts) followViewer(parts);
        parts?.address.changed();
        parts?.autosave.changed();
        parts?.buttons.update();
      },
      firstFrame: () => {
        element('loading').hidden = true;
        performance.mark('gaitsmith-first-frame');
        // The first frame does not need these, so they must not delay it.
        if (atTheDoor) rest.load().catch(crashed);
        if (parts) parts.results.restore(parts.app);
        setTimeout(() => {
          void parts?.searches.standBy();
          Promise.all([dialogs(), import('./palette.js')]).catch(() => {}); // the next use tries again
        }, REST_MS);
        gaitsmith.firstFrame();
      },
      leaveCanvas: () => canvas.blur(), // not for the Tab key, which MirrorKeys handles
    },
  });

  const app = new App(module);
  app.lendTypeface();
  if (!app.running()) throw new Error(trLater('this browser has no WebGL 2'));
  const searches = new Searches(app, statusLine);
  const address = new Address(app, () => searches.improving);
  followTheme((look) => app.setTheme(look));
  followLanguage((table) => {
    app.setLanguage(table);
    showTitle(app.title());
  });
  const autosave = new Autosave(app, address, statusLine);
  autosave.begin({ example, text, arranged: arranged(), mode: askedMode() });
  showTitle(app.title());
  commands = new Commands(app, new Mirror(app, canvas));
  parts = { app, searches, lab: new Lab(app), arrangement: new Arrangement(app, gaitsmith), address, autosave, results: new KeptResults(statusLine), buttons: new HistoryButtons(app), commands, canvas };
  followViewer(parts);
  gaitsmith.begin(parts);
  void parts.arrangement.begin();
  gaitsmith.fps = Number(new URLSearchParams(location.search).get('fps'));
  searches.addEventListener('done', () => {
    address.changed();
    autosave.save();
  });
  startSharing(app, address, statusLine);
  const firstMotion = atTheDoor ? new Promise((resolve) => { searches.addEventListener('done', resolve, { once: true }); }) : gaitsmith.ready;
  // The first motion needs neither.
  void gaitsmith.ready.then(() => import('../storage/offline.js')).then(({ startOffline }) => startOffline({
    leave: () => {
      address.write();
      autosave.save();
    },
    firstMotion,
    busy: () => searches.searching,
    say: (sentence) => statusLine.say(sentence),
  }), () => {});
  void gaitsmith.ready.then(() => import('../access/narrator.js')).then(({ Narrator }) => { new Narrator(app); }, () => {});
  if (matchMedia('(prefers-reduced-motion: reduce)').matches) {
    app.setCalm(true);
    app.play(false);
  }
  if (embedded) {
    document.documentElement.dataset.embedded = '';
    const home = element('home', HTMLAnchorElement);
    home.target = '_blank';
    home.ariaLabel = home.title = tr('Open this in a tab of its own');
    (await import('../share/embedding.js')).startEmbedding(gaitsmith);
  }
  addCommands(commands, address, autosave);

  // SDL cancels every touch. Browsers log a warning if it is too late to cancel one, as on a busy page.
  for (const type of ['touchstart', 'touchmove', 'touchend']) {
    canvas.addEventListener(type, (event) => { if (!event.cancelable) event.preventDefault = () => {}; }, { capture: true });
  }

  canvas.addEventListener('webglcontextlost', () => {
    address.write();
    autosave.save();
    banner(tr('The graphics of this page were lost. Your work is in the address: reload to continue.'), { reload: true });
  });
}

/** @param {string} title */
function showTitle(title) {
  setText(element('title'), title);
  document.title = title ? `${title} — Gaitsmith` : 'Gaitsmith';
}

let opening = false;

/**
 * Opens a dialog. Its HTML, style and code are loaded on first use.
 * @param {() => Promise<void>} open @param {string} [fault]  if that fails
 */
async function openDialog(open, fault = trLater('The dialog could not be loaded.')) {
  if (opening) return; // a second click
  opening = true;
  try {
    await dialogs();
    await open();
  } catch {
    statusLine.say(tr(fault));
  } finally {
    opening = false;
  }
}

/** Adds the page's own commands. @param {Commands} commands @param {Address} address @param {Autosave} autosave */
function addCommands(commands, address, autosave) {
  const { app } = commands;
  const click = Commands.click;
  const openPalette = () => void openDialog(() => import('./palette.js').then((palette) => palette.openPalette(commands)));
  const openHelp = () => void openDialog(() => import('./help_sheet.js').then((sheet) => sheet.openHelp(commands)));
  const openExport = () => void openDialog(() => import('../share/export.js').then((dialog) => dialog.openExport(app, statusLine)), trLater('The export could not be loaded.'));
  const openBreed = () => void openDialog(() => import('../breed/breed.js').then((breed) => breed.openBreed({ app, changed: gaitsmith })), trLater('Breeding could not be loaded.'));
  const openTour = () => void openDialog(() => import('./tour.js').then((tour) => tour.startTour(app, canvas)), trLater('The tour could not be loaded.'));
  commands.add([
    { id: 'motion/describe', group: 'Motion', title: trLater('Describe the motion'), keys: ['w'], run: click('describe') },
    { id: 'motion/breed', group: 'Motion', title: trLater('Breed: pick motions, their children come next'), keys: [], run: openBreed },
    { id: 'document/open', group: 'Document', title: trLater('Open a file or a link'), keys: ['Ctrl+o'], pressed: ['Ctrl+v'], run: click('open') },
    { id: 'document/save', group: 'Document', title: trLater('Save as a file'), keys: ['Ctrl+s'], run: click('save') },
    { id: 'document/export', group: 'Document', title: trLater('Export as picture, video or data'), keys: [], run: openExport },
    { id: 'document/share', group: 'Document', title: trLater('Share: link, QR code, embed code'), keys: [], run: click('share') },
    { id: 'document/copy-link', group: 'Document', title: trLater('Copy link'), keys: ['c'], pressed: ['Ctrl+c'], run: click('copy-link') },
    { id: 'view/theme', group: 'View', title: trLater('Next theme'), keys: ['t'], run: nextTheme },
    { id: 'help/commands', group: 'Help', title: trLater('Find a command'), keys: ['Ctrl+k'], run: openPalette },
    { id: 'help/keys', group: 'Help', title: trLater('All keys'), keys: ['?', 'F1'], run: openHelp },
    { id: 'help/tour', group: 'Help', title: trLater('Tour of the playground'), keys: [], run: openTour },
  ]);
  commands.addSource(() => autosave.commands());
  // The first motion does not need these.
  void gaitsmith.ready.then(() => import('../share/dropping.js')).then(({ startDropping }) => startDropping(app), () => {});
  void gaitsmith.ready.then(() => import('../languages/hints.js')).then(({ startHints }) => startHints(app), () => {});
  void gaitsmith.ready.then(() => import('../share/examples.js')).then(({ EXAMPLES, openExample }) => {
    commands.addSource(() => Object.entries(EXAMPLES).map(([name, title]) => (
      { id: `example/${name}`, group: 'Examples', title: tr('Open example: {1}', tr(title)), keys: [], run: () => void openExample(app, statusLine, name) })));
  }, () => {});
  commands.addSource(() => Object.entries(THEMES).map(([theme, name]) => (
    { id: `view/theme/${theme}`, group: 'View', title: tr('Theme: {1}', tr(name)), keys: [], run: () => chooseTheme(theme) })));
  commands.addSource(() => Object.entries(LANGUAGES).map(([code, name]) => (
    { id: `view/language/${code}`, group: 'View', title: tr('Language: {1}', name), keys: [], run: () => void chooseLanguage(code) })));
  onClick('new', () => app.run('document/new'));
  onClick('home', (event) => {
    if (event.ctrlKey || event.metaKey || event.shiftKey) return; // opens a new tab or window
    if (embedded) { // opens the document in a new tab, where there is more room
      element('home', HTMLAnchorElement).href = address.link().replace('#', '?edit#');
      return;
    }
    event.preventDefault();
    app.run('document/new');
  });
  onClick('open', () => void openDialog(() => import('../share/opening.js').then((dialog) => dialog.openOpen(app, statusLine))));
  onClick('share', () => void openDialog(() => import('../share/share.js').then((dialog) => dialog.openShare(app, address, (text) => import('./goal.js').then(({ goalFault }) => goalFault(text))))));
  onClick('commands', openPalette);
  onClick('keys', openHelp);
}
