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
import { Naming } from './naming.js';
import { Narrator } from '../access/narrator.js';
import { Searches } from '../search/searches.js';
import { StatusLine } from '../access/status_line.js';
import { TransitionMaps } from '../search/transition_maps.js';
import { banner, element, offerFile, onClick, setText } from '../browser/dom.js';
import { HistoryButtons, followViewer, startHeader } from './header.js';
import { KeptResults } from '../storage/kept_results.js';
import { compiledEngine, createWorker } from '../search/compiled_engine.js';
import { compiledModule } from '../browser/compiled_module.js';
import { guardKeys } from '../access/keys.js';
import { followLanguage, tr, trLater, trSentence } from '../languages/language.js';
import { LANGUAGES, chooseLanguage, startLanguage } from '../languages/language_choice.js';
import { startPageWords } from '../languages/page_words.js';
import { startOffline } from '../storage/offline.js';
import { startSharing } from '../share/sharing.js';
import { chooseTheme, followTheme, nextTheme, startTheme, THEMES } from './theme.js';

const HINT_AFTER_MS = 5000;
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
  /** @type {{app: App, searches: Searches, transitions: TransitionMaps, lab: Lab, arrangement: Arrangement, address: Address, autosave: Autosave, results: KeptResults, naming: Naming, buttons: HistoryButtons, commands: Commands, canvas: HTMLCanvasElement} | null} */
  let parts = null;

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
  // Load language and application in parallel. The first frame needs both.
  const [{ default: createApp }, code, text] = await Promise.all([import('../app/app_module.js'), compiledModule(new URL('../app/app_module.wasm', import.meta.url)), shipped, languageReady]);
  const module = await createApp({
    canvas,
    instantiateWasm: (imports, receive) => {
      void WebAssembly.instantiate(code, imports).then((instance) => receive(instance, code));
      return {};
    },
    onAbort: () => crashed(new Error('aborted')),
    page: {
      maxWorkers: () => navigator.hardwareConcurrency || 2,
      startSearch: (document, workers) => void parts?.searches.start(document, workers),
      startTrial: (document, workers, trial) => void parts?.searches.start(document, workers, { trial }),
      startPreview: (document, workers) => void parts?.searches.start(document, workers, { preview: true }),
      startQueued: (document, workers, title) => void parts?.searches.start(document, workers, { queued: title }),
      askName: (id, name, usual) => parts?.naming.ask(id, name, usual),
      storeFound: (id, text) => parts?.results.store(id, text),
      labEnded: () => {
        parts?.searches.labEnded();
        parts?.lab.ended();
      },
      saveText: (name, text) => offerFile(name, text, 'text/csv'),
      pauseSearch: () => parts?.searches.pause(),
      resumeSearch: () => parts?.searches.resume(),
      stopSearch: () => parts?.searches.stop(),
      startTransitionMap: (document, generation) => void parts?.transitions.start(document, generation),
      stopTransitionMap: () => parts?.transitions.stop(),
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
        if (parts) parts.results.restore(parts.app);
        setTimeout(() => parts?.searches.standBy(), 1000);
        gaitsmith.firstFrame();
      },
      leaveCanvas: () => canvas.blur(), // not for the Tab key, which MirrorKeys handles
    },
  });

  const app = new App(module);
  app.lendTypeface();
  if (!app.running()) throw new Error(trLater('this browser has no WebGL 2'));
  const searches = new Searches(app, statusLine);
  const transitions = new TransitionMaps({
    engine: compiledEngine,
    createWorker,
    listener: { mapped: (part) => app.transitionsMapped(part), failed: (generation) => app.transitionsFailed(generation) },
  });
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
  parts = { app, searches, transitions, lab: new Lab(app), arrangement: new Arrangement(app, gaitsmith), address, autosave, results: new KeptResults(statusLine), naming: new Naming(app), buttons: new HistoryButtons(app), commands, canvas };
  followViewer(parts);
  gaitsmith.begin(parts);
  void parts.arrangement.begin();
  gaitsmith.fps = Number(new URLSearchParams(location.search).get('fps'));
  searches.addEventListener('done', () => {
    address.changed();
    autosave.save();
  });
  startSharing(app, address, statusLine);
  void gaitsmith.ready.then(() => startOffline({
    leave: () => {
      address.write();
      autosave.save();
    },
  }));
  if (matchMedia('(prefers-reduced-motion: reduce)').matches) {
    app.setCalm(true);
    app.play(false);
  }
  new Narrator(app);
  if (embedded) {
    document.documentElement.dataset.embedded = '';
    const home = element('home', HTMLAnchorElement);
    home.target = '_blank';
    home.ariaLabel = home.title = tr('Open this in a tab of its own');
    (await import('../share/embedding.js')).startEmbedding(gaitsmith);
  }
  addCommands(commands, { address, autosave, dialogs: loadLater(commands) });

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

