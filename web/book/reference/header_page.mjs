// SPDX-License-Identifier: MIT
// The page of a header of core.
import { firstSentence } from '../headings.mjs';
import { attributes, escaped, upFrom } from '../html.mjs';
import { firstComment, notes } from './comments.mjs';
import { addressOf } from './names.mjs';
import { description, drawing } from './prose.mjs';
import { declarator, signature } from './signature.mjs';
import { isComparable } from './symbols.mjs';

/** @typedef {import('../markdown.mjs').Section} Section */
/** @typedef {import('./names.mjs').Names} Names */
/** @typedef {import('./symbols.mjs').Symbol} Symbol */
/** A page's data for the search. @typedef {{address: string, title: string, sections: Section[]}} Searched */

/** A row of a list. line: of the declaration. @typedef {{id?: string, line: number, declared: string, words: string}} Row */

const MIN_NAMES = 3; // for a table of contents

/** The text of HTML. @param {string} html */
const plain = (html) => html.replace(/<\/(p|li|pre|h\d)>/g, ' ').replace(/<[^>]+>/g, '').replace(/&lt;/g, '<').replace(/&gt;/g, '>').replace(/&quot;/g, '"').replace(/&amp;/g, '&');

/** @param {string} header */
export function sentenceOf(header) {
  return firstSentence(firstComment(header)[0]?.text ?? '');
}

/** @param {import('./prose.mjs').Description} description */
function worded({ html, parameters, returns }) {
  const list = parameters.map(({ names, html: words }) => `<li>${names.map((name) => `<var>${escaped(name)}</var>`).join(', ')} ${words}</li>\n`).join('');
  return html + (list && `<ul class="parameters">\n${list}</ul>\n`) + (returns && `<p><strong>Returns</strong> ${returns}</p>\n`);
}

class HeaderPage {
  /** @type {Section[]} */
  sections = [];

  /** @param {string} path @param {string} text @param {Symbol[]} symbols @param {Names} names */
  constructor(path, text, symbols, names) {
    this.path = path;
    this.address = addressOf(path);
    this.paragraphs = firstComment(text);
    this.notes = notes(text);
    this.symbols = symbols;
    this.names = names;
  }

