// SPDX-License-Identifier: MIT
// The types of runtime.js. docs/runtime.md explains it.

export interface Joint {
  readonly name: string;
  /** The rod that it turns, in figure.rods; -1: it is a muscle. */
  readonly rod: number;
  /** Of a figure of springs: the spring that is this muscle, in figure.springs. */
  readonly spring?: number;
  /** Limits, from the drawn pose [rad], or of a muscle's rest, over its drawn length. */
  readonly min_rad: number;
  readonly max_rad: number;
  /** Of joints of limited strength [N m]. */
  readonly greatest_torque_nm?: number;
  // Of a network only.
  readonly tau_s: number;
  readonly decay: number;
  readonly threshold_rad: number;
  readonly empty_rad: number;
  readonly span_rad: number;
}

export interface Sense {
  /** Such as "angle 1", "force 3", "height". */
  readonly name: string;
  readonly unit: string;
  /** The readings that are sensed as 0 and 1. */
  readonly at_zero: number;
  readonly at_one: number;
  /** Clipped: not at all, to at most 1, or to 0 and 1. */
  readonly clip: 0 | 1 | 2;
}

export interface Rule {
  readonly tau_s: number;
  readonly decay: number;
  readonly targets: Float32Array;
  readonly when: readonly { readonly sense: number; readonly middle: number; readonly inverse: number }[];
}

export interface Rod {
  readonly length_m: number;
  readonly mass_kg: number;
  /** The rod to which it is attached, -1 for the root. */
  readonly parent: number;
  readonly parent_end: 'start' | 'end';
  /** The drawn angle to its parent, or of the root to the horizontal, counterclockwise [rad]. */
  readonly rest_rad: number;
}

export interface Node {
  readonly x_m: number;
  readonly y_m: number;
  readonly mass_kg: number;
}

export interface Spring {
  readonly from: number;
  readonly to: number;
  readonly drawn_m: number;
  readonly stiffness_npm: number;
  readonly damping_nspm: number;
  readonly rest: number;
}

/** A controller. Any number of figures can share it. */
export interface Controller {
  readonly kind: 'rules' | 'network' | 'trajectory';
  readonly title: string;
  readonly name: string;
  readonly step_s: number;
  readonly joints: readonly Joint[];
  readonly senses: readonly Sense[];
  /** Of rods, or of nodes and springs; then there are no rods in the list. */
  readonly figure: { readonly name: string; readonly rods: readonly Rod[]; readonly nodes?: readonly Node[]; readonly springs?: readonly Spring[] };
  readonly world: { readonly gravity_mps2: number; readonly friction: number };
  /** With sight: to which side of the figure "ahead" and "corner" are. */
  readonly facing?: 'right' | 'left';
  /** Of a timer or a trajectory, in steps. 0: none. */
  readonly period: number;
  /** Whether a trajectory rests after its period. */
  readonly rests: boolean;
  /** Number of rules, hidden nodes or knots. */
  readonly units: number;
  readonly rules: readonly Rule[];
  readonly nodes: readonly { readonly charging: number; readonly weights: Float32Array }[];
  readonly knots: readonly Float32Array[];
  // Of a trajectory only.
  readonly tau_s: number;
  readonly decay: number;
}

/** What the controller of one figure asks for, by joint, and what it remembers. */
export interface State {
  /** The active rule, from 0. Of a network the number of hidden nodes that fire, of a trajectory the nearest knot. */
  rule: number;
  /** From the drawn pose, counterclockwise [rad]. Of a muscle: its length without force [drawn lengths]. */
  readonly target: Float32Array;
  /** Time constants [s]. */
  readonly tau: Float32Array;
  /** exp(-step_s / tau) */
  readonly decay: Float32Array;
  steps: number;
  readonly input: Float32Array;
  readonly charge: Float32Array;
}

/** Why a text is not a controller. */
export class ControllerError extends Error {
  constructor(code: ControllerError['code'], where: string);
  /** Not JSON or another type; a number, word or length out of range; parts that are missing or do not fit together. */
  readonly code: 'syntax' | 'range' | 'shape';
  /** The part, such as "rules[2].tau_s". */
  readonly where: string;
}

/** Reads a controller that `gaitsmith export DOC --controller` wrote. Throws a ControllerError. */
export function load(text: string): Controller;
/** A figure's controller takes over: with its first rule, at time 0. */
export function begin(controller: Controller): State;
/** Decides, after each step of the physics. @param senses in the order of controller.senses; not needed with a timer or for a trajectory */
export function step(controller: Controller, state: State, senses?: ArrayLike<number>): void;
/** A reading, in the sense's unit, as the controller senses it. */
export function normalise(controller: Controller, sense: number, reading: number): number;
/** Moves a joint for a step as Gaitsmith's strong joints move: critically damped, within its limits. @param body [rad], from the drawn pose, and [rad/s]; of a muscle its length without force [drawn lengths], from its spring's rest on, and [1/s] */
export function move(controller: Controller, state: State, joint: number, body: { angle: number; rate: number }): void;
