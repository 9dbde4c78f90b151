// SPDX-License-Identifier: MIT
// The voice of the page: no text of the tables of shell/words/languages and shell/words/hints has one of these habits, in English, German
// or Spanish. Neither have the translated words of the book. Each habit names its reason, with a text that had it.
import assert from 'node:assert/strict';
import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { fileURLToPath } from 'node:url';

const TABLES = fileURLToPath(new URL('../../shell/words/languages/', import.meta.url));
const HINTS = fileURLToPath(new URL('../../shell/words/hints/', import.meta.url));
const BOOK = fileURLToPath(new URL('../../web/book/words/', import.meta.url));

/** @typedef {{habit: RegExp, reason: string, example: string, allowed?: string[]}} Habit */

/** @type {Habit[]} */
const EVERYWHERE = [
  { habit: /;/, reason: 'two thoughts are two sentences', example: 'Looks once; then it ends.' },
  { habit: /(?<![\p{L}\d}])-(?=\d|\{)/u, reason: 'a minus sign is −', example: 'from -1 to 1' },
];

/** @type {Habit[]} */
const ENGLISH = [
  { habit: /\b(whoever|whatever|somebody|someone|anybody|nobody|no one)\b/i, reason: 'name the part of the page or the person', example: 'Whoever opens it',
    allowed: ['Nobody animated this', 'Nobody animated this. A computer found it.'] },
  { habit: /^not now\b/i, reason: 'say the reason alone', example: 'Not now: nothing to undo.' },
  { habit: /\b(tells?|told|says?|said|hears?|heard|speaks?|spoken)\b/i, reason: 'data is shown, reported, received', example: 'It was told so.' },
  { habit: /\b(so|as|that) many\b/i, reason: 'a noun and a number', example: 'Every run begins at the best of so many.' },
  { habit: /\ba (press|click|drag|tap)\b/i, reason: 'an imperative for the reader', example: 'A click stops it.' },
  { habit: /\b(heeds?|heeded|heedless|cares? about)\b/i, reason: 'a rule uses a sense', example: 'Heedless rules' },
  { habit: /\bacts\b/i, reason: 'a rule is active', example: 'Rule 1 acts.' },
  { habit: /\b(depth|deep|deeper)\b/i, reason: 'a rule matches by a number of percent', example: 'depth 0.49 of 1' },
  { habit: /\b(likewise|by the way|at hand|in hand|by hand|meanwhile)\b/i, reason: 'cut it, or say which', example: '10 in hand',
    allowed: ['It has only a few rules. The active one lights up, and this explains why. Open a rule to change it by hand.'] },
  { habit: /^(?:\w+ ){0,2}not$/i, reason: 'a switch is off', example: 'not' },
  { habit: /\b(afresh|anew|whence|thereby|hangs? together)\b/i, reason: 'a common word', example: 'start afresh',
    allowed: ['Chance that a rule or node of a perturbed controller is drawn anew.'] },
  { habit: /\b(goes|go|going) on\b/i, reason: 'a search, a queue continues', example: 'the queue goes on' },
];

/** @type {Habit[]} */
const GERMAN = [
  { habit: /\b(du|dich|dir|dein\w*|euch|euer|eure\w*)\b/i, reason: 'the reader is addressed by the infinitive', example: 'Hier kannst du' },
  { habit: /(^|[.!?:] )(Kopiere|Lade|Schließe|Drücke|Wähle|Ziehe|Klicke|Öffne|Speichere|Starte|Nimm)\b/, reason: 'the infinitive', example: 'Markiert: Drücke Strg+C.' },
  { habit: /\bbitte\b/i, reason: 'the infinitive needs no courtesy', example: 'bitte nur eine' },
  { habit: /\b(Ein|ein|Der|der) (Klick|Druck|Zug)\b|\b(Anklicken|Ziehen) (zeigt|dreht)\b|\bziehen (zeigt|dreht|ändert|verkettet)\b/,
    reason: 'the infinitive: „Zum Ansehen anklicken“', example: 'Anklicken zeigt sie.' },
  { habit: /Zeitleiste|Timeline/, reason: 'the timeline is the Zeitachse', example: 'die Zeitleiste' },
  { habit: /\bArbeiter/, reason: 'a worker is a Worker', example: 'keine Arbeiter' },
  { habit: /^Jetzt nicht\b/, reason: 'say the reason alone', example: 'Jetzt nicht: leer.' },
  { habit: /\b(niemand|jemand)\b/i, reason: 'name the part of the page or the person', example: 'wenn jemand', allowed: ['Das hat niemand animiert'] },
  { habit: /\bbeachte/i, reason: 'a rule uses a sense', example: 'der andere beachtete Sinn' },
  { habit: /\bwirkt\b/i, reason: 'a rule is active', example: 'Regel 1 wirkt.' },
  { habit: /\bTiefe\b|\btiefer\b/, reason: 'a rule matches by a number of percent', example: 'Tiefe 0,49' },
  { habit: /\b(the|and|with|this|undo|redo|press|click|rule|rules)\b/i, reason: 'nothing is left in English', example: 'Rule 1' },
];

