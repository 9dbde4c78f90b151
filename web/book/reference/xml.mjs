// SPDX-License-Identifier: MIT
// Parses XML into a tree with text and elements in their original order.
import { XMLParser } from 'fast-xml-parser';

const parser = new XMLParser({ preserveOrder: true, ignoreAttributes: false, attributeNamePrefix: '', trimValues: false, parseTagValue: false });

export class Element {
  /** @param {string} name @param {Record<string, string>} attributes @param {(Element | string)[]} children */
  constructor(name, attributes, children) {
    this.name = name;
    this.attributes = attributes;
    this.children = children;
  }

  /** @returns {Element[]} the child elements with this name */
  all(/** @type {string} */ name) {
    return this.children.filter(/** @returns {child is Element} */ (child) => typeof child !== 'string' && child.name === name);
  }

  /** @param {string} name @returns {Element | undefined} */
  one(name) {
    return this.all(name)[0];
  }

  /** @returns {string} the text of all descendants */
  get text() {
    return this.children.map((child) => (typeof child === 'string' ? child : child.text)).join('');
  }

  /** The text of the first child element with this name. @param {string} name */
  textOf(name) {
    return this.one(name)?.text.trim() ?? '';
  }
}

/** @param {string} xml @returns {Element} */
export function parsed(xml) {
  return new Element('', {}, parser.parse(xml).flatMap(node));
}

/** @param {any} raw @returns {(Element | string)[]} */
function node(raw) {
  if ('#text' in raw) return [String(raw['#text'])];
  const name = Object.keys(raw).find((key) => key !== ':@');
  return name === undefined || name.startsWith('?') ? [] : [new Element(name, raw[':@'] ?? {}, raw[name].flatMap(node))];
}
