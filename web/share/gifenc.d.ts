// SPDX-License-Identifier: MIT
// Types of gifenc.js, the encoder of the npm package of that name, as far as the page uses it.

export type Palette = number[][];
export type Format = 'rgb565' | 'rgb444' | 'rgba4444';

export function quantize(rgba: Uint8ClampedArray, mostColours: number, options?: { format?: Format }): Palette;
export function nearestColorIndex(palette: Palette, rgb: number[]): number;

export interface Encoder {
  /** Delay in milliseconds; repeat 0: for ever. The first frame's palette is that of those without one. */
  writeFrame(index: Uint8Array, width: number, height: number,
    options?: { palette?: Palette; delay?: number; repeat?: number }): void;
  finish(): void;
  bytes(): Uint8Array;
}
export function GIFEncoder(): Encoder;
