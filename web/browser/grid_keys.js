// SPDX-License-Identifier: MIT
// A grid of buttons as one stop of the Tab key. Arrow keys, Home and End move between its buttons.

export class GridKeys {
  #stop = 0;

  /** @param {HTMLElement} grid @param {() => HTMLButtonElement[]} buttons  in order @param {AbortSignal} [signal]  ends it */
  constructor(grid, buttons, signal) {
    this.buttons = buttons;
    grid.addEventListener('keydown', (event) => this.#key(event), { signal });
    grid.addEventListener('focusin', ({ target }) => {
      const at = buttons().findIndex((button) => button === target);
      if (at >= 0) this.rove(at);
    }, { signal });
  }

  /** Makes a button the stop. Call after the buttons have changed. @param {number} [index]  without: the last stop */
  rove(index = this.#stop) {
    const buttons = this.buttons();
    this.#stop = Math.min(Math.max(0, index), buttons.length - 1);
    for (const [i, button] of buttons.entries()) button.tabIndex = i === this.#stop ? 0 : -1;
  }

  /** Focuses the stop. */
  focus() { this.buttons()[this.#stop]?.focus(); }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const buttons = this.buttons();
    const at = buttons.findIndex((button) => button === document.activeElement);
    if (at < 0 || event.ctrlKey || event.metaKey || event.altKey) return;
    const tops = buttons.map((button) => button.getBoundingClientRect().top);
    const across = tops.filter((top) => top === tops[0]).length;
    const steps = /** @type {Record<string, number>} */ ({ ArrowRight: 1, ArrowLeft: -1, ArrowDown: across, ArrowUp: -across, Home: -at, End: tops.length });
    if (!(event.key in steps)) return;
    event.preventDefault();
    const button = buttons[Math.min(Math.max(at + steps[event.key], 0), tops.length - 1)];
    button.focus();
    button.scrollIntoView({ block: 'nearest' });
  }
}