/** @type {Habit[]} */
const SPANISH = [
  { habit: /(?<!\p{L})(tú|te|ti|tu|tus|puedes|quieres|haz|pulsa|usted|ustedes|vosotros|vuestr[oa]s?)(?!\p{L})/iu, reason: 'the reader is addressed by the infinitive', example: 'Aquí puedes elegir' },
  { habit: /por favor/i, reason: 'the infinitive needs no courtesy', example: 'solo uno, por favor' },
  { habit: /línea temporal|cronograma/i, reason: 'the timeline is the línea de tiempo', example: 'la línea temporal' },
  { habit: /trabajador/i, reason: 'a worker is a worker', example: 'dos trabajadores' },
  { habit: /[“”„]/, reason: 'quotation marks are « »', example: 'el “clip”' },
  { habit: /(^|[^¿])\b(Qué|Cuál|Cómo)\b[^.]*\?/, reason: 'a question begins with ¿', example: 'Cuál gusta más?' },
  { habit: /\b(the|and|with|this|undo|redo|press|click|rules?)\b/i, reason: 'nothing is left in English', example: 'Rule 1' },
];
const LANGUAGES = { 'de.json': GERMAN, 'es.json': SPANISH };

/** @type {Map<string, [string, string][]>} pairs of an English text and its translation, by file */
const tables = new Map();

before(async () => {
  for (const file of await readdir(TABLES)) {
    const { words, errors } = JSON.parse(await readFile(join(TABLES, file), 'utf8'));
    const [hints, english] = await Promise.all([file, 'en.json'].map(async (name) => JSON.parse(await readFile(join(HINTS, name), 'utf8'))));
    tables.set(file, [...[words, errors].flatMap(Object.entries), ...Object.keys(english).map((id) => /** @type {[string, string]} */ ([english[id], hints[id] ?? '']))]);
  }
});

/** @param {Habit} habit @param {string} text */
const has = ({ habit, allowed = [] }, text) => habit.test(text) && !allowed.includes(text);

/** The texts that have a habit, with its reason. @param {Habit[]} habits @param {string[]} texts */
const faults = (habits, texts) =>
  habits.flatMap((habit) => texts.filter((text) => has(habit, text)).map((text) => `${habit.reason}: “${text}”`));

test('voice: each habit is found', () => {
  for (const habit of [...EVERYWHERE, ...ENGLISH, ...GERMAN, ...SPANISH])
    assert.deepEqual(faults([habit], [habit.example]), [`${habit.reason}: “${habit.example}”`]);
});

test('voice: what is allowed is a text of the tables', () => {
  for (const [file, pairs] of tables) {
    const texts = pairs.flat();
    const unused = [...ENGLISH, ...LANGUAGES[/** @type {keyof typeof LANGUAGES} */ (file)] ?? []].flatMap(({ allowed = [] }) => allowed).filter((text) => !texts.includes(text));
    assert.deepEqual(unused, [], file);
  }
});

test('voice: the English texts have no habit', () => {
  const texts = new Set([...tables.values()].flat().map(([english]) => english));
  assert.ok(texts.size > 600, `only ${texts.size} texts were found`);
  assert.deepEqual(faults([...EVERYWHERE, ...ENGLISH], [...texts]), []);
});

test('voice: the German and Spanish texts have no habit', async () => {
  for (const [file, habits] of Object.entries(LANGUAGES)) {
    const texts = (tables.get(file) ?? []).map(([, translated]) => translated);
    const book = Object.values(JSON.parse(await readFile(join(BOOK, file), 'utf8')));
    assert.deepEqual(faults([...EVERYWHERE, ...habits], [...texts, ...book]), [], file);
  }
});