  /** @param {string} html @param {Symbol} symbol @param {string} [heading] */
  #found(html, symbol, heading = symbol.name) {
    this.sections.push({ heading, id: symbol.id, text: plain(html) });
    return html;
  }

  /** @param {Symbol} symbol @param {string} scope */
  #callable(symbol, scope) {
    const writer = this.names.on(this.address, scope);
    /** Declarations with a common description. @type {{signatures: string[], words: string}[]} */
    const parts = [];
    for (const one of [symbol, ...symbol.others]) {
      const words = worded(description(one.element, writer));
      const last = parts[parts.length - 1];
      const written = signature(one, writer);
      if (words === '' && last) last.signatures.push(written);
      else parts.push({ signatures: [written], words });
    }
    return parts.map(({ signatures, words }) => `<pre class="signature"><code>${signatures.join(signatures.some((one) => one.includes('\n')) ? '\n\n' : '\n')}</code></pre>\n${words}`).join('');
  }

  /** A list of members, values or constants with their descriptions. @param {Row[]} rows */
  #list(rows) {
    if (rows.length === 0) return '';
    const { words } = this.names.on(this.address, '');
    const row = rows.map(({ id, line, declared, words: details }) => {
      const note = this.notes.get(line);
      return `${note ? `<li class="note">${words(note)}</li>\n` : ''}<li${attributes({ id })}><code>${declared}</code>\n${details}</li>`;
    });
    return `<ul class="members">\n${row.join('\n')}\n</ul>\n`;
  }

  /** @param {Symbol[]} variables @param {string} scope */
  #variables(variables, scope) {
    const writer = this.names.on(this.address, scope);
    /** @type {Row[]} */
    const rows = [];
    for (const one of variables) {
      const last = rows[rows.length - 1];
      const words = description(one.element, writer).html;
      if (last?.line === one.line) { // int a, b;
        last.declared += `, ${declarator(one, writer, one.id)}`;
        last.words += words;
      } else {
        rows.push({ id: one.id, line: one.line, declared: signature(one, writer), words });
      }
    }
    return this.#list(rows);
  }

  /** @param {Symbol} type */
  #type(type) {
    const writer = this.names.on(this.address, type.name);
    const html = worded(description(type.element, writer));
    const declared = signature(type, writer);
    const values = type.element.all('enumvalue').map((value) => ({ line: 0, declared: `<var>${escaped(value.textOf('name'))}</var>${escaped(value.textOf('initializer') && ` ${value.textOf('initializer')}`)}`, words: description(value, writer).html }));
    const aliases = type.members.filter(({ kind }) => kind === 'alias');
    const own = this.#found(`${declared && `<pre class="signature"><code>${declared}</code></pre>\n`}${html}${isComparable(type.element) ? '<p>Can be compared with <code>==</code>.</p>\n' : ''}${this.#list(values)}${this.#variables([...aliases, ...type.members.filter(({ kind }) => kind === 'variable')], type.name)}`, type);
    const functions = type.members.filter(({ kind }) => kind === 'function' || kind === 'constructor')
      .map((one) => `<h3${attributes({ id: one.id })}>${one.kind === 'constructor' ? '<small>constructor</small> ' : ''}${escaped(one.short)}</h3>\n${this.#found(this.#callable(one, type.name), one)}`);
    return `<h2${attributes({ id: type.id })}><small>${type.kind}</small> ${escaped(type.name)}</h2>\n${own}${functions.join('')}`;
  }

  /** @returns {import('../template.mjs').Sheet} */
  sheet() {
    const up = upFrom(this.address);
    const writer = this.names.on(this.address, '');
    const slash = this.path.lastIndexOf('/') + 1;
    const [folder, file] = [this.path.slice(0, slash), this.path.slice(slash)];
    const intro = this.paragraphs.map(({ text, drawn }) => (drawn ? drawing(text) : `<p>${writer.words(text)}</p>\n`)).join('');
    this.sections.push({ heading: '', id: '', text: plain(intro) });
    const of = (/** @type {string[]} */ kinds) => this.symbols.filter(({ kind }) => kinds.includes(kind));
    const types = of(['class', 'struct', 'enum', 'alias']);
    const functions = of(['function']);
    const constants = of(['variable']);
    const parts = [...types, ...functions].map(({ id, name }) => ({ id, name }));
    if (constants.length > 0) parts.push({ id: 'constants', name: 'Constants' });
    const body = [
      ...types.map((type) => this.#type(type)),
      ...functions.map((one) => `<h2${attributes({ id: one.id })}><small>function</small> ${escaped(one.name)}</h2>\n${this.#found(this.#callable(one, ''), one)}`),
      ...(constants.length > 0 ? [`<h2 id="constants">Constants</h2>\n${this.#variables(constants, '')}`] : []),
    ].join('') || '<p class="how">It declares nothing for others: it defines what other headers declare.</p>\n';
    for (const one of constants) this.sections.push({ heading: one.name, id: one.id, text: plain(`${signature(one, writer)} ${description(one.element, writer).html}`) });
    const contents = parts.length < MIN_NAMES ? '' : `<nav class="contents" aria-label="On this page">
<p>On this page</p>
<ul>
${parts.map(({ id, name }) => `<li><a href="#${id}">${escaped(name)}</a></li>`).join('\n')}
</ul>
</nav>
`;
    return {
      title: this.path, address: this.address, kind: 'page reference', styles: ['reference.css'],
      description: firstSentence(this.paragraphs[0]?.text ?? this.path),
      body: `<div class="spread">
<main id="main" tabindex="-1">
<p class="group"><a href="${up}reference/index.html">API reference</a> · <a${attributes({ href: `${up}reference/index.html#${folder.split('/')[1]}` })}>${folder.slice(0, -1)}</a></p>
<h1>${escaped(file)}</h1>
${intro}<pre class="signature"><code>#include "${this.path}"</code></pre>
<p class="how">In namespace <code>gaitsmith</code>; CMake target <code>gaitsmith::core</code>. <a href="${up}engineers.html">How to build it</a></p>
${body}</main>
${contents}</div>`,
    };
  }
}

/**
 * @param {string} path @param {string} text  of the header @param {Symbol[]} symbols @param {Names} names
 * @returns {{sheet: import('../template.mjs').Sheet, searched: Searched}}
 */
export function headerPage(path, text, symbols, names) {
  const page = new HeaderPage(path, text, symbols, names);
  const sheet = page.sheet();
  return { sheet, searched: { address: page.address, title: path, sections: page.sections } };
}
