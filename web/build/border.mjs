// SPDX-License-Identifier: MIT
// Writes the types of the WebAssembly modules from the C++ sources of their exported functions.
// tests/web/border.test.mjs compares them with the exports of the compiled modules.
//
//   node web/build/border.mjs            writes search/engine_exports.d.ts, app/app_exports.d.ts and plan/planner_exports.d.ts
//   node web/build/border.mjs --check    fails if they are out of date
import { readFile, writeFile } from 'node:fs/promises';
import { join, relative } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const ROOT = fileURLToPath(new URL('../../', import.meta.url));

/** @typedef {{name: string, result: string, parameters: {name: string, type: string}[], comment: string[]}} ExportedFunction */

/** Modules: the C++ sources of the exported functions, the mark of an export, and the written interface and its file. */
export const MODULES = [
  { sources: ['web/search/engine.cpp', 'web/search/engine_motion.cpp', 'web/search/engine_files.cpp', 'web/search/engine_breeding.cpp'], mark: 'GS_EXPORT', name: 'EngineExports', types: 'web/search/engine_exports.d.ts' },
  { sources: ['shell/host/page.cpp', 'shell/host/page_reports.cpp', 'shell/host/page_hints.cpp', 'shell/host/page_typeface.cpp'], mark: 'EMSCRIPTEN_KEEPALIVE', name: 'AppExports', types: 'web/app/app_exports.d.ts' },
  { sources: ['web/plan/planner.cpp'], mark: 'EMSCRIPTEN_KEEPALIVE', name: 'PlannerExports', types: 'web/plan/planner_exports.d.ts' },
];

/** @param {string} type  of C++, without a name */
function scriptType(type) {
  if (type.includes('*')) return 'Pointer';
  if (type === 'void') return 'void';
  if (/^(bool|int|float|double|std::(u?int(8|16|32)_t|size_t))$/.test(type)) return 'number';
  throw new Error(`border: no type of JavaScript is known for ${type}`);
}

/** @param {string} declaration  "const float* curve" @returns {{name: string, type: string}} */
function parameter(declaration) {
  const match = /^(.*?[\s*])([a-z_0-9]+)$/.exec(declaration.trim());
  if (!match) throw new Error(`border: ${declaration} is no parameter with a name`);
  return { name: match[2].replace(/_([a-z])/g, (_, letter) => letter.toUpperCase()), type: scriptType(match[1].trim()) };
}

/** @param {string} source @param {string} mark @returns {ExportedFunction[]} in the source's order */
export function exportedFunctions(source, mark) {
  const pattern = new RegExp(`((?:^[ \\t]*///.*\\n)*)(?:^static_assert.*\\n)*^${mark}\\s+([^(;]*?[\\s*])(gs_[a-z_]+)\\(([^)]*)\\)`, 'gm');
  return [...source.matchAll(pattern)].map(([, comment, result, name, parameters]) => ({
    name,
    result: scriptType(result.trim()),
    parameters: parameters.trim() === '' ? [] : parameters.split(',').map(parameter),
    comment: comment.split('\n').filter(Boolean).map((line) => line.replace(/^\s*\/\/\/ ?/, '')),
  }));
}

/** @param {ExportedFunction} exported */
function declaration({ name, result, parameters, comment }) {
  const documentation = comment.length === 0 ? '' : comment.length === 1 ? `  /** ${comment[0]} */\n` : `  /**\n${comment.map((line) => `   * ${line}\n`).join('')}   */\n`;
  return `${documentation}  _${name}(${parameters.map((each) => `${each.name}: ${each.type}`).join(', ')}): ${result};\n`;
}

/** @param {typeof MODULES[number]} module @returns {Promise<string>} the text of its types */
export async function typesOf({ sources, mark, name }) {
  const texts = await Promise.all(sources.map((source) => readFile(join(ROOT, source), 'utf8')));
  const functions = texts.flatMap((text) => exportedFunctions(text, mark));
  return `// SPDX-License-Identifier: MIT
// Written by web/build/border.mjs from ${sources.join(' and ')}: change those.

/** An address in the module's memory; 0 is null. */
export type Pointer = number;

export interface ${name} {
${functions.map(declaration).join('')}}
`;
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) {
  for (const module of MODULES) {
    const text = await typesOf(module);
    const path = join(ROOT, module.types);
    if (process.argv[2] !== '--check') await writeFile(path, text);
    else if (await readFile(path, 'utf8').catch(() => '') !== text) {
      console.error(`border: ${relative(ROOT, path)} is not what ${module.sources.join(', ')} says; run node web/build/border.mjs`);
      process.exitCode = 1;
    }
  }
}
