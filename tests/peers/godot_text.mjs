// SPDX-License-Identifier: MIT
// Reads a Godot scene as far as ours go, by the grammar that Godot documents for .tscn files: sections in brackets with
// attributes, then properties, whose values are numbers, strings, constructors, arrays and dictionaries.
import assert from 'node:assert/strict';

/** @typedef {{tag: string, attributes: Record<string, any>, properties: Record<string, any>}} Section */
/** A constructor such as Vector2(1, 2). @typedef {{type: string, args: any[]}} Made */

class Reader {
  at = 0;
  /** @param {string} text */
  constructor(text) { this.text = text; }

  space(pattern = /[ \t\r\n]*/y) {
    pattern.lastIndex = this.at;
    this.at += pattern.exec(this.text)?.[0].length ?? 0;
  }

  /** @param {RegExp} pattern  sticky */
  take(pattern) {
    pattern.lastIndex = this.at;
    const found = pattern.exec(this.text);
    assert.ok(found, `unexpected at ${this.at}: ${this.text.slice(this.at, this.at + 40)}`);
    this.at += found[0].length;
    return found[0];
  }

  /** @param {string} what */
  has(what) { return this.text.startsWith(what, this.at); }
  /** @param {string} what */
  expect(what) {
    assert.ok(this.has(what), `${what} is expected at ${this.at}: ${this.text.slice(this.at, this.at + 40)}`);
    this.at += what.length;
  }

  /** @returns {any} */
  value() {
    this.space();
    if (this.has('"')) return JSON.parse(this.take(/"(?:[^"\\]|\\.)*"/y));
    if (this.has('[')) return this.list('[', ']');
    if (this.has('{')) {
      this.expect('{');
      /** @type {Record<string, any>} */
      const members = {};
      for (this.space(); !this.has('}'); this.space()) {
        const key = this.value();
        this.space();
        this.expect(':');
        members[key] = this.value();
        this.space();
        if (!this.has('}')) this.expect(',');
      }
      this.expect('}');
      return members;
    }
    const word = this.take(/[-+.\w]+/y);
    if (this.has('(')) return { type: word, args: this.list('(', ')') };
    if (word === 'true' || word === 'false') return word === 'true';
    const number = Number(word);
    assert.ok(Number.isFinite(number), `${word} is no number`);
    return number;
  }

  /** @param {string} open @param {string} close */
  list(open, close) {
    this.expect(open);
    const items = [];
    for (this.space(); !this.has(close); this.space()) {
      items.push(this.value());
      this.space();
      if (!this.has(close)) this.expect(',');
    }
    this.expect(close);
    return items;
  }

  /** @returns {Section[]} */
  sections() {
    const all = [];
    for (this.space(); this.at < this.text.length; this.space()) {
      if (this.has('[')) {
        this.expect('[');
        const tag = this.take(/\w+/y);
        /** @type {Record<string, any>} */
        const attributes = {};
        for (this.space(/ */y); !this.has(']'); this.space(/ */y)) {
          const name = this.take(/\w+/y);
          this.expect('=');
          attributes[name] = this.value();
        }
        this.expect(']');
        all.push({ tag, attributes, properties: /** @type {Record<string, any>} */ ({}) });
      } else {
        const name = this.take(/[\w/]+/y);
        this.space(/ */y);
        this.expect('=');
        /** @type {Section} */ (all.at(-1)).properties[name] = this.value();
      }
    }
    return all;
  }
}

/** @param {Made} made @param {string} type @returns {any[]} */
function argumentsOf(made, type) {
  assert.equal(made.type, type);
  return made.args;
}

/** @param {string} text  of a .tscn file */
export function readScene(text) {
  const sections = new Reader(text).sections();
  const [head] = sections;
  assert.equal(head.tag, 'gd_scene');
  const resources = sections.filter(({ tag }) => tag === 'sub_resource');
  assert.equal(head.attributes.load_steps, resources.length + 1);
  const { format } = head.attributes;
  const reals = format === 2 ? 'PoolRealArray' : 'PackedFloat32Array';
  const animation = /** @type {Section} */ (resources.find(({ attributes }) => attributes.type === 'Animation')).properties;
  const nodes = sections.filter(({ tag }) => tag === 'node');
  const player = /** @type {Section} */ (nodes.find(({ attributes }) => attributes.type === 'AnimationPlayer')).properties;
  const played = format === 2 ? player['anims/motion'] : player.libraries[''];
  assert.ok(resources.some(({ attributes }) => attributes.id === played.args[0]));

  /** By the path of what they animate. @type {Map<string, {t: number, v: number[]}[]>} */
  const tracks = new Map();
  for (let i = 0; `tracks/${i}/type` in animation; i++) {
    const of = (/** @type {string} */ name) => animation[`tracks/${i}/${name}`];
    assert.equal(of('type'), 'value');
    const times = argumentsOf(of('keys').times, reals);
    assert.equal(argumentsOf(of('keys').transitions, reals).length, times.length);
    const values = of('keys').values.map((/** @type {any} */ value) => (typeof value === 'number' ? [value] : argumentsOf(value, 'Vector2')));
    assert.equal(values.length, times.length);
    tracks.set(argumentsOf(of('path'), 'NodePath')[0], times.map((t, k) => ({ t, v: values[k] })));
  }

  const paths = /** @type {string[]} */ ([]);
  const bones = nodes.filter(({ attributes }) => attributes.type === 'Bone2D').map(({ attributes, properties }) => {
    paths.push(`${attributes.parent}/${attributes.name}`);
    const [turns, places] = [tracks.get(`${paths.at(-1)}:rotation`), tracks.get(`${paths.at(-1)}:position`)];
    const still = argumentsOf(properties.position, 'Vector2');
    const rest = argumentsOf(properties.rest, 'Transform2D');
    // At rest as in the first frame.
    assert.ok(Math.hypot(rest[0] - Math.cos(properties.rotation), rest[1] - Math.sin(properties.rotation)) < 1e-5, `${paths.at(-1)}: ${rest} at ${properties.rotation} rad`);
    assert.deepEqual(rest.slice(4), still);
    return {
      parent: paths.indexOf(attributes.parent),
      length: format === 2 ? properties.default_length : properties.length,
      /** @param {number} s */
      at: (s) => {
        const [x, y] = places ? along(places, s) : still;
        return { x, y, turn: turns ? along(turns, s)[0] : properties.rotation };
      },
    };
  });
  return { format, title: animation.resource_name, length: animation.length, loops: animation.loop ?? animation.loop_mode === 1, bones };
}

/** The value of keys at a time, on the line between two. @param {{t: number, v: number[]}[]} keys @param {number} time */
export function along(keys, time) {
  const next = keys.findIndex(({ t }) => t >= time);
  if (next <= 0) return keys[next < 0 ? keys.length - 1 : 0].v;
  const [from, to] = [keys[next - 1], keys[next]];
  const share = (time - from.t) / (to.t - from.t);
  return from.v.map((v, i) => v + share * (to.v[i] - v));
}
