// SPDX-License-Identifier: MIT
// Ways to point: with a mouse, or with fingers.
import assert from 'node:assert/strict';

/** @typedef {import('./page_driver.mjs').PageDriver} PageDriver */
/** @typedef {{x: number, y: number}} Point */

/** The common interface. */
class Pointer {
  /** @param {PageDriver} page */
  constructor(page) { this.page = page; }

  /** @param {string} id */
  async find(id) { return (await this.page.widgets()).find((widget) => widget.id === id); }

  /** @param {string} id @returns {Promise<Point>} */
  async centre(id) {
    const widget = await this.find(id);
    assert.ok(widget, `no ${id} on the canvas`);
    const { x, y, width, height } = widget.rect;
    return { x: x + width / 2, y: y + height / 2 };
  }

  /** Clicks or taps a widget, after scrolling to it. @param {string} id */
  async press(id) {
    await this.scrollTo(id);
    await this.tap(await this.centre(id));
  }

  /** @param {Point} _at @returns {Promise<void>} */
  async tap(_at) { throw new Error('a hand of a kind'); }
  /** @param {Point} _from @param {Point} _to @returns {Promise<void>} */
  async drag(_from, _to) { throw new Error('a hand of a kind'); }
  /** Scrolls the panel by one step. @param {boolean} _down @returns {Promise<void>} */
  async scroll(_down) { throw new Error('a hand of a kind'); }

  /** The position of the scroll bar, if there is one. */
  async #scrolled() { return (await this.page.widgets()).find(({ role }) => role === 'scrollbar')?.rect.y; }

  /** Scrolls, first down, then up, until the widget is completely visible. @param {string} id @param {number} [height] */
  async scrollTo(id, height = 17) {
    for (const down of [true, false]) {
      for (let turn = 0; turn < 24; turn++) {
        if (((await this.find(id))?.rect.height ?? 0) >= height) return this.page.frames(4);
        const before = await this.#scrolled();
        await this.scroll(down);
        if (await this.#scrolled() === before) break; // the end
      }
    }
    assert.fail(`${id} is nowhere on the panel`);
  }
}

export class Mouse extends Pointer {
  name = 'mouse';

  /** @param {Point} at */
  async tap({ x, y }) { await this.page.clickAt(x, y); }

  /** @param {Point} from @param {Point} to */
  async drag(from, to) {
    const { mouse } = this.page.page;
    await mouse.move(from.x, from.y);
    await this.page.frames();
    await mouse.down();
    await this.page.frames();
    for (let step = 1; step <= 5; step++) {
      await mouse.move(from.x + ((to.x - from.x) * step) / 5, from.y + ((to.y - from.y) * step) / 5);
      await this.page.frames(2);
    }
    await mouse.up();
    await this.page.frames();
  }

  /** @param {boolean} down */
  async scroll(down) {
    const stage = (await this.find('stage'))?.rect ?? { x: 0, y: 0, width: 0, height: 0 };
    await this.page.page.mouse.move(stage.x + stage.width + 8, stage.y + 300); // beside everything that can be dragged
    await this.page.page.mouse.wheel({ deltaY: down ? 120 : -120 });
    await this.page.frames();
  }
}

export class Fingers extends Pointer {
  name = 'fingers';

  /** @param {Point} at */
  async tap({ x, y }) {
    const touch = await this.page.page.touchscreen.touchStart(x, y);
    await this.page.frames(1); // on a busy machine more would be a long press
    await touch.end();
    await this.page.frames(6);
  }

  /** @param {Point} from @param {Point} to */
  async drag(from, to) {
    const touch = await this.page.page.touchscreen.touchStart(from.x, from.y);
    await this.page.frames();
    for (let step = 1; step <= 5; step++) {
      await touch.move(from.x + ((to.x - from.x) * step) / 5, from.y + ((to.y - from.y) * step) / 5);
      await this.page.frames(2);
    }
    await touch.end();
    await this.page.frames(6);
  }

  /** Moves two fingers. @param {[Point, Point]} from @param {[Point, Point]} to */
  async pinch(from, to) {
    const screen = this.page.page.touchscreen;
    const touches = [];
    for (const { x, y } of from) {
      touches.push(await screen.touchStart(x, y));
      await this.page.frames();
    }
    for (let step = 1; step <= 4; step++) {
      for (const k of [0, 1]) {
        await touches[k].move(from[k].x + ((to[k].x - from[k].x) * step) / 4, from[k].y + ((to[k].y - from[k].y) * step) / 4);
      }
      await this.page.frames(2);
    }
    for (const touch of touches) await touch.end();
    await this.page.frames(6);
  }

  /** @param {boolean} down */
  async scroll(down) {
    const panels = (await this.find('panels/0'))?.rect ?? { x: 0, y: 0, width: 0, height: 0 };
    const x = panels.x - 4; // the panel's margin, where nothing can be dragged
    const top = panels.y + panels.height + 40;
    await this.drag({ x, y: top + (down ? 90 : 0) }, { x, y: top + (down ? 0 : 90) });
  }
}
