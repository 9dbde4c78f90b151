// SPDX-License-Identifier: MIT
// The C interface of each WebAssembly module is the same in C++, in the types and in the compiled modules.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { exportedFunctions, MODULES, typesOf } from '../../web/build/border.mjs';

const ROOT = join(dirname(fileURLToPath(import.meta.url)), '../..');
const WEB = process.env.GAITSMITH_WEB ?? join(ROOT, 'build/wasm/web');
/** Where each module is built. @type {Record<string, string>} */
const BUILT = { EngineExports: join(WEB, 'search/engine_module.js'), AppExports: join(WEB, '../shell/app_module.js'), PlannerExports: join(WEB, 'plan/planner_module.js') };

test('border: exports are found with their types and comments', () => {
  const source = `
/// Scores genomes.
/// @return null on failure
static_assert(sizeof(Score) == 16);
GS_EXPORT const Score* gs_run(EvaluatorRole* role, std::size_t most_genomes) {
GS_EXPORT bool gs_done(const SearchRole* role) { return true; }
void gs_not_marked() {}
GS_EXPORT void gs_stop() {}
`;
  assert.deepEqual(exportedFunctions(source, 'GS_EXPORT'), [
    { name: 'gs_run', result: 'Pointer', parameters: [{ name: 'role', type: 'Pointer' }, { name: 'mostGenomes', type: 'number' }],
      comment: ['Scores genomes.', '@return null on failure'] },
    { name: 'gs_done', result: 'number', parameters: [{ name: 'role', type: 'Pointer' }], comment: [] },
    { name: 'gs_stop', result: 'void', parameters: [], comment: [] },
  ]);
  assert.throws(() => exportedFunctions('GS_EXPORT std::string gs_text() {', 'GS_EXPORT'), /std::string/);
});

for (const module of MODULES) {
  test(`border: the types of ${module.name} are what its sources say`, async () => {
    assert.equal(await readFile(join(ROOT, module.types), 'utf8'), await typesOf(module), 'run node web/build/border.mjs');
  });

  test(`border: ${module.name} exports what its types declare`, async (context) => {
    const built = BUILT[module.name] ?? '';
    if (!existsSync(built)) return context.skip('not built here');
    const exported = [...(await readFile(built, 'utf8')).matchAll(/\.(_gs_[a-z_]+)=/g)].map(([, name]) => name);
    const declared = (await readFile(join(ROOT, module.types), 'utf8')).matchAll(/^ {2}(_gs_[a-z_]+)\(/gm);
    assert.deepEqual([...new Set(exported)].sort(), [...declared].map(([, name]) => name).sort());
  });
}
