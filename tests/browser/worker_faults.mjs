// SPDX-License-Identifier: MIT
// Runs in a worker before its own script (faulty_site.mjs inserts it). Makes the faults in the worker's name happen,
// each once among all workers with that name.

/**
 * @typedef {object} Fault
 * @property {string} id
 * @property {'from-page' | 'to-page' | 'to-port' | 'start'} place  direction of the message; start: at once
 * @property {string} [type]   of the message
 * @property {'coordinate' | 'evaluate'} [role]  of the worker; default: any
 * @property {number} [nth]    counts such messages, from 1
 * @property {'lose' | 'double' | 'hang' | 'die' | 'trap' | 'no-memory'} act
 * @property {boolean} [always]  repeatedly, in every worker
 */

const scope = /** @type {any} */ (self);
/** @type {Fault[]} */
let faults = scope.name ? JSON.parse(scope.name) : [];
const counts = /** @type {Record<string, number>} */ ({});
const others = new BroadcastChannel('faults');
let role = '';
let trapping = false;
let aheadMs = 0; // relative to the real time

others.onmessage = (/** @type {MessageEvent} */ { data }) => {
  if (data.jumpMs) aheadMs += data.jumpMs;
  else faults = faults.filter(({ id }) => id !== data.id);
};
for (const clock of [Date, performance]) {
  const now = clock.now.bind(clock);
  clock.now = () => now() + aheadMs;
}

/** @param {Fault['place']} place @param {any} message @returns {Fault['act'] | ''} */
function due(place, message) {
  for (const fault of faults) {
    if (fault.place !== place || fault.type !== message?.type || (fault.role ?? role) !== role) continue;
    counts[fault.id] = (counts[fault.id] ?? 0) + 1;
    if (counts[fault.id] < (fault.nth ?? 1)) continue;
    if (!fault.always) faults = faults.filter((other) => other !== fault);
    others.postMessage({ id: fault.always ? '' : fault.id });
    return fault.act;
  }
  return '';
}

/** @param {Fault['act'] | ''} act @param {() => void} pass */
function applyFault(act, pass) {
  if (act === 'lose') return;
  if (act === 'hang') for (;;);
  if (act === 'die') return scope.close();
  if (act === 'trap') trapping = true;
  if (act === 'no-memory') blockMemoryGrowth();
  pass();
  if (act === 'double') pass();
}

const ours = new WeakSet();
scope.addEventListener('message', (/** @type {MessageEvent} */ event) => {
  if (ours.has(event)) return;
  if (['stand-by', 'coordinate', 'evaluate', 'map-transitions'].includes(event.data?.type)) role = event.data.type;
  const act = due('from-page', event.data);
  if (!act) return;
  event.stopImmediatePropagation();
  applyFault(act, () => {
    const copy = new MessageEvent('message', { data: event.data });
    ours.add(copy);
    scope.dispatchEvent(copy);
  });
});

for (const [place, sender] of /** @type {[Fault['place'], any][]} */ ([['to-page', scope], ['to-port', MessagePort.prototype]])) {
  const post = sender.postMessage;
  sender.postMessage = function postMessage(/** @type {any} */ message, /** @type {any} */ transfer) {
    const act = due(place, message);
    // Without transfer if it is sent twice, because data can be transferred only once.
    applyFault(act, () => post.call(this, message, act === 'double' ? {} : transfer));
  };
}

// A module that traps. It makes the next call of an engine function trap, like the engine's own code.
const TRAP = new Uint8Array([0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, 1, 4, 1, 0x60, 0, 0, 3, 2, 1, 0, 7, 5, 1, 1, 0x74, 0, 0, 0xa, 5, 1, 3, 0, 0, 0xb]);
const instantiate = WebAssembly.instantiate;
/** @type {any} */ (WebAssembly).instantiate = async (/** @type {WebAssembly.Module} */ code, /** @type {any} */ imports) => {
  const instance = await instantiate(code, imports);
  scope.testMemory = Object.values(instance.exports).find((part) => part instanceof WebAssembly.Memory);
  return { exports: Object.fromEntries(Object.entries(instance.exports).map(([name, part]) => [name, typeof part !== 'function' ? part
    : (/** @type {any[]} */ ...values) => {
        if (trapping) /** @type {any} */ (new WebAssembly.Instance(new WebAssembly.Module(TRAP)).exports).t();
        return part(...values);
      }])) };
};

/** Makes every growth of this worker's memory fail. */
function blockMemoryGrowth() {
  WebAssembly.Memory.prototype.grow = () => { throw new RangeError('WebAssembly.Memory.grow(): out of memory'); };
}
if (faults.some(({ place, act }) => place === 'start' && act === 'no-memory')) blockMemoryGrowth();
