// SPDX-License-Identifier: MIT
// Types of fflate.js, the ZIP encoder of the npm package of that name, as far as the page uses it.

export class ZipDeflate {
  constructor(name: string, options: { level: number });
  mtime: Date;
  push(bytes: Uint8Array, last: boolean): void;
}

export class Zip {
  constructor(receive: (error: Error | null, bytes: Uint8Array, last: boolean) => void);
  add(file: ZipDeflate): void;
  end(): void;
}
