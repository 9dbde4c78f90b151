// SPDX-License-Identifier: MIT
// One widget of the canvas as an element of the page: the simplest native element with the role. It is kept equal to
// the application's widget.

/** @typedef {import('../app/app.js').MirrorWidget} MirrorWidget */
/** @typedef {import('../app/app.js').MirrorPart} MirrorPart */

/** Roles of groups that have one stop for the Tab key and in which arrows move. */
export const ROVING = new Set(['tablist', 'radiogroup', 'listbox']);

const BUTTONS = new Set(['button', 'switch', 'tab', 'radio', 'option', 'combobox']);
// Size of the text field for a slider's number. [CSS pixels]
const TYPED_WIDTH = 84;
const TYPED_HEIGHT = 22;
const NATIVE = new Set(['button', 'slider']);

/** The id of the element for a widget or part. @param {string} id */
export const domId = (id) => `on-canvas-${id.replaceAll(/[^\w-]/g, '-')}`;

/** Scroll bars are not mirrored, because focus and reading scroll by themselves. @param {MirrorWidget} widget */
export const isMirrored = (widget) => widget.role !== 'scrollbar';

/** Whether digits can be typed into it. @param {string} role */
export const isNumber = (role) => role === 'spinbutton' || role === 'textbox';

/**
 * Whether the element can be reused for this role. A number or a slider is a text field while a value is typed on the
 * canvas.
 * @param {HTMLElement} node @param {MirrorWidget} before @param {string} role
 */
export function fits(node, before, role) {
  if (before.role === role) return true;
  if (!(node instanceof HTMLInputElement)) return false;
  return node.type === 'range' ? role === 'slider' || role === 'textbox' : isNumber(role);
}

/** Whether it can have the focus. Disabled ones can, so that their reason is read. @param {MirrorWidget} widget */
export function takesKeyboard({ id, role }) {
  return BUTTONS.has(role) || role === 'slider' || isNumber(role) || id === 'stage';
}

/**
 * Whether it is a button beside a number. Tab skips these, because arrow keys on the number do the same.
 * @param {MirrorWidget} widget @param {(id: string) => MirrorWidget | undefined} find
 */
export function isBesideNumber({ id, role }, find) {
  const number = role === 'button' ? /^(.+)\/(?:less|more)$/.exec(id)?.[1] : undefined;
  return number !== undefined && isNumber(find(number)?.role ?? '');
}

/** @param {MirrorWidget} widget @returns {HTMLElement} */
export function nodeFor(widget) {
  const { id, role } = widget;
  const tag = BUTTONS.has(role) ? 'button' : role === 'slider' || isNumber(role) ? 'input'
    : role === 'heading' ? 'h2' : role === 'img' ? 'div' : 'p';
  const node = document.createElement(tag);
  node.id = domId(id);
  node.dataset.id = id;
  if (node instanceof HTMLButtonElement) node.type = 'button';
  if (node instanceof HTMLInputElement) {
    node.type = role === 'slider' ? 'range' : 'text';
    if (role !== 'slider') node.inputMode = 'numeric';
    node.autocomplete = 'off';
  }
  if (role === 'img' || role === 'note' || (tag !== 'p' && tag !== 'h2' && !NATIVE.has(role))) {
    node.setAttribute('role', role === 'textbox' ? 'spinbutton' : role);
  }
  if (id === 'stage') node.setAttribute('aria-describedby', 'description');
  return node;
}

/** @param {MirrorPart} part @returns {HTMLElement} */
export function nodeForPart({ id, role }) {
  const node = document.createElement(role === 'region' ? 'section' : 'div');
  node.id = domId(`part/${id}`);
  if (role !== 'region') node.setAttribute('role', role);
  return node;
}

/** Sets an attribute only if it differs. @param {Element} node @param {string} name @param {string | undefined} value  undefined: none */
export function setAttribute(node, name, value) {
  if (value === undefined) node.removeAttribute(name);
  else if (node.getAttribute(name) !== value) node.setAttribute(name, value);
}

/**
 * Makes the element equal to the widget.
 * @param {HTMLElement} node @param {MirrorWidget} widget
 * @param {boolean} withValue  false: keeps the old value, because a screen reader would announce every change
 */
export function update(node, widget, withValue) {
  const { role, label, value, hint = '', state, rect } = widget;
  const { style } = node;
  style.left = `${rect.x}px`;
  style.top = `${rect.y}px`;
  style.width = `${rect.width}px`;
  style.height = `${rect.height}px`;
  if (role === 'slider' && node.classList.contains('typing')) {
    // As wide as a number, at the place of the slider's number.
    style.left = `${rect.x + Math.max(0, rect.width - TYPED_WIDTH)}px`;
    style.width = `${Math.min(rect.width, TYPED_WIDTH)}px`;
    style.height = `${Math.min(rect.height, TYPED_HEIGHT)}px`;
  }
  const flag = (/** @type {boolean | undefined} */ on) => (on === undefined ? undefined : String(on));
  setAttribute(node, 'aria-disabled', state.disabled ? 'true' : undefined);
  setAttribute(node, 'aria-pressed', flag(state.pressed));
  setAttribute(node, 'aria-checked', flag(state.checked));
  setAttribute(node, 'aria-expanded', flag(state.expanded));
  if (role === 'tab' || role === 'option') setAttribute(node, 'aria-selected', flag(state.selected ?? false));
  else setAttribute(node, 'aria-current', state.selected ? 'true' : undefined);

  if (node instanceof HTMLInputElement) updateInput(node, widget, withValue);
  else if (role === 'img' || role === 'combobox') {
    setAttribute(node, 'aria-label', role === 'img' && value && widget.id !== 'stage' ? `${label}: ${value}` : label);
    if (role === 'combobox') setText(node, value);
  } else {
    setText(node, role === 'note' && value ? `${label}: ${value}` : label);
  }
  // Other roles express their value themselves.
  const aside = (role === 'button' || role === 'option') && !hint.startsWith(value) ? `${value.replace(/\.$/, '')}. ${hint}` : hint;
  setAttribute(node, 'aria-description', aside || undefined);
  if (role === 'combobox') setAttribute(node, 'aria-haspopup', 'listbox');
}

/** The part that the widget opens or shows. @param {MirrorWidget} widget @returns {string | undefined} */
export function controlledPart({ id, role, state }) {
  if (role === 'combobox' && state.expanded) return `${id}/list`;
  return role === 'tab' && state.selected ? 'panel' : undefined;
}

/** @param {HTMLInputElement} node @param {MirrorWidget} widget @param {boolean} withValue */
function updateInput(node, { label, value, range }, withValue) {
  setAttribute(node, 'aria-label', label);
  if (!range || !withValue) return;
  const { low, high, step, now } = range;
  if (node.type === 'range') {
    setAttribute(node, 'min', String(low));
    setAttribute(node, 'max', String(high));
    setAttribute(node, 'step', step > 0 ? String(step) : 'any');
    setAttribute(node, 'aria-valuetext', value);
    if (node.valueAsNumber !== now) node.value = String(now);
    return;
  }
  setAttribute(node, 'aria-valuemin', String(low));
  setAttribute(node, 'aria-valuemax', String(high));
  setAttribute(node, 'aria-valuenow', String(now));
  if (!node.classList.contains('typing') && node.value !== value) node.value = value;
}

/** @param {HTMLElement} node @param {string} text */
function setText(node, text) {
  if (node.textContent !== text) node.textContent = text;
}
