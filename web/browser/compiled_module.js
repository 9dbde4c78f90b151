// SPDX-License-Identifier: MIT
// Compiles WebAssembly, during the download if the server sends the right content type.

/** @param {URL} address @returns {Promise<WebAssembly.Module>} rejected if the file cannot be loaded */
export async function compiledModule(address) {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`${address.pathname}: ${response.status}`);
  const known = response.headers.get('content-type')?.startsWith('application/wasm');
  return known ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}
