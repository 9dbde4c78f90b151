// SPDX-License-Identifier: MIT
// Code of the page, compiled while it comes where the server says what it is; some do not know the kind of file.

/** @param {URL} address  of the file; rejected when it cannot be loaded @returns {Promise<WebAssembly.Module>} */
export async function compiledModule(address) {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`${address.pathname}: ${response.status}`);
  const known = response.headers.get('content-type')?.startsWith('application/wasm');
  return known ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}
