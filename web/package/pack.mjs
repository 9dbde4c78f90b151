// SPDX-License-Identifier: MIT
// Packs what goes to npm: the engine, and the runtime of controllers for games. docs/published-packages.md describes both.
//
//   node web/package/pack.mjs <folder of the built page> <folder for the packages>
import { execFileSync } from 'node:child_process';
import { copyFile, cp, mkdir, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { basename, join, resolve } from 'node:path';
import ts from 'typescript';
import { project, ROOT, WEB } from './release.mjs';
import { noticesOf, partsOf } from './third_party.mjs';

const [built, out] = process.argv.slice(2).map((path) => resolve(path));
if (!out) throw new Error('pack: from which folder, and where to?');

const RUNTIME = [join(WEB, 'runtime/runtime.js'), join(WEB, 'runtime/runtime.d.ts'), join(ROOT, 'core/runtime/gaitsmith.h')];
const ENGINE_SCRIPTS = ['engine.js', 'recorded_motion.js', 'drawn_ground.js'];

/** Writes the types of the engine's scripts from their comments. @param {string} folder */
function declareEngine(folder) {
  const program = ts.createProgram([join(WEB, 'search/engine.js')], {
    allowJs: true, declaration: true, emitDeclarationOnly: true, target: ts.ScriptTarget.ES2022, module: ts.ModuleKind.NodeNext,
    moduleResolution: ts.ModuleResolutionKind.NodeNext, lib: ['lib.es2022.d.ts', 'lib.dom.d.ts'], types: [], outDir: folder,
  });
  const diagnostics = ENGINE_SCRIPTS.flatMap((name) => program.emit(program.getSourceFile(join(WEB, 'search', name))).diagnostics);
  if (diagnostics.length > 0) throw new Error(ts.formatDiagnostics(diagnostics, ts.createCompilerHost({})));
}

/** Files to copy, beside those of the package's own folder. @type {Record<'engine' | 'runtime', string[]>} */
const FILES = {
  engine: [...RUNTIME, ...[...ENGINE_SCRIPTS, 'engine_module.js', 'engine_module.wasm'].map((name) => join(built, 'search', name)),
    ...['engine_module.d.ts', 'engine_exports.d.ts'].map((name) => join(WEB, 'search', name))],
  runtime: [...RUNTIME, join(ROOT, 'tests/golden/controllers/rules.json')],
};

for (const kind of /** @type {const} */ (['engine', 'runtime'])) {
  const folder = await mkdtemp(join(tmpdir(), 'gaitsmith-'));
  try {
    const own = join(WEB, 'package', kind);
    await cp(own, folder, { recursive: true });
    for (const file of FILES[kind]) await copyFile(file, join(folder, basename(file)));
    await copyFile(join(ROOT, 'LICENSE'), join(folder, 'LICENSE'));
    if (partsOf(kind).length > 0) await writeFile(join(folder, 'THIRD-PARTY.txt'), noticesOf(kind));
    const { name, ...description } = JSON.parse(await readFile(join(own, 'package.json'), 'utf8'));
    const { version } = project();
    await writeFile(join(folder, 'package.json'), `${JSON.stringify({ name, version, ...description }, null, 2)}\n`);
    if (kind === 'engine') declareEngine(folder);

    await mkdir(out, { recursive: true });
    execFileSync('npm', ['pack', '--loglevel=error', '--pack-destination', out], { cwd: folder, stdio: ['ignore', 'ignore', 'inherit'] });
    console.log(`== ${name}-${version}.tgz`);
  } finally {
    await rm(folder, { recursive: true });
  }
}
