// SPDX-License-Identifier: MIT
// The only scripts that the page may start by their addresses. Browsers with Trusted Types refuse all others, whatever a
// bug may make of a text (the policy of index.html).

const SCRIPTS = ['search/worker.js', 'service_worker.js'];

/** @param {string} name  its path in the site */
function address(name) {
  if (!SCRIPTS.includes(name)) throw new TypeError(`${name} is no script of this page`);
  return new URL(`../${name}`, import.meta.url).href;
}

const policy = /** @type {any} */ (globalThis).trustedTypes?.createPolicy('gaitsmith', { createScriptURL: address });

/** @param {string} name @returns {string} for Worker and its like */
export const scriptAddress = (name) => (policy ? policy.createScriptURL(name) : address(name));
