// SPDX-License-Identifier: MIT
// Every message between page, coordinator and evaluators.
//
//   page ──PageToCoordinator──▶ coordinator ──CoordinatorToEvaluator──▶ evaluator 1..N
//        ◀─CoordinatorToPage───             ◀─EvaluatorToCoordinator───
//   page ──Role──▶ any worker ──Ready──▶ page
//   page ──MapTransitions──▶ mapper ──MapperToPage──▶ page
//
// The page starts one coordinator and N evaluators. Coordinator and evaluator communicate through their own
// MessagePort, so the search's loop does not involve the page's thread. Typed arrays are transferred if the sender no
// longer needs them. After 'failed' or 'finished' the page ends the workers, or, if the search was done, gives them
// roles in the next one. Since workers outlive searches, every message about a search has its run number. So a late or
// repeated message is not mistaken for one of the next search. A timeout detects a lost message.

/** @typedef {import('./engine.js').Fault} Fault */
/** @typedef {import('./engine.js').Spread} Spread */

// ---- page → new worker ----

/**
 * Load what every role needs, and wait for a role. No reply.
 * @typedef {{type: 'stand-by', engine: WebAssembly.Module}} StandBy
 */

/**
 * Be the coordinator and run the document's search. Reply: 'ready', then CoordinatorToPage messages, or 'failed' if
 * core refuses the document.
 * @typedef {object} Coordinate
 * @property {'coordinate'} type
 * @property {number} run                 not 0; unique among the roles of this kind that the page assigns
 * @property {WebAssembly.Module} engine  compiled once, by the page
 * @property {Uint8Array} document        core/document/binary.h
 * @property {Uint8Array | null} state    of a checkpoint to continue from
 * @property {number} workers             expected number of evaluators: sets the size of a batch, not the result
 * @property {boolean} [breeds]           whether the document is a nursery, whose children are wanted
 */

/**
 * Be an evaluator and score genomes that arrive at `port`. Reply: 'ready', or 'failed' if core refuses the document.
 * @typedef {object} Evaluate
 * @property {'evaluate'} type
 * @property {number} run                 the coordinator's
 * @property {WebAssembly.Module} engine
 * @property {Uint8Array} document
 * @property {MessagePort} port           transferred; the coordinator gets the other end
 * @property {boolean} [breeds]           whether traits are measured, too
 */

/**
 * Be the mapper and score every moment at which the clip named by the document's search could take over. Reply:
 * 'ready', then 'mapped' until all scores are sent, or 'failed' if core refuses the document. A new role ends this one.
 * @typedef {object} MapTransitions
 * @property {'map-transitions'} type
 * @property {WebAssembly.Module} engine
 * @property {Uint8Array} document
 * @property {number} generation          of the map, repeated in its replies; replies of other generations are outdated
 */

/**
 * The first message to every worker. Another role may follow when a search is done.
 * @typedef {StandBy | Coordinate | Evaluate | MapTransitions} Role
 */

// ---- page → coordinator ----

/**
 * A new evaluator is ready at `port` (transferred). No reply.
 * @typedef {{type: 'add-evaluator', evaluator: number, port: MessagePort}} AddEvaluator
 */
/**
 * An evaluator has died: score its genomes again. No reply.
 * @typedef {{type: 'remove-evaluator', evaluator: number}} RemoveEvaluator
 */
/** Send out no more work. Reply: 'progress' with state 'paused'. @typedef {{type: 'pause'}} Pause */
/** Continue. Reply: 'progress' with state 'running'. @typedef {{type: 'resume'}} Resume */
/** Stop the search. Reply: 'finished' with state 'stopped'. @typedef {{type: 'stop'}} Stop */

/** @typedef {AddEvaluator | RemoveEvaluator | Pause | Resume | Stop} SearchRequest */
/** @typedef {SearchRequest & {run: number}} PageToCoordinator */

// ---- any worker → page ----

/** The worker's scripts are loaded. The first message of every worker. @typedef {{type: 'loaded'}} Loaded */
/** The worker has started its role. @typedef {{type: 'ready'}} Ready */
/**
 * Core refused the data; another worker would fail in the same way. @typedef {{type: 'failed', fault: Fault}} Failed
 */

// ---- coordinator → page ----

/**
 * The progress of a search.
 * @typedef {object} SearchReport
 * @property {'running' | 'paused' | 'done' | 'stopped'} state
 * @property {number} evaluations    of the serial algorithm
 * @property {number} budget
 * @property {number} simulated      motions simulated by these workers, including look-ahead that was not used
 * @property {number} rate           evaluations per second over the last seconds; 0 while unknown
 * @property {number} secondsLeft    0 while unknown
 * @property {number} bestFitness
 * @property {Uint16Array | null} bestGenome  null: as in the last report
 * @property {Uint16Array | null} attempt     a genome that was simulated since the last report, to be shown
 * @property {Uint8Array | null} curve        as core stores it; null: as in the last report
 * @property {Spread | null} spread           of the population now; null if there is none
 * @property {Uint8Array | null} saved        the state of the whole search at its end; else null
 */

/**
 * Sent at most 30 times a second and at least once a second. `evaluators` lists those that have work from this
 * coordinator.
 * @typedef {{type: 'progress', report: SearchReport, evaluators: number[]}} Progress
 */
/** The children of a brood. @typedef {import('./engine.js').Litter} Litter */
/**
 * The last message of a search, with a complete report, and the children if it breeds.
 * @typedef {{type: 'finished', report: SearchReport, litter: Litter | null}} Finished
 */
/**
 * The whole state of the search, about once a second, from which a new coordinator can continue.
 * @typedef {{type: 'checkpoint', state: Uint8Array, evaluations: number}} Checkpoint
 */
/**
 * An evaluator has not answered for too long, and its work was taken back. Reply: 'add-evaluator' with its replacement.
 * @typedef {{type: 'silent', evaluator: number}} Silent
 */

/** @typedef {Ready | Failed | Progress | Finished | Checkpoint | Silent} CoordinatorMessage */
/** @typedef {Loaded | CoordinatorMessage & {run: number}} CoordinatorToPage */
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
 * @property {number} usual          the controller's score from the start
 */
/** @typedef {Ready | Failed | Mapped} MapperMessage */
/** @typedef {Loaded | MapperMessage} MapperToPage */

// ---- coordinator ↔ evaluator ----

/**
 * Score these genomes, one after another in the array (transferred). Reply: 'scored' with the same slice.
 * @typedef {{type: 'score', slice: number, genomes: Uint16Array}} Score
 */
/** SCORE_LENGTH numbers for each genome. @typedef {{type: 'scored', slice: number, scores: Float32Array}} Scored */

/** @typedef {Score} CoordinatorToEvaluator */
/** @typedef {Scored} EvaluatorToCoordinator */

/**
 * For the default branch of a switch over a message's type: tsc rejects a missing branch, and an unknown message from a
 * newer page throws an error.
 * @param {never} message
 * @returns {never}
 */
export function unreachable(message) {
  throw new Error(`unknown message: ${JSON.stringify(message)}`);
}