/** The dialog and the exporters are loaded on first use. @param {App} app @param {StatusLine} statusLine */
async function openExport(app, statusLine) {
  try {
    (await import('../share/export.js')).openExport(app, statusLine);
  } catch {
    statusLine.say(tr('The export could not be loaded.'));
  }
}

/** @param {App} app @param {StatusLine} statusLine */
async function openTour(app, statusLine) {
  try {
    (await import('./tour.js')).startTour(app, canvas);
  } catch {
    statusLine.say(tr('The tour could not be loaded.'));
  }
}

/** @param {App} app @param {Address} address @param {StatusLine} statusLine */
async function openShare(app, address, statusLine) {
  try {
    (await import('../share/share.js')).openShare(app, address);
  } catch {
    statusLine.say(tr('The dialog could not be loaded.'));
  }
}

/** @typedef {{palette: import('./palette.js').Palette, help: import('./help_sheet.js').HelpSheet}} Dialogs */
/** What the first motion does not need. @param {Commands} commands @returns {Promise<Dialogs>} */
async function loadLater(commands) {
  await gaitsmith.ready;
  const [{ Palette }, { HelpSheet }, { startDropping }, { startHints }] = await Promise.all([
    import('./palette.js'), import('./help_sheet.js'), import('../share/dropping.js'), import('../languages/hints.js')]);
  startDropping(commands.app);
  startHints(commands.app);
  return { palette: new Palette(commands), help: new HelpSheet(commands) };
}

/** Adds the page's own commands. @param {Commands} commands @param {{address: Address, autosave: Autosave, dialogs: Promise<Dialogs>}} parts */
function addCommands(commands, { address, autosave, dialogs }) {
  dialogs.catch(() => {}); // reported when one is opened
  const open = (/** @type {keyof Dialogs} */ name) => void dialogs.then((loaded) => loaded[name].open(), () => statusLine.say(tr('The dialog could not be loaded.')));
  const click = Commands.click;
  commands.add([
    { id: 'motion/describe', group: 'Motion', title: trLater('Describe the motion'), keys: ['w'], run: click('describe') },
    { id: 'document/open', group: 'Document', title: trLater('Open a file or a link'), keys: ['Ctrl+o'], pressed: ['Ctrl+v'], run: click('open') },
    { id: 'document/save', group: 'Document', title: trLater('Save as a file'), keys: ['Ctrl+s'], run: click('save') },
    { id: 'document/export', group: 'Document', title: trLater('Export as picture, video or data'), keys: [], run: () => void openExport(commands.app, statusLine) },
    { id: 'document/share', group: 'Document', title: trLater('Share: link, QR code, embed code'), keys: [], run: click('share') },
    { id: 'document/copy-link', group: 'Document', title: trLater('Copy link'), keys: ['c'], pressed: ['Ctrl+c'], run: click('copy-link') },
    { id: 'view/theme', group: 'View', title: trLater('Next theme'), keys: ['t'], run: nextTheme },
    { id: 'help/commands', group: 'Help', title: trLater('Find a command'), keys: ['Ctrl+k'], run: () => open('palette') },
    { id: 'help/keys', group: 'Help', title: trLater('All keys'), keys: ['?', 'F1'], run: () => open('help') },
    { id: 'help/tour', group: 'Help', title: trLater('Tour of the playground'), keys: [], run: () => void openTour(commands.app, statusLine) },
  ]);
  commands.addSource(() => autosave.commands());
  // The first motion does not need these.
  void gaitsmith.ready.then(() => import('../share/examples.js')).then(({ EXAMPLES, openExample }) => {
    commands.addSource(() => Object.entries(EXAMPLES).map(([name, title]) => (
      { id: `example/${name}`, group: 'Examples', title: tr('Open example: {1}', tr(title)), keys: [], run: () => void openExample(commands.app, statusLine, name) })));
  }, () => {});
  commands.addSource(() => Object.entries(THEMES).map(([theme, name]) => (
    { id: `view/theme/${theme}`, group: 'View', title: tr('Theme: {1}', tr(name)), keys: [], run: () => chooseTheme(theme) })));
  commands.addSource(() => Object.entries(LANGUAGES).map(([code, name]) => (
    { id: `view/language/${code}`, group: 'View', title: tr('Language: {1}', name), keys: [], run: () => void chooseLanguage(code) })));
  onClick('new', () => commands.app.run('document/new'));
  onClick('home', (event) => {
    if (event.ctrlKey || event.metaKey || event.shiftKey) return; // opens a new tab or window
    if (embedded) { // opens the document in a new tab, where there is more room
      element('home', HTMLAnchorElement).href = address.link().replace('#', '?edit#');
      return;
    }
    event.preventDefault();
    commands.app.run('document/new');
  });
  onClick('share', () => void openShare(commands.app, address, statusLine));
  onClick('commands', () => open('palette'));
  onClick('keys', () => open('help'));
}
