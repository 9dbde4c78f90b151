// SPDX-License-Identifier: MIT
// Declarations as in core, with links, and without specifiers that only the compiler needs.
import { attributes, escaped } from '../html.mjs';

/** @typedef {import('./names.mjs').Writer} Writer */
/** @typedef {import('./symbols.mjs').Symbol} Symbol */
/** @typedef {import('./xml.mjs').Element} Element */
/** length: of the visible text. @typedef {{html: string, length: number}} Piece */

const MAX_WIDTH = 80; // characters of a signature in one line
const OMITTED = /^((inline|static|virtual|friend|explicit|constexpr) )+/;

/** Removes Doxygen's spaces inside types. @param {string} text */
const narrow = (text) => text.replace(/\s+/g, ' ').replace(/< /g, '<').replace(/ >/g, '>').replace(/ ([&*])/g, '$1');

/** @param {string} text @param {string} [tag] @returns {Piece} */
const plain = (text, tag) => ({ html: tag ? `<${tag}>${escaped(text)}</${tag}>` : escaped(text), length: text.length });

/** @param {Piece[]} pieces @returns {Piece} */
const joined = (pieces) => ({ html: pieces.map(({ html }) => html).join(''), length: pieces.reduce((sum, { length }) => sum + length, 0) });

/** The declaration's template parameters, which have no link. @param {Element} element */
const parametersOf = (element) => (element.one('templateparamlist')?.all('param') ?? []).map((param) => param.textOf('declname') || param.textOf('type').replace(/^(class|typename)\s+/, ''));

/** @param {Element | undefined} type @param {Writer} writer @param {string[]} own  names without a link @returns {Piece} */
function typed(type, writer, own) {
  const children = type?.children ?? [];
  return joined(children.map((child, i) => {
    if (typeof child === 'string') {
      const text = narrow(child);
      return plain(i === 0 ? text.trimStart().replace(OMITTED, '') : text);
    }
    return own.includes(child.text) ? plain(child.text) : { html: writer.reference(child.attributes.refid, child.text), length: child.text.length };
  }));
}

/** @param {Element} element @param {Writer} writer */
function template(element, writer) {
  const list = element.one('templateparamlist');
  if (!list) return '';
  const parameters = list.all('param').map((param) => [typed(param.one('type'), writer, parametersOf(element)).html, param.textOf('declname')].filter(Boolean).join(' '));
  return `template &lt;${parameters.join(', ')}&gt;\n`;
}

/** @param {Element} param @param {Writer} writer @param {string[]} own @returns {Piece} */
function parameter(param, writer, own) {
  const type = typed(param.one('type'), writer, own);
  const name = param.textOf('declname');
  const standard = param.textOf('defval');
  return joined([type, ...(name ? [plain(' '), plain(name, 'var'), plain(param.textOf('array'))] : []),
    ...(standard ? [plain(' = '), { html: writer.code(standard), length: standard.length }] : [])]);
}

/** @param {Symbol} symbol @param {Writer} writer @returns {string} HTML */
function callable({ element, short }, writer) {
  const { attributes: is } = element;
  const specifiers = [is.static === 'yes' && 'static', is.virt && is.virt !== 'non-virtual' && 'virtual', is.explicit === 'yes' && 'explicit', is.constexpr === 'yes' && 'constexpr'].filter(Boolean).map((word) => `${word} `).join('');
  const own = parametersOf(element);
  const type = typed(element.one('type'), writer, own);
  const before = joined([plain(specifiers), type, plain(type.length > 0 ? ' ' : ''), plain(short, 'b')]);
  const args = element.textOf('argsstring');
  const after = args.slice(args.lastIndexOf(')') + 1).replace(/\s*=\s*/, ' = ').replace(/^(?=\w)/, ' ').replace('noexcept', ' noexcept').replace(/ +/g, ' ');
  const parameters = element.all('param').map((param) => parameter(param, writer, own));
  const length = before.length + after.length + 2 + parameters.reduce((sum, one) => sum + one.length + 2, 0);
  const isLong = length > MAX_WIDTH && parameters.length > 0;
  const end = `)${escaped(after)}`;
  const closed = parameters.map(({ html }, i) => html + (i < parameters.length - 1 ? ',' : end));
  const list = isLong ? closed.map((html) => `\n    ${html}`).join('') : closed.map((html) => `<span>${html}</span>`).join(' ');
  return `${template(element, writer)}${before.html}(${list || end}`;
}

/** A variable's declaration after its type. @param {Symbol} symbol @param {Writer} writer @param {string} [id] @returns {string} HTML */
export function declarator({ element, short }, writer, id) {
  const value = element.textOf('initializer').replace(/\s+/g, ' ').replace(/^=? ?/, (sign) => (sign.includes('=') ? ' = ' : ''));
  return `<var${attributes({ id })}>${escaped(short)}</var>${escaped(element.textOf('argsstring'))}${writer.code(value)}`;
}

/** @param {Symbol} symbol @param {Writer} writer @returns {string} HTML */
function variable(symbol, writer) {
  const { element } = symbol;
  const specifiers = `${element.attributes.static === 'yes' ? 'static ' : ''}${element.attributes.constexpr === 'yes' ? 'constexpr ' : ''}`;
  return `${specifiers}${typed(element.one('type'), writer, parametersOf(element)).html} ${declarator(symbol, writer)}`;
}

/** @param {Symbol} symbol @param {Writer} writer @returns {string} HTML; empty for a type that has only a name */
export function signature(symbol, writer) {
  const { kind, element, short } = symbol;
  const typeBefore = template(element, writer);
  switch (kind) {
    case 'function': case 'constructor': return callable(symbol, writer);
    case 'variable': return variable(symbol, writer);
    case 'alias': return `${typeBefore}using <b>${escaped(short)}</b> = ${typed(element.one('type'), writer, parametersOf(element)).html}`;
    case 'enum': return '';
    default: {
      const bases = element.all('basecompoundref').filter((base) => base.attributes.prot === 'public').map((base) => writer.reference(base.attributes.refid ?? '', base.text.replace(/^gaitsmith::/, '')));
      return typeBefore || bases.length > 0 ? `${typeBefore}${kind} <b>${escaped(short)}</b>${bases.length > 0 ? ` : public ${bases.join(', public ')}` : ''}` : '';
    }
  }
}
