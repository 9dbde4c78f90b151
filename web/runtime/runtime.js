// SPDX-License-Identifier: MIT
// Gaitsmith's controllers for games: the game moves the figure with its own physics, and every 0.01 s the controller decides
// where the joints should go. docs/runtime.md has an example. The same as core/runtime/gaitsmith.h, with the same bits.

/** @typedef {import('./runtime.d.ts').Controller} Controller */
/** @typedef {import('./runtime.d.ts').State} State */

const f = Math.fround;
const TURN = 3.15;
const JUST_OUTSIDE = f(1.0000001192092896);

/** Why a text is not a controller. */
export class ControllerError extends Error {
  /** @param {'syntax' | 'range' | 'shape'} code @param {string} where  such as "rules[2].tau_s" */
  constructor(code, where) {
    super(`${where}: ${code}`);
    this.code = code;
    this.where = where;
  }
}

/** @param {any} value @param {string} where @param {number} low @param {number} high */
function number(value, where, low, high) {
  if (typeof value !== 'number') throw new ControllerError('syntax', where);
  if (!(value >= low && value <= high)) throw new ControllerError('range', where);
  return f(value);
}

/** @param {any} value @param {string} where @param {string[]} names */
function word(value, where, names) {
  if (!names.includes(value)) throw new ControllerError(typeof value === 'string' ? 'range' : 'syntax', where);
  return names.indexOf(value);
}

/**
 * @template T @param {any} value @param {string} where @param {number} most @param {(value: any, where: string) => T} read
 * @param {number} [known]  its length, if that must be a certain one
 */
function list(value, where, most, read, known = value?.length) {
  if (!Array.isArray(value)) throw new ControllerError('syntax', where);
  if (value.length > most) throw new ControllerError('range', where);
  if (value.length !== known) throw new ControllerError('shape', where);
  return value.map((one, i) => read(one, `${where}[${i}]`));
}

/** @param {any} value @param {string} where @param {number} most @param {number} largest @param {number} [known] */
const numbers = (value, where, most, largest, known) =>
  Float32Array.from(list(value, where, most, (one, at) => number(one, at, -largest, largest), known));

/** The ranges of numbers. @type {Record<string, [number, number]>} */
const RANGES = {
  min_rad: [-TURN, TURN], max_rad: [-TURN, TURN], tau_s: [0.01, 100], decay: [0, 1], threshold_rad: [-TURN, TURN], empty_rad: [-TURN, TURN],
  span_rad: [-2 * TURN, 2 * TURN], charging: [0, 1], at_zero: [-1e30, 1e30], at_one: [-1e30, 1e30], step_s: [0.001, 1], period_steps: [2, 1e6], version: [1, 1],
};

/** Numbers of an object by name. @param {any} from @param {string} where @param {string} names @returns {Record<string, number>} */
function members(from, where, names) {
  if (typeof from !== 'object' || from === null) throw new ControllerError('syntax', where);
  return Object.fromEntries(names.split(' ').map((name) => {
    const at = where ? `${where}.${name}` : name;
    if (!(name in from)) throw new ControllerError('shape', at);
    return [name, number(from[name], at, ...RANGES[name])];
  }));
}

/** Reads a controller, made by gaitsmith export --controller. Throws a ControllerError. @param {string} text @returns {Controller} */
export function load(text) {
  let json;
  try { json = JSON.parse(text); } catch { throw new ControllerError('syntax', ''); }
  const { version: _, step_s } = members(json, '', 'version step_s');
  const kind = /** @type {const} */ (['rules', 'network', 'trajectory'])[word(json.kind, 'kind', ['rules', 'network', 'trajectory'])];
  const joints = list(json.joints, 'joints', 15, (one, where) =>
    ({ ...one, ...members(one, where, `min_rad max_rad${kind === 'network' ? ' tau_s decay threshold_rad empty_rad span_rad' : ''}`) }));
  const senses = list(json.senses, 'senses', 43, (one, where) =>
    ({ ...one, ...members(one, where, 'at_zero at_one'), clip: word(one.clip, `${where}.clip`, ['none', 'above', 'both']) }));
  const period = 'period_steps' in json ? members(json, '', 'period_steps').period_steps : 0;
  const controller = { ...json, kind, step_s, joints, senses, period, rests: false };
  let units = 0;
  if (kind === 'rules') {
    controller.rules = list(json.rules, 'rules', 32, (one, where) => ({
      ...members(one, where, 'tau_s decay'),
      targets: numbers(one.targets_rad, `${where}.targets_rad`, 15, TURN, joints.length),
      when: list(one.when, `${where}.when`, 43, (interval, at) => {
        const [sense, middle, inverse] = numbers(interval, at, 3, 1e6, 3);
        if (!(sense in senses)) throw new ControllerError('shape', at);
        return { sense, middle, inverse };
      }),
    }));
    units = controller.rules.length;
    if (period > 0 && senses.length !== 1) throw new ControllerError('shape', 'senses');
  } else if (kind === 'network') {
    const count = Array.isArray(json.nodes) ? json.nodes.length : 0;
    units = count - joints.length;
    controller.nodes = list(json.nodes, 'nodes', 47, (one, where) => ({
      ...members(one, where, 'charging'),
      weights: numbers(one.weights, `${where}.weights`, 64, 2, senses.length + units),
    }));
    if (period > 0 || senses.length < joints.length) throw new ControllerError('shape', 'senses');
  } else {
    Object.assign(controller, members(json, '', 'tau_s decay period_steps'));
    controller.rests = word(json.at_end, 'at_end', ['repeat', 'rest']) === 1;
    controller.knots = list(json.knots_rad, 'knots_rad', 32, (one, where) => numbers(one, where, 15, TURN, joints.length));
    units = controller.knots.length;
  }
  if (units < 1) throw new ControllerError('shape', kind);
  if (!Number.isInteger(period)) throw new ControllerError('shape', 'period_steps');
  controller.units = units;
  return controller;
}

