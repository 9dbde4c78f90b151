// SPDX-License-Identifier: MIT
// What a page saves as a file.

/** Runs in a page before its scripts: records what it saves. */
export function recordFiles() {
  const offered = /** @type {{name: string, blob: Blob}[]} */ ([]), blobs = new Map();
  Object.assign(window, { testOffered: offered });
  const create = URL.createObjectURL.bind(URL), click = HTMLAnchorElement.prototype.click;
  URL.createObjectURL = (blob) => {
    const url = create(blob);
    blobs.set(url, blob);
    return url;
  };
  HTMLAnchorElement.prototype.click = function () {
    if (this.download) offered.push({ name: this.download, blob: blobs.get(this.href) });
    else click.call(this);
  };
}

/** The files that the page has saved since the last time. @param {import('../../browsers.mjs').Page} page @returns {Promise<{name: string, bytes: Buffer}[]>} */
export async function saved(page) {
  const files = await page.evaluate(() => Promise.all(/** @type {any} */ (window).testOffered.splice(0).map(async (/** @type {{name: string, blob: Blob}} */ { name, blob }) => {
    const bytes = new Uint8Array(await blob.arrayBuffer());
    let text = '';
    for (let i = 0; i < bytes.length; i += 30000) text += String.fromCharCode(...bytes.subarray(i, i + 30000));
    return { name, text: btoa(text) };
  })));
  return files.map(({ name, text }) => ({ name, bytes: Buffer.from(text, 'base64') }));
}
