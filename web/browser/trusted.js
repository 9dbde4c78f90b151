// SPDX-License-Identifier: MIT
// The only scripts that the page may start from an address. With the policy in index.html, browsers with Trusted Types
// refuse all others, so that a bug cannot start a script of an attacker.

const SCRIPTS = ['plan/worker.js', 'search/worker.js', 'service_worker.js'];

/** @param {string} name  path in the site */
function address(name) {
  if (!SCRIPTS.includes(name)) throw new TypeError(`${name} is no script of this page`);
  return new URL(`../${name}`, import.meta.url).href;
}

const policy = /** @type {any} */ (globalThis).trustedTypes?.createPolicy('gaitsmith', { createScriptURL: address });

/** The address for `new Worker` and similar calls. @param {string} name @returns {string} */
export const scriptAddress = (name) => (policy ? policy.createScriptURL(name) : address(name));
