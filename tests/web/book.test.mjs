// SPDX-License-Identifier: MIT
// The book: its rules, and, with a built site, every page.
//
//   node --test tests/web/book.test.mjs                                  the rules
//   GAITSMITH_SITE=build/site node --test tests/web/book.test.mjs        and the pages
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { mkdtemp, mkdir, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join, relative, resolve } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { Faults } from '../../web/book/faults.mjs';
import { frontMatter } from '../../web/book/front_matter.mjs';
import { firstSentence, HeadingNames } from '../../web/book/headings.mjs';
import { Links } from '../../web/book/links.mjs';
import { Markdown } from '../../web/book/markdown.mjs';
import { readLanguages } from '../../web/book/languages/words.mjs';
import { readPages } from '../../web/book/pages.mjs';
import { firstComment, notes, forDoxygen } from '../../web/book/reference/comments.mjs';

const ROOT = fileURLToPath(new URL('../../', import.meta.url));
const SITE = process.env.GAITSMITH_SITE && resolve(process.env.GAITSMITH_SITE);
const foreign = createRequire(join(ROOT, 'web/package.json'));

test('book: first sentences end where they end', () => {
  assert.equal(firstSentence('Mr. Star-Man walks. Then he rests.'), 'Mr. Star-Man walks.');
  assert.equal(firstSentence('At 0.8 s, e.g. here, it turns! Yes.'), 'At 0.8 s, e.g. here, it turns!');
  assert.equal(firstSentence('It searches. core/x.h is how.'), 'It searches.');
  assert.equal(firstSentence('One thing:'), 'One thing.');
  assert.ok(firstSentence('word '.repeat(100)).length < 242);
});

test('book: headings have the names that Git forges give them', () => {
  const names = new HeadingNames();
  assert.deepEqual(['7 Contact model (2026-11-21)', 'What’s `τ`?', 'A', 'A'].map((text) => names.name(text)),
    ['7-contact-model-2026-11-21', 'whats-τ', 'a', 'a-1']);
});

test('book: front matter is read, and its faults have lines', () => {
  const faults = new Faults();
  const { fields, before, body } = frontMatter('---\ntitle: A: b\nminutes: 5\n---\nText', 'f.md', ['title', 'minutes'], faults);
  assert.deepEqual([fields.get('title')?.value, before, body], ['A: b', 4, 'Text']);
  frontMatter('---\ntitle: A\nauthor: B\n---\n', 'f.md', ['title'], faults);
  assert.match(faults.sentences.join(), /^f\.md:3: /);
});

test('reference: a header says what it is before its code, with what is set as it stands', () => {
  const header = '// SPDX-License-Identifier: MIT\n// One. Two\n// three.\n//\n// Four:\n//   a  <= b\n//   c\n// Five.\n#pragma once\n// not this\n';
  assert.deepEqual(firstComment(header), [{ text: 'One. Two three.', drawn: false }, { text: 'Four:', drawn: false }, { text: 'a  <= b\nc', drawn: true }, { text: 'Five.', drawn: false }]);
});

test('reference: comments behind members are seen, also where they go on below, and lines keep their numbers', () => {
  const header = ['// of the file', '#pragma once', 'enum class A {', '  kB,  // one,', '       // two', '  kC,', '};', 'struct D {', '  // Of both.', '  int e = 1;  // [1, 2]',
    '  int f;  // NOLINT', '};', '///   x <- y', '/// @param g, h  numbers', '}  // namespace gaitsmith'].join('\n');
  const lines = forDoxygen(header).split('\n');
  assert.equal(lines.length, header.split('\n').length);
  assert.deepEqual([lines[3], lines[4], lines[9], lines[10]], ['  kB, ///< @details one, two', '', '  int e = 1; ///< @details [1, 2]', '  int f;  // NOLINT']);
  assert.deepEqual(lines.slice(12), ['/// <pre>x &lt;- y</pre>', '/// @param g,h  numbers', '}  // namespace gaitsmith']);
  assert.deepEqual([...notes(header)], [[10, 'Of both.']]);
});

