// SPDX-License-Identifier: MIT
// The code samples of the documentation: JavaScript is checked against types, C++ is compiled with core. Their output
// is not checked.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join, relative } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import ts from '../../web/node_modules/typescript/lib/typescript.js';

const ROOT = join(dirname(fileURLToPath(import.meta.url)), '../..');

/** Declarations that samples may use. */
const AROUND = `
  declare var gaitsmith: import('WEB/api.js').Gaitsmith;
  declare var frame: HTMLIFrameElement & { contentWindow: Window };
  declare var jsonOrLink: string;
  declare module 'node:fs' { export function readFileSync(from: number | string, encoding: string): string }
  interface Window { gaitsmith: import('WEB/api.js').Gaitsmith }
  // Samples may use any element and event.
  interface Document { getElementById(id: string): any; querySelector(what: string): any }
  interface EventTarget { addEventListener(type: string, listener: (event: any) => void): void }
`;

/** @typedef {{where: string, language: string, code: string}} Sample */

/** @returns {Promise<Sample[]>} */
async function samples() {
  const docs = join(ROOT, 'docs');
  const files = [join(ROOT, 'README.md'), ...(await readdir(docs, { recursive: true })).filter((name) => name.endsWith('.md')).map((name) => join(docs, name))];
  /** @type {Sample[]} */
  const found = [];
  for (const file of files) {
    const text = await readFile(file, 'utf8');
    // A sample that contains a sample has longer fences.
    for (const match of text.matchAll(/^(`{3,})(js|cpp|html)\n(.*?)^\1$/gms)) {
      const line = text.slice(0, match.index).split('\n').length;
      found.push({ where: `${relative(ROOT, file)}:${line}`, language: match[2], code: match[3] });
    }
  }
  return found;
}

/** The scripts of a page. @param {Sample} sample @returns {Sample[]} */
const scriptsOf = ({ where, code }) => [...code.matchAll(/<script[^>]*>(.*?)<\/script>/gs)].map(([, script]) => ({ where, language: 'js', code: script }));

test('samples: JavaScript in the documentation fits the types', async () => {
  const all = await samples();
  const scripts = [...all.filter(({ language }) => language === 'js'), ...all.filter(({ language }) => language === 'html').flatMap(scriptsOf)];
  assert.ok(scripts.length >= 5, `${scripts.length} samples`);
  const web = join(ROOT, 'web');
  const files = new Map(scripts.map(({ code }, i) => [
    join(web, `sample_${i}.js`),
    // A module, so that samples do not share names. The site has player.js in its root folder; the runtime is one file.
    `${code.replace('\'./player.js\'', '\'./book/player.js\'').replace('\'./runtime.js\'', '\'./runtime/runtime.js\'')}\nexport {};\n`,
  ]));
  files.set(join(web, 'samples.d.ts'), AROUND.replaceAll('WEB', './page'));
  const options = {
    allowJs: true, checkJs: true, noEmit: true, strict: true, noImplicitAny: false, strictNullChecks: false, skipLibCheck: true, target: ts.ScriptTarget.ES2022,
    module: ts.ModuleKind.NodeNext, moduleResolution: ts.ModuleResolutionKind.NodeNext, lib: ['lib.es2022.d.ts', 'lib.dom.d.ts', 'lib.dom.iterable.d.ts'], types: [],
  };
  const host = ts.createCompilerHost(options);
  const { readFile: readReal, fileExists, getSourceFile } = host;
  host.fileExists = (name) => files.has(name) || fileExists.call(host, name);
  host.readFile = (name) => files.get(name) ?? readReal.call(host, name);
  host.getSourceFile = (name, target, ...rest) => {
    const text = files.get(name);
    return text === undefined ? getSourceFile.call(host, name, target, ...rest) : ts.createSourceFile(name, text, target, true);
  };
  const program = ts.createProgram([...files.keys()], options, host);
  const faults = [...files.keys()].flatMap((name, i) => {
    const source = program.getSourceFile(name);
    const found = source ? [...program.getSyntacticDiagnostics(source), ...program.getSemanticDiagnostics(source)] : [];
    return found.map((fault) => `${scripts[i]?.where ?? 'what stands around samples'}: ${ts.flattenDiagnosticMessageText(fault.messageText, ' ')}`);
  });
  assert.deepEqual(faults, []);
});

test('samples: C++ in the documentation compiles', async (context) => {
  const compiler = ['c++', 'clang++-19'].find((name) => {
    try {
      execFileSync(name, ['--version'], { stdio: 'ignore' });
      return true;
    } catch {
      return false;
    }
  });
  if (!compiler) return context.skip('no compiler');
  const programs = (await samples()).filter(({ language }) => language === 'cpp');
  assert.ok(programs.length >= 1);
  const folder = await mkdtemp(join(tmpdir(), 'samples-'));
  try {
    for (const { where, code } of programs) {
      const lines = code.split('\n');
      const includes = lines.filter((line) => line.startsWith('#include'));
      const body = lines.filter((line) => !line.startsWith('#include'));
      const file = join(folder, 'sample.cpp');
      await writeFile(file, `${includes.join('\n')}\n#include <vector>\nint main() {\n  using namespace gaitsmith;\n${body.join('\n')}\n}\n`);
      try {
        execFileSync(compiler, ['-std=c++23', '-fsyntax-only', '-Wall', '-Werror', '-Wno-psabi', `-I${ROOT}`, file], { stdio: 'pipe' });
      } catch (error) {
        assert.fail(`${where}: ${/** @type {any} */ (error).stderr}`);
      }
    }
  } finally {
    await rm(folder, { recursive: true });
  }
});
