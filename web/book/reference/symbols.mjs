// SPDX-License-Identifier: MIT
// The public declarations of headers: types with public members, enumerations, functions, constants.
import { HEADER_SPACE } from './names.mjs';

/** @typedef {import('./xml.mjs').Element} Element */
/** @typedef {'class' | 'struct' | 'enum' | 'alias' | 'function' | 'constructor' | 'variable'} Kind */
/**
 * @typedef {object} Symbol
 * @property {Kind} kind
 * @property {string} name    with its enclosing types
 * @property {string} short   without them
 * @property {string} file    its header
 * @property {number} line
 * @property {Element} element  Doxygen's
 * @property {Symbol[]} members  of a class or struct
 * @property {Symbol[]} others   more functions of the same name
 * @property {string} id        on its page
 */

/** @type {Record<string, Kind>} */
const KINDS = { class: 'class', struct: 'struct', enum: 'enum', typedef: 'alias', function: 'function', friend: 'function', variable: 'variable' };
/** Names of operators in anchors. @type {Record<string, string>} */
const OPERATORS = { '==': 'equal', '!=': 'unequal', '<': 'less', '>': 'greater', '=': 'assign', '()': 'call', '[]': 'at', '+': 'plus', '-': 'minus', '*': 'times' };

/** Whether the compiler writes it, or programs never call it by name. @param {Element} member @param {string} outer  the enclosing type */
function isNoise(member, outer) {
  const name = member.textOf('name');
  const [first, ...more] = member.all('param').map((param) => param.textOf('type').replace(/^const |[\s&]+$/g, ''));
  const isCopy = more.length === 0 && first === outer.split('::').pop() && (name === first || name === 'operator=');
  return isCopy || name.startsWith('~') || name.startsWith('GAITSMITH_') || /=\s*(default|delete)$/.test(member.textOf('argsstring'));
}

/** @param {Element} element @param {string} outer  the enclosing type @returns {Symbol | undefined} */
function symbolOf(element, outer) {
  const place = element.one('location')?.attributes;
  const kind = KINDS[element.attributes.kind];
  if (!kind || !place?.file) return undefined;
  const short = element.textOf('name') || element.textOf('compoundname').split('::').pop() || '';
  const isConstructor = kind === 'function' && short === outer.split('::').pop();
  return { kind: isConstructor ? 'constructor' : kind, name: outer ? `${outer}::${short}` : short, short, file: place.file, line: Number(place.line), element, members: [], others: [], id: '' };
}

/** Whether the type has a default operator==. @param {Element} compound */
export const isComparable = (compound) => compound.all('sectiondef').flatMap((section) => section.all('memberdef'))
  .some((member) => member.textOf('name') === 'operator==' && /=\s*default$/.test(member.textOf('argsstring')));

/** @param {Element} compound @param {string} outer @returns {Symbol[]} in the order of the file */
function membersOf(compound, outer) {
  return compound.all('sectiondef')
    .flatMap((section) => section.all('memberdef'))
    .filter((member) => (member.attributes.prot ?? 'public') === 'public' && !isNoise(member, outer))
    .flatMap((member) => symbolOf(member, outer) ?? [])
    .sort((a, b) => a.line - b.line);
}

/** Merges functions of the same name into the first one. @param {Symbol[]} symbols */
function merged(symbols) {
  /** @type {Symbol[]} */
  const out = [];
  for (const symbol of symbols) {
    const same = out.find(({ kind, name }) => (kind === 'function' || kind === 'constructor') && kind === symbol.kind && name === symbol.name);
    if (same) same.others.push(symbol);
    else out.push(symbol);
  }
  return out;
}

/** @param {string} name @param {Map<string, number>} taken */
function anchor(name, taken) {
  const plain = name.toLowerCase().replace(/operator(.+)$/, (_, sign) => `operator-${OPERATORS[sign] ?? 'of'}`).replaceAll('::', '-').replace(/[^a-z0-9_-]/g, '');
  const count = taken.get(plain) ?? 0;
  taken.set(plain, count + 1);
  return count === 0 ? plain : `${plain}-${count}`;
}

/** @param {Element[]} compounds @returns {Map<string, Symbol[]>} by header */
export function symbolsOf(compounds) {
  /** @type {Symbol[]} */
  const all = [];
  const hidden = compounds.filter(({ attributes }) => attributes.prot && attributes.prot !== 'public').map((compound) => compound.textOf('compoundname'));
  for (const compound of compounds) {
    const whole = compound.textOf('compoundname');
    const name = whole.slice(HEADER_SPACE.length + 2);
    if (whole === HEADER_SPACE) {
      all.push(...membersOf(compound, ''));
    } else if (whole.startsWith(`${HEADER_SPACE}::`) && !/<|detail/.test(name) && !hidden.some((one) => whole === one || whole.startsWith(`${one}::`))) {
      const type = symbolOf(compound, name.split('::').slice(0, -1).join('::'));
      if (!type) continue;
      const members = membersOf(compound, name);
      type.members = merged(members.filter(({ kind }) => kind !== 'enum'));
      all.push(type, ...members.filter(({ kind }) => kind === 'enum'));
    }
  }
  /** @type {Map<string, Symbol[]>} */
  const byHeader = new Map();
  for (const symbol of all.sort((a, b) => a.line - b.line)) byHeader.set(symbol.file, [...byHeader.get(symbol.file) ?? [], symbol]);
  for (const [header, symbols] of byHeader) {
    const whole = merged(symbols);
    /** @type {Map<string, number>} */
    const taken = new Map([['main', 1]]);
    for (const symbol of whole.flatMap((one) => [one, ...one.members])) symbol.id = anchor(symbol.name, taken);
    byHeader.set(header, whole);
  }
  return byHeader;
}