/** The errors in a lesson's body, and its HTML. @param {string} body @param {Map<string, string>} [reference] */
async function lessonOf(body, reference) {
  const root = await mkdtemp(join(tmpdir(), 'book-'));
  await mkdir(join(root, 'docs/lessons'), { recursive: true });
  await writeFile(join(root, 'docs/there.md'), '# There\nHello.\n');
  await writeFile(join(root, 'docs/lessons/1-x.md'), `---\ntitle: X\nminutes: 5\nopen: ../a.json\n---\n${body}`);
  await writeFile(join(root, 'docs/a.json'), '{}');
  await mkdir(join(root, 'core'));
  await writeFile(join(root, 'core/x.h'), '');
  await writeFile(join(root, 'secret.txt'), '');
  const faults = new Faults();
  const pages = await readPages(root, faults);
  const playground = /** @type {any} */ ({ payload: async () => 'AbC', tables: { terms: [{ name: 'rotations' }], control_modes: [{ name: 'physical' }, { name: 'timer' }, { name: 'network' }] } });
  const { html } = await new Markdown(new Links((file) => existsSync(join(root, file)), pages, playground, faults, reference)).render(pages[0]);
  await rm(root, { recursive: true });
  return { html, faults: faults.sentences };
}

test('book: links lead where the book has things', async () => {
  const { html, faults } = await lessonOf('[there](../there.md#there) [it](../a.json?panels=style,figure&lock=figure) [out](https://example.org/)\n');
  assert.deepEqual(faults, []);
  assert.match(html, /href="\.\.\/there\.html#there"/);
  assert.match(html, /href="\.\.\/\.\.\/index\.html\?panels=style,figure&amp;lock=figure#AbC" data-open="AbC" data-panels="style,figure" data-lock="figure"/);
  assert.match(html, /href="https:\/\/example\.org\/"/);
});

test('book: a link that leads nowhere is a fault with its line', async () => {
  const { faults } = await lessonOf('A\n\nB\n[none](none.md)\n\n[secret](../../secret.txt)\n\n[a](../a.json?evil=1)\n');
  assert.deepEqual(faults.map((fault) => fault.slice(0, 22)), ['docs/lessons/1-x.md:9:', 'docs/lessons/1-x.md:11', 'docs/lessons/1-x.md:13']);
});

test('book: a link to a header leads to its page, and is words where there is no reference', async () => {
  const body = '[the *header*](../../core/x.h) [all](../../core) [there](../there.md)\n';
  const { html, faults } = await lessonOf(body, new Map([['core/x.h', 'reference/core/x.html'], ['core', 'reference/index.html']]));
  assert.match(html, /<p><a href="\.\.\/reference\/core\/x\.html">the <em>header<\/em><\/a> <a href="\.\.\/reference\/index\.html">all<\/a>/);
  const without = await lessonOf(body);
  assert.match(without.html, /<p>the <em>header<\/em> all <a href="\.\.\/there\.html">there<\/a><\/p>/);
  assert.deepEqual([faults, without.faults], [[], []]);
});

test('book: blocks of lessons', async () => {
  const { html, faults } = await lessonOf([
    '```goal', 'travel >= 8, rotations >= 1', 'Reach *8 m*.', '```', '```quiz', 'Why <so>?', '( ) a | no', '(x) b | yes', '```',
    '```do', '{"call": "open", "args": ["../a.json"], "label": "Open & look"}', '```'].join('\n'));
  assert.deepEqual(faults, []);
  assert.match(html, /data-goal="travel &gt;= 8, rotations &gt;= 1"/);
  assert.match(html, /Reach <em>8 m<\/em>\./);
  assert.match(html, /<legend>Why &lt;so&gt;\?<\/legend>/);
  assert.equal(html.match(/type="radio"/g)?.length, 2);
  assert.equal(html.match(/data-right/g)?.length, 1);
  assert.match(html, /data-call="open" data-args="\[&quot;AbC&quot;\]" disabled>Open &amp; look</);
  const bad = await lessonOf(['```goal', 'as far as you can', 'Go.', '```', '```quiz', 'Why?', '( ) a | no', '```', '```do', '{"call": "format", "label": "x"}', '```'].join('\n'));
  assert.equal(bad.faults.length, 3);
});

