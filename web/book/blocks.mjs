// SPDX-License-Identifier: MIT
// The blocks that only lessons have: a goal, a quiz question, and a button that controls the playground.
import { faultOfGoal } from '../page/goal_conditions.js';
import { attributes, escaped } from './html.mjs';
import { SCENES } from '../explorable/scenes.js';

/** @typedef {import('./markdown.mjs').Markdown} Markdown */
/** @typedef {import('./pages.mjs').Page} Page */
/** @typedef {(markdown: Markdown, page: Page, content: string, line: number) => Promise<string>} Block */

/** The file that names what a block opens. @param {Page} page */
const sourceOf = ({ original, source }) => original?.source ?? source;

const CHOICE = /^\(([ x])\)\s+(.+?)\s*(?:\|\s*(.+))?$/;
/** A slider: "0 to 40 by 1 m". */
const RANGE = /^(-?[\d.]+) to (-?[\d.]+)(?: by ([\d.]+))?(?: (\S+))?$/;
/** The calls that a button may make (docs/embedding.md). */
const CALLS = ['open', 'synthesize', 'stop', 'pause', 'resume', 'lab', 'undo', 'redo', 'run', 'arrange'];
const TICK = '<svg class="tick" viewBox="0 0 20 20" aria-hidden="true"><circle cx="10" cy="10" r="8.5"/><path d="M6 10.4l2.8 2.8L14.2 7.4"/></svg>';

/** @type {Block} */
async function goal(markdown, page, content, line) {
  const [conditions = '', ...words] = content.trim().split('\n');
  const fault = faultOfGoal(conditions, markdown.links.playground.tables);
  if (fault) markdown.faults.add(page.source, line + 1, fault);
  if (words.length === 0) markdown.faults.add(page.source, line, 'a goal needs a line with its words');
  page.lesson?.goals.push(conditions.trim());
  const { tr } = page.language;
  return `<section class="goal"${attributes({ 'data-goal': conditions.trim(), 'aria-label': tr('Goal') })}>
${TICK}
<div>
<p>${await markdown.inline(page, line, words.join('\n'))}</p>
<p class="state" role="status"></p>
<button type="button" class="bordered" hidden>${tr('Set this goal')}</button>
</div>
</section>
`;
}

/** @type {Block} */
async function quiz(markdown, page, content, line) {
  const { tr } = page.language;
  const [question = '', ...lines] = content.trim().split('\n');
  const name = `quiz-${line}`;
  const choices = await Promise.all(lines.map(async (text, i) => {
    const [, mark, words, why] = CHOICE.exec(text) ?? [];
    if (!words || !why) markdown.faults.add(page.source, line + 2 + i, 'an answer is written "( ) words | explanation", the right one with an x');
    return { right: mark === 'x', words: await markdown.inline(page, line, words ?? ''), why: await markdown.inline(page, line, why ?? '') };
  }));
  page.lesson?.quizzes.push({ question: plain(question), answers: lines.map((text) => plain(CHOICE.exec(text)?.[2] ?? '')), right: choices.findIndex(({ right }) => right) });
  if (choices.filter(({ right }) => right).length !== 1) markdown.faults.add(page.source, line, 'one answer of a quiz is right: "(x)"');
  return `<fieldset class="quiz">
<legend>${await markdown.inline(page, line, question)}</legend>
${choices.map(({ words, right }, i) => `<p><input type="radio"${attributes({ name, id: `${name}-${i}`, value: String(i), 'data-right': right ? '' : undefined })}> <label for="${name}-${i}">${words}</label></p>`).join('\n')}
<div class="feedback" role="status"></div>
<details>
<summary>${tr('Answers')}</summary>
<ol>
${choices.map(({ words, right, why }) => `<li><span class="answer">${words}</span> <span class="why"><strong>${right ? tr('Right.') : tr('No.')}</strong> ${why}</span></li>`).join('\n')}
</ol>
</details>
</fieldset>
`;
}