/** A reading, in the unit of the sense, as the controller senses it. @param {Controller} controller @param {number} sense @param {number} reading */
export function normalise({ senses }, sense, reading) {
  const { at_zero, at_one, clip } = senses[sense];
  const width = f(at_one - at_zero);
  const value = width > 0 ? f(f(f(reading) - at_zero) * f(1 / width)) : 0;
  if (clip > 0 && !(value < 1)) return 1;
  return clip > 1 && !(value > 0) ? 0 : value;
}

/** The rule whose intervals hold the senses most deeply. Of equals the first. If none does, the active one stays. @param {Controller} controller @param {State} state @param {ArrayLike<number>} senses */
function choose({ rules }, state, senses) {
  let least = JUST_OUTSIDE;
  rules.forEach(({ when }, rule) => {
    let off = 0;
    for (const { sense, middle, inverse } of when) {
      const from = f(Math.abs(f(f(senses[sense]) - middle)) * inverse);
      if (from > off) off = from;
    }
    if (!(off < least)) return;
    least = off;
    state.rule = rule;
  });
}

/** Advances the nodes of a network, each from the outputs of the step before. @param {Controller} controller @param {State} state @param {ArrayLike<number>} senses */
function think({ senses: { length }, joints, nodes, units }, state, senses) {
  const { input, charge } = state;
  const touches = length - joints.length;
  for (let i = 0; i < length; ++i) input[i] = f(senses[i]) > (i < touches ? 0 : joints[i - touches].threshold_rad) ? 1 : 0;
  nodes.forEach(({ charging, weights }, i) => {
    let sum = 0;
    weights.forEach((weight, k) => { if (input[k] > 0) sum = f(sum + weight); });
    const now = f(charge[i] + (sum > 0 ? charging : -charging));
    charge[i] = now < 1 ? now > 0 ? now : 0 : 1;
  });
  state.rule = 0;
  for (let i = 0; i < units; ++i) {
    if (charge[i] >= 1) input[length + i] = 1;
    if (charge[i] <= 0) input[length + i] = 0;
    state.rule += input[length + i];
  }
}

/** The angles of a trajectory in the middle of the step that begins, by cubic B-splines. @param {Controller} controller @param {State} state */
function follow({ knots, units, period, rests, joints }, state) {
  const rate = (rests ? units - 1 : units) / period;
  state.rule = Math.floor(state.steps * rate + 0.5) % units;
  const place = (rests ? Math.min(state.steps + 0.5, period) : state.steps + 0.5) * rate;
  const first = Math.floor(place);
  const x = place - first;
  const y = 1 - x;
  const near = (/** @type {number} */ z) => (4 - 6 * z * z + 3 * z * z * z) / 6;
  const weights = [y * y * y / 6, near(x), near(y), x * x * x / 6];
  joints.forEach((_, j) => {
    let target = 0;
    weights.forEach((weight, i) => {
      const k = first - 1 + i;
      // Around a circle, or mirrored at the ends.
      const knot = !rests ? (k + units) % units : k < 0 ? -k : k < units ? k : 2 * (units - 1) - k;
      target = f(target + f(knots[Math.max(0, Math.min(knot, units - 1))][j] * f(weight)));
    });
    state.target[j] = target;
  });
}

/** Sets targets and time constants. @param {Controller} controller @param {State} state */
function ask(controller, state) {
  const { kind, rules, joints, units } = controller;
  if (kind === 'trajectory') follow(controller, state);
  joints.forEach((joint, j) => {
    const from = kind === 'rules' ? rules[state.rule] : kind === 'network' ? joint : controller;
    if (kind === 'rules') state.target[j] = rules[state.rule].targets[j];
    if (kind === 'network') state.target[j] = joint.empty_rad + f(joint.span_rad * state.charge[units + j]);
    state.tau[j] = from.tau_s;
    state.decay[j] = from.decay;
  });
}

/** The state of one figure whose controller takes over. @param {Controller} controller @returns {State} */
export function begin(controller) {
  const floats = () => new Float32Array(controller.joints.length);
  const state = { rule: 0, target: floats(), tau: floats(), decay: floats(), steps: 0, input: new Float32Array(64), charge: new Float32Array(47) };
  ask(controller, state);
  return state;
}

/** Decides, after each step of the physics. @param {Controller} controller @param {State} state @param {ArrayLike<number>} [senses]  not needed with a timer */
export function step(controller, state, senses = []) {
  const { kind, period, rests } = controller;
  if (period > 0 && ++state.steps >= period) state.steps = rests ? period : 0;
  if (kind === 'rules') choose(controller, state, period > 0 ? [f(state.steps / period)] : senses);
  if (kind === 'network') think(controller, state, senses);
  ask(controller, state);
}

/** Moves a joint as Gaitsmith's strong joints move in a step. @param {Controller} controller @param {State} state @param {number} joint @param {{angle: number, rate: number}} body */
export function move({ joints, step_s }, state, joint, body) {
  const { min_rad, max_rad } = joints[joint];
  const target = state.target[joint];
  const decay = state.decay[joint];
  const hurry = f(1 / state.tau[joint]);
  const off = f(f(body.angle) - target);
  const pull = f(f(f(body.rate) + f(off * hurry)) * step_s);
  const now = f(target + f(f(off + pull) * decay));
  const rate = f(f(f(body.rate) - f(pull * hurry)) * decay);
  body.angle = now < min_rad ? min_rad : now > max_rad ? max_rad : now;
  body.rate = body.angle !== now || Math.abs(rate) < f(1e-9) ? 0 : rate;
}