test('player: sends calls, receives answers and events, and ignores other senders', async () => {
  /** @type {((event: any) => void) | undefined} */
  let onMessage;
  /** @type {any[]} */
  const posted = [];
  const contentWindow = { postMessage: (/** @type {any} */ message, /** @type {string} */ origin) => posted.push({ ...message, origin }) };
  Object.assign(globalThis, { addEventListener: (/** @type {string} */ _, /** @type {any} */ listener) => { onMessage = listener; }, location: { href: 'https://school.example/page.html' } });
  const frame = Object.assign(new EventTarget(), { contentWindow, src: 'https://play.example/index.html' });
  const { Player } = await import('../../web/book/player.js');
  const player = new Player(/** @type {any} */ (frame));
  const say = (/** @type {any} */ data, source = contentWindow, origin = 'https://play.example') => onMessage?.({ data: { gaitsmith: 1, ...data }, source, origin });
  const [hello] = posted;
  assert.deepEqual([hello.call, hello.origin], ['hello', '*']);
  const asked = player.call('open', 'AbC');
  say({ id: hello.id, result: { version: 9 } }, /** @type {any} */ ({}));
  say({ id: hello.id, result: { version: 9 } }, contentWindow, 'https://other.example');
  say({ id: hello.id, result: { version: 1 } });
  assert.deepEqual(await player.ready, { version: 1 });
  await new Promise(setImmediate);
  const open = posted[posted.length - 1];
  assert.deepEqual([open.call, open.args, open.origin], ['open', ['AbC'], 'https://play.example']);
  say({ id: open.id, error: 'no such figure' });
  await assert.rejects(asked, /no such figure/);
  /** @type {any} */
  let received;
  player.addEventListener('goal', (event) => { received = /** @type {any} */ (event).detail; });
  say({ event: 'goal', detail: { met: true } });
  assert.deepEqual(received, { met: true });
  const lost = player.call('hash');
  await new Promise(setImmediate);
  say({ event: 'ready' });
  await assert.rejects(lost, /anew/);
});