/** What a reader expects, before trying: a choice or a number. No answer is right. @type {Block} */
async function predict(markdown, page, content, line) {
  const [question = '', ...lines] = content.trim().split('\n');
  const name = `predict-${line}`;
  const [, low, high, step = '1', unit = ''] = RANGE.exec(lines[0] ?? '') ?? [];
  const answers = lines.map((text) => CHOICE.exec(text)?.[2] ?? '');
  if (low === undefined && (answers.length < 2 || answers.includes('') || lines.some((text) => /^\(x\)|\|/.test(text)))) {
    markdown.faults.add(page.source, line + 1, 'a prediction has two or more lines "( ) words", or one such as "0 to 40 by 1 m"');
  }
  page.lesson?.predictions.push({ question: plain(question), answers: low === undefined ? answers.map(plain) : [], ...low === undefined ? {} : { unit } });
  const choices = await Promise.all(answers.map((words) => markdown.inline(page, line, words)));
  const body = low === undefined
    ? choices.map((words, i) => `<p><input type="radio"${attributes({ name, id: `${name}-${i}`, value: String(i) })}> <label for="${name}-${i}">${words}</label></p>`).join('\n')
    : `<p class="slide"><input type="range"${attributes({ id: name, min: low, max: high, step, value: String((Number(low) + Number(high)) / 2), 'aria-label': plain(question), 'data-unit': unit })}> <output${attributes({ for: name })}>?</output><span class="printed">${escaped(unit)}</span></p>`;
  return `<fieldset class="predict">
<legend>${await markdown.inline(page, line, question)}</legend>
${body}
</fieldset>
`;
}

/** Without the marks of Markdown. @param {string} text */
const plain = (text) => text.replace(/[*`]/g, '');

/** @type {Block} */
async function action(markdown, page, content, line) {
  /** @type {{call?: string, args?: any[], label?: string}} */
  let given = {};
  try {
    given = JSON.parse(content);
  } catch {
    markdown.faults.add(page.source, line + 1, 'what to do is written as JSON');
  }
  const { call = '', args = [], label = '' } = given;
  if (!CALLS.includes(call)) markdown.faults.add(page.source, line + 1, `"call" is one of ${CALLS.join(', ')}`);
  if (!Array.isArray(args)) markdown.faults.add(page.source, line + 1, '"args" is a list');
  if (typeof label !== 'string' || label === '') markdown.faults.add(page.source, line + 1, '"label" says what stands on the button');
  const resolvedArgs = call === 'open' && /\.json$/.test(String(args[0]))
    ? [(await markdown.links.resolve(page, line + 1, args[0], sourceOf(page))).opens?.payload] : args;
  return `<p class="do"><button type="button" class="primary"${attributes({ 'data-call': call, 'data-args': JSON.stringify(resolvedArgs) })} disabled>${escaped(String(label))}</button> <span class="state" role="status"></span></p>
`;
}

/** A live stage (web/explorable), on any page. @type {Block} */
async function stage(markdown, page, content, line) {
  /** @type {{kind?: string, open?: string, label?: string}} */
  let given = {};
  try {
    given = JSON.parse(content);
  } catch {
    markdown.faults.add(page.source, line + 1, 'a stage is written as JSON');
  }
  const { kind = '', open = '', label = '', ...options } = given;
  if (!Object.hasOwn(SCENES, kind)) markdown.faults.add(page.source, line + 1, `"kind" is one of ${Object.keys(SCENES).join(', ')}`);
  if (label === '') markdown.faults.add(page.source, line + 1, '"label" says what is seen, for who cannot see it');
  const { href, opens } = await markdown.links.resolve(page, line + 1, open, sourceOf(page));
  if (!opens) markdown.faults.add(page.source, line + 1, '"open" names a document of examples');
  return `<figure class="stage"${attributes({ 'data-kind': kind, 'data-open': opens?.payload, 'data-options': JSON.stringify(options) })}>
<canvas role="img"${attributes({ 'aria-label': label })}></canvas>
<div class="controls"></div>
<figcaption><span class="said" role="status"></span> <a${attributes({ href })}>${page.language.tr('Open in the playground')}</a></figcaption>
</figure>
`;
}

/** Blocks by the word after the fence. @type {Record<string, Block>} */
export const BLOCKS = { goal, predict, quiz, do: action, stage };
