// SPDX-License-Identifier: MIT
// The parts that a link can lock (docs/embedding.md).
import { trLater } from '../languages/language.js';

export const locks = [
  { name: 'figure', label: trLater('Figure') }, { name: 'controller', label: trLater('Controller') }, { name: 'style', label: trLater('Style') },
  { name: 'search', label: trLater('Search') }, { name: 'timeline', label: trLater('Timeline') }, { name: 'world', label: trLater('World') },
];