if (!SITE) {
  test('book: pages', { skip: 'no built site is given as GAITSMITH_SITE' }, () => {});
} else {
  const book = join(SITE, 'book');
  const { parse } = foreign('node-html-parser');
  const { HtmlValidate } = foreign('html-validate');
  const files = (await readdir(book, { recursive: true })).filter((file) => file.endsWith('.html')).sort();
  const pages = new Map(await Promise.all(files.map(async (file) => {
    const html = await readFile(join(book, file), 'utf8');
    return /** @type {[string, {html: string, root: any}]} */ ([join(book, file), { html, root: parse(html, { comment: true, blockTextElements: { script: true, style: true } }) }]);
  })));
  /** @param {string} file @param {string} id */
  const hasId = (file, id) => (pages.get(file)?.root ?? parse(readFileSync(file, 'utf8'))).getElementById(id) !== null;

  test('book: every file of docs is a page', async () => {
    const languages = (await readLanguages(ROOT)).map(({ folder }) => folder);
    for (const folder of languages.flatMap((each) => [join('docs', each), join('docs', each, 'lessons')]).filter((each) => existsSync(join(ROOT, each)))) {
      for (const file of (await readdir(join(ROOT, folder))).filter((name) => name.endsWith('.md'))) {
        assert.ok(pages.has(join(book, relative(join(ROOT, 'docs'), join(ROOT, folder, file.replace(/md$/, 'html'))))), file);
      }
    }
  });

  test('book: the answers of the lessons are reached only from the page for teachers, and the search does not find them', async () => {
    const lessons = (await readdir(join(ROOT, 'docs/lessons'))).length;
    const languages = (await readLanguages(ROOT)).filter(({ folder }) => pages.has(join(book, folder, 'lesson-answers.html')));
    const answerPages = languages.map(({ folder }) => `${folder}lesson-answers.html`);
    const from = [...pages].filter(([file, { root }]) => !answerPages.includes(relative(book, file)) && root.querySelectorAll('[href*="lesson-answers"]').length > 0).map(([file]) => relative(book, file));
    assert.deepEqual(from.sort(), languages.map(({ folder }) => `${folder}teachers.html`).sort());
    const words = (/** @type {string} */ file) => pages.get(join(book, file))?.root.querySelector('main').text ?? '';
    for (const { folder } of languages) {
      assert.equal(pages.get(join(book, folder, 'teachers.html'))?.root.querySelectorAll('header [href*="lesson-answers"]').length, 0);
      assert.doesNotMatch(await readFile(join(book, folder, 'search.json'), 'utf8'), /lesson-answers/);
      assert.equal(pages.get(join(book, folder, 'lesson-answers.html'))?.root.querySelectorAll('ol > li').length, lessons, 'an answer to each Explain');
    }
    // The right answer to every question of a lesson.
    for (const [file, { root }] of pages) {
      const folder = relative(book, file).replace(/lessons\/.*$/, '');
      for (const quiz of root.querySelectorAll('.quiz')) {
        const right = quiz.querySelector(`label[for=${quiz.querySelector('[data-right]').id}]`).text;
        assert.ok(words(`${folder}lesson-answers.html`).includes(right), `${relative(book, file)}: ${right}`);
        assert.ok(!words(`${folder}teachers.html`).includes(right), `${folder}teachers.html: ${right}`);
      }
    }
  });

  test('book: every link, anchor and picture leads somewhere on the site, and nothing else is loaded', () => {
    for (const [file, { root }] of pages) {
      for (const node of root.querySelectorAll('[href], [src], [srcset], [action]')) {
        const { href, src, srcset, action } = node.attributes;
        const address = href ?? src ?? srcset ?? action;
        if (/^https?:|^mailto:/.test(address)) {
          assert.equal(node.tagName, 'A', `${file} loads ${address}`);
          continue;
        }
        const url = new URL(address.replaceAll('&amp;', '&'), pathToFileURL(file));
        const there = fileURLToPath(url.href.replace(/[?#].*$/, '')).replace(/\/$/, '/index.html');
        assert.ok(there.startsWith(SITE), `${file}: ${address} leaves the site`);
        assert.ok(existsSync(there), `${file}: ${address} leads nowhere`);
        const isPlayground = there === join(SITE, 'index.html');
        if (url.hash && !isPlayground) assert.ok(hasId(there, decodeURIComponent(url.hash.slice(1))), `${file}: ${address} has no such place`);
      }
    }
  });

  test('book: style sheets load nothing from elsewhere, and only what is there', async () => {
    for (const file of (await readdir(book)).filter((name) => name.endsWith('.css'))) {
      const css = await readFile(join(book, file), 'utf8');
      assert.doesNotMatch(css, /@import|url\(["']?(https?:)?\/\//, file);
      for (const [, path] of css.matchAll(/url\(([^)]+)\)/g)) assert.ok(existsSync(join(book, path)), `${file}: ${path}`);
    }
  });

  test('book: every page has a title, a description, one heading of the first order, and landmarks', () => {
    for (const [file, { root }] of pages) {
      assert.ok(root.querySelector('title')?.text.trim(), file);
      assert.ok(root.querySelector('meta[name=description]')?.getAttribute('content')?.trim(), file);
      assert.equal(root.querySelectorAll('h1').length, 1, file);
      for (const one of ['header', 'main', 'nav']) assert.ok(root.querySelector(one), `${file}: ${one}`);
      for (const image of root.querySelectorAll('img')) assert.ok(image.getAttribute('alt')?.trim(), `${file}: a picture without words`);
    }
  });

  test('book: html-validate finds nothing', () => {
    const validator = new HtmlValidate({ root: true, extends: ['html-validate:recommended'], rules: { 'long-title': 'off', 'valid-id': ['error', { relaxed: true }], 'doctype-style': ['error', { style: 'lowercase' }] } });
    const found = [...pages].flatMap(([file, { html }]) => validator.validateStringSync(html).results
      .flatMap((/** @type {any} */ { messages }) => messages.map((/** @type {any} */ { line, ruleId, message }) => `${relative(book, file)}:${line}: ${ruleId}: ${message}`)));
    assert.deepEqual(found, []);
  });

  test('site: html-validate finds nothing in the playground and in the example of the package', async () => {
    const validator = new HtmlValidate({ root: true, extends: ['html-validate:recommended'], rules: {
      'doctype-style': ['error', { style: 'lowercase' }],
      'empty-heading': 'off', 'unique-landmark': 'off', // scripts write the title and the tour
      'prefer-native-element': 'off', // no native element replaces a combobox over a list or the drawn progress bar
    } });
    for (const file of [join(SITE, 'index.html'), join(ROOT, 'web/package/engine/example.html')]) {
      const { results } = validator.validateStringSync(await readFile(file, 'utf8'));
      assert.deepEqual(results.flatMap((/** @type {any} */ { messages }) => messages.map((/** @type {any} */ { line, ruleId }) => `${file}:${line}: ${ruleId}`)), []);
    }
  });

  test('book: the search finds', async () => {
    const MiniSearch = foreign('minisearch');
    const index = async (/** @type {string} */ name) => MiniSearch.loadJSON(await readFile(join(book, name), 'utf8'), { fields: ['title', 'heading', 'text'], storeFields: ['href'] });
    const [search, decisions] = [await index('search.json'), await index('design_search.json')];
    const found = (/** @type {any} */ where, /** @type {string} */ words) => where.search(words).map((/** @type {any} */ { href }) => href);
    assert.ok(found(search, 'friction').some((/** @type {string} */ href) => href.startsWith('physics.html#')), found(search, 'friction').join());
    // Decisions are not stored for use without a network, so neither is where they are found.
    assert.ok(found(decisions, 'complementarity').some((/** @type {string} */ href) => href.startsWith('design.html#')));
    assert.ok(!found(search, 'decision').some((/** @type {string} */ href) => href.startsWith('design.html')));
    for (const { href } of [...search.search('the', { prefix: true }), ...decisions.search('the', { prefix: true })]) {
      const [page, id] = href.split('#');
      assert.ok(pages.has(join(book, page)) && (!id || hasId(join(book, page), id)), href);
    }
  });

  const hasReference = existsSync(join(book, 'reference'));
  test('reference: every header of core but the one for games has a page, and the first page leads to it', { skip: !hasReference && 'Doxygen was not installed' }, async () => {
    const first = pages.get(join(book, 'reference/index.html'))?.root;
    for (const header of (await readdir(join(ROOT, 'core'), { recursive: true })).filter((name) => name.endsWith('.h') && name !== 'runtime/gaitsmith.h')) {
      const page = `core/${header.replace(/h$/, 'html')}`;
      const root = pages.get(join(book, 'reference', page))?.root;
      assert.ok(root, page);
      assert.match(root.querySelector('main').text, new RegExp(`#include "core/${header}"`), page);
      assert.ok(root.querySelector('h2') || header === 'rollout/plant.h', `${page} declares nothing`);
      assert.ok(first.querySelector(`a[href="../reference/${page}"]`), `the first page does not lead to ${page}`);
    }
  });

  test('reference: a page has what its header declares for others, with words, and nothing else', { skip: !hasReference && 'Doxygen was not installed' }, () => {
    const page = (/** @type {string} */ name) => pages.get(join(book, `reference/core/${name}.html`))?.root;
    const evaluator = page('rollout/evaluator');
    const heading = evaluator.getElementById('evaluator-evaluate');
    assert.equal(heading.text, 'Evaluate');
    const [declared, parameters, returned] = [heading.nextElementSibling, heading.nextElementSibling.nextElementSibling, heading.nextElementSibling.nextElementSibling.nextElementSibling];
    assert.match(declared.text, /std::vector<Evaluation> Evaluate\(std::span<const Genome> genomes\) const/);
    assert.match(declared.innerHTML, /<var>genomes<\/var>/);
    assert.match(declared.innerHTML, /<a href="\.\.\/\.\.\/\.\.\/reference\/core\/rollout\/evaluation\.html#evaluation">Evaluation<\/a>.*<a href="\.\.\/\.\.\/\.\.\/reference\/core\/control\/gene_groups\.html#genome">Genome<\/a>/s);
    assert.match(parameters.text, /genomes any number of them, each with Problem::Shape\(\)\.Genes\(\) genes/);
    assert.match(returned.text, /Returns an evaluation for each, in order/);
    assert.match(page('rollout/evaluation').getElementById('evaluation-fitness').text, /float fitness = kVoidScore\s+with several beginnings: the mean, void if one is/);
    assert.doesNotMatch(evaluator.text, /problem_|EvaluateWidth|lane_width/);
    // A comment on two lines, a comment above several members, a declaration of two members, and a constant.
    assert.match(page('control/senses').text, /kPhysical\s+joint angles, contact forces at the endpoints, height and vertical velocity of the centre of mass/);
    assert.match(page('physics/terms').text, /Our own terms, 0 unless they were requested\. See docs\/style\.md\.\s+float effort_rad/);
    assert.match(page('rollout/motion').getElementById('motion-point-y').parentNode.text, /float x, y/);
    assert.equal(page('search/batch_search').getElementById('batchsearch-tell').nextElementSibling.text, 'virtual void Tell(std::span<const Score> scores) final');
    assert.match(page('physics/figure').getElementById('knoparent').text, /constexpr int kNoParent = -1/);
  });

  test('reference: the search finds what is declared', { skip: !hasReference && 'Doxygen was not installed' }, async () => {
    const MiniSearch = foreign('minisearch');
    const search = MiniSearch.loadJSON(await readFile(join(book, 'reference/search.json'), 'utf8'), { fields: ['title', 'heading', 'text'], storeFields: ['href'] });
    assert.equal(search.search('MakeSearch', { boost: { heading: 3 } })[0].href, 'reference/core/search/search.html#makesearch');
    assert.equal(search.search('kVoidScore', { boost: { heading: 3 } })[0].href, 'reference/core/rollout/task.html#kvoidscore');
  });
}
