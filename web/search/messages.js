// SPDX-License-Identifier: MIT
// Every message between page, coordinator and evaluators, in one place, and the help to handle them all.
//
//   page ──PageToCoordinator──▶ coordinator ──CoordinatorToEvaluator──▶ evaluator 1..N
//        ◀─CoordinatorToPage───             ◀─EvaluatorToCoordinator───
//   page ──Role──▶ any worker ──Ready──▶ page
//   page ──MapTransitions──▶ mapper ──MapperToPage──▶ page
//
// The page starts one coordinator and N evaluators; coordinator and evaluator talk through a MessagePort of
// their own, so the page's thread has no part in the search's loop. Typed arrays are transferred wherever the
// sender has no more use for them. After 'failed' or 'finished' the page ends the workers; or, when the search was
// done, gives them roles in the next one. Since workers outlive searches, what concerns a search says which run of it:
// what comes late, or twice, is not taken for the next one's. Whatever is lost is noticed by somebody's silence.

/** @typedef {import('./engine.js').Fault} Fault */
/** @typedef {import('./engine.js').Spread} Spread */

// ---- page → new worker ----

/** Load what any role needs, and wait for one. No reply. @typedef {{type: 'stand-by', engine: WebAssembly.Module}} StandBy */

/**
 * Be the coordinator: run the document's search. Reply: 'ready', then CoordinatorToPage messages; 'failed' if
 * core refuses the document.
 * @typedef {object} Coordinate
 * @property {'coordinate'} type
 * @property {number} run                 not 0, another one for every role of this kind that the page gives out
 * @property {WebAssembly.Module} engine  compiled once, by the page
 * @property {Uint8Array} document        core/document/binary.h
 * @property {Uint8Array | null} state    of a checkpoint to continue from
 * @property {number} workers             evaluators to reckon with: sets the size of a batch, not the result
 */

/**
 * Be an evaluator: score what arrives at `port`. Reply: 'ready'; 'failed' if core refuses the document.
 * @typedef {object} Evaluate
 * @property {'evaluate'} type
 * @property {number} run                 that of the coordinator
 * @property {WebAssembly.Module} engine
 * @property {Uint8Array} document
 * @property {MessagePort} port           transferred; its other end goes to the coordinator
 */

/**
 * Be the mapper: score every moment at which the clip that the document's search names could take over. Reply: 'ready',
 * then 'mapped' until all are told; 'failed' if core refuses the document. Another role ends it.
 * @typedef {object} MapTransitions
 * @property {'map-transitions'} type
 * @property {WebAssembly.Module} engine
 * @property {Uint8Array} document
 * @property {number} generation          of the map, for its replies: those of another one are outdated
 */

/** The first message to every worker, and later ones when a search is done. @typedef {StandBy | Coordinate | Evaluate | MapTransitions} Role */

// ---- page → coordinator ----

/**
 * Another evaluator stands ready at `port` (transferred). No reply.
 * @typedef {{type: 'add-evaluator', evaluator: number, port: MessagePort}} AddEvaluator
 */
/** That evaluator is dead: what it was doing must be done again. No reply. @typedef {{type: 'remove-evaluator', evaluator: number}} RemoveEvaluator */
/** Hand out no more work. Reply: 'progress' with state 'paused'. @typedef {{type: 'pause'}} Pause */
/** Go on. Reply: 'progress' with state 'running'. @typedef {{type: 'resume'}} Resume */
/** End here. Reply: 'finished' with state 'stopped'. @typedef {{type: 'stop'}} Stop */

/** @typedef {AddEvaluator | RemoveEvaluator | Pause | Resume | Stop} Wish */
/** @typedef {Wish & {run: number}} PageToCoordinator */

// ---- any worker → page ----

/** Its scripts are here; the first message of every worker. @typedef {{type: 'loaded'}} Loaded */
/** The role is taken. @typedef {{type: 'ready'}} Ready */
/** Core refused what it was given; another worker would fail alike. @typedef {{type: 'failed', fault: Fault}} Failed */

// ---- coordinator → page ----

/**
 * How far a search is.
 * @typedef {object} SearchReport
 * @property {'running' | 'paused' | 'done' | 'stopped'} state
 * @property {number} evaluations    of the serial algorithm
 * @property {number} budget
 * @property {number} simulated      motions simulated by these workers, those looked ahead in vain included
 * @property {number} rate           evaluations per second of the last seconds; 0 when not known yet
 * @property {number} secondsLeft    0 when not known yet
 * @property {number} bestFitness
 * @property {Uint16Array | null} bestGenome  null when it is that of the last report
 * @property {Uint8Array | null} curve        as core stores it; null when it is that of the last report
 * @property {Spread | null} spread           of the population now; null when there is none
 * @property {Uint8Array | null} saved        the state of the whole search, at its end; else null
 */

/**
 * At most 30 a second, at least one in a second; with the evaluators that have work from here.
 * @typedef {{type: 'progress', report: SearchReport, evaluators: number[]}} Progress
 */
/** The last message of a search; its report has everything. @typedef {{type: 'finished', report: SearchReport}} Finished */
/**
 * The whole state of the search, about once a second: a new coordinator continues from it.
 * @typedef {{type: 'checkpoint', state: Uint8Array, evaluations: number}} Checkpoint
 */
/**
 * An evaluator gave no answer for too long; its work has been taken back. Reply: 'add-evaluator' with its
 * replacement.
 * @typedef {{type: 'silent', evaluator: number}} Silent
 */

/** @typedef {Ready | Failed | Progress | Finished | Checkpoint | Silent} OfCoordinator */
/** @typedef {Loaded | OfCoordinator & {run: number}} CoordinatorToPage */
/** @typedef {Loaded | (Ready | Failed) & {run: number}} EvaluatorToPage */

// ---- mapper → page ----

/**
 * A part of the map, about five a second.
 * @typedef {object} Mapped
 * @property {'mapped'} type
 * @property {number} generation
 * @property {number} count          moments of the whole map
 * @property {number} first          place of the first score in the map's order, coarse first
 * @property {Float32Array} scores
 * @property {number} usual          what the controller reaches from the start
 */
/** @typedef {Ready | Failed | Mapped} OfMapper */
/** @typedef {Loaded | OfMapper} MapperToPage */

// ---- coordinator ↔ evaluator ----

/**
 * Score these genomes, which lie one after another (transferred). Reply: 'scored' with the same slice.
 * @typedef {{type: 'score', slice: number, genomes: Uint16Array}} Score
 */
/** SCORE_LENGTH numbers for each genome. @typedef {{type: 'scored', slice: number, scores: Float32Array}} Scored */

/** @typedef {Score} CoordinatorToEvaluator */
/** @typedef {Scored} EvaluatorToCoordinator */

/**
 * For the default branch of a switch over a message's type: tsc rejects a branch that is forgotten, and a
 * message from a newer page is an error rather than silence.
 * @param {never} message
 * @returns {never}
 */
export function unreachable(message) {
  throw new Error(`unknown message: ${JSON.stringify(message)}`);
}
