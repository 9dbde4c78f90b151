// SPDX-License-Identifier: MIT
// Code of the page, compiled while it comes where the server says what it is; some do not know the kind of file.

/** @param {string} name  of a file beside this one. Rejected when it cannot be loaded @returns {Promise<WebAssembly.Module>} */
export async function compiledModule(name) {
  const response = await fetch(new URL(name, import.meta.url));
  if (!response.ok) throw new Error(`${name}: ${response.status}`);
  const known = response.headers.get('content-type')?.startsWith('application/wasm');
  return known ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}
