// SPDX-License-Identifier: MIT
// Packs the engine for npm: WebAssembly module, script, types from its comments, example.
//
//   node web/package/pack.mjs <folder of the built engine> <folder for the package>
import { execFileSync } from 'node:child_process';
import { copyFile, mkdir, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import ts from 'typescript';

const HERE = dirname(fileURLToPath(import.meta.url));
const WEB = dirname(HERE);
const [built, out] = process.argv.slice(2).map((path) => resolve(path));
if (!out) throw new Error('pack: from which folder, and where to?');

const folder = await mkdtemp(join(tmpdir(), 'gaitsmith-engine-'));
try {
  for (const name of ['README.md', 'example.js', 'example.html']) await copyFile(join(HERE, name), join(folder, name));
  for (const name of ['engine.js', 'engine_module.js', 'engine_module.wasm', 'recorded_motion.js', 'drawn_ground.js']) await copyFile(join(built, 'search', name), join(folder, name));
  for (const name of ['runtime.js', 'runtime.d.ts']) await copyFile(join(WEB, 'runtime', name), join(folder, name));
  await copyFile(join(WEB, '../core/runtime/gaitsmith.h'), join(folder, 'gaitsmith.h'));
  await copyFile(join(WEB, '../LICENSE'), join(folder, 'LICENSE'));
  const version = /project\(gaitsmith VERSION (\S+)/.exec(await readFile(join(WEB, '../CMakeLists.txt'), 'utf8'))?.[1];
  if (!version) throw new Error('pack: CMakeLists.txt has no version');
  const { name, ...description } = JSON.parse(await readFile(join(HERE, 'package.json'), 'utf8'));
  await writeFile(join(folder, 'package.json'), `${JSON.stringify({ name, version, ...description }, null, 2)}\n`);
  for (const name of ['engine_module.d.ts', 'engine_exports.d.ts']) await copyFile(join(WEB, 'search', name), join(folder, name));

  const source = join(WEB, 'search/engine.js');
  const program = ts.createProgram([source], {
    allowJs: true, declaration: true, emitDeclarationOnly: true, target: ts.ScriptTarget.ES2022, module: ts.ModuleKind.NodeNext,
    moduleResolution: ts.ModuleResolutionKind.NodeNext, lib: ['lib.es2022.d.ts', 'lib.dom.d.ts'], types: [], outDir: folder,
  });
  const diagnostics = ['engine.js', 'recorded_motion.js', 'drawn_ground.js'].flatMap((name) => program.emit(program.getSourceFile(join(WEB, 'search', name))).diagnostics);
  if (diagnostics.length > 0) throw new Error(ts.formatDiagnostics(diagnostics, ts.createCompilerHost({})));

  await mkdir(out, { recursive: true });
  execFileSync('npm', ['pack', '--loglevel=error', '--pack-destination', out], { cwd: folder, stdio: ['ignore', 'ignore', 'inherit'] });
  console.log(`== ${name}-${version}.tgz`);
} finally {
  await rm(folder, { recursive: true });
}
