// SPDX-License-Identifier: MIT
// Checks a folder that `gaitsmith compare --summary CSV --ioh DIR` wrote against what IOHanalyzer reads; tests/peers/running_times.R asks its own reader:
//   node tests/command_line/ioh_check.mjs DIR
// In a search's folder a file for each function, in JSON, and beside it the data of its runs, one block each.
import { existsSync, readFileSync, readdirSync, statSync } from 'node:fs';
import { join } from 'node:path';

const folder = process.argv[2] ?? '.';
/** @param {boolean} right @param {string} what */
function must(right, what) {
  if (right) return;
  console.error(`${folder}: ${what}`);
  process.exit(1);
}
let runs = 0;
for (const search of readdirSync(folder).filter((name) => statSync(join(folder, name)).isDirectory())) {
  const files = readdirSync(join(folder, search)).filter((name) => name.endsWith('.json'));
  must(files.length > 0, `${search} has no function`);
  for (const file of files) {
    const named = /^IOHprofiler_f(\d+)_(.+)\.json$/.exec(file);
    must(named !== null, `${file} is not named as a function`);
    const meta = JSON.parse(readFileSync(join(folder, search, file), 'utf8'));
    for (const key of ['version', 'suite', 'function_id', 'function_name', 'maximization', 'algorithm', 'attributes', 'scenarios'])
      must(key in meta, `${file} has no ${key}`);
    must(meta.function_id === Number(named?.[1]) && meta.function_name === named?.[2], `${file} holds another function`);
    must(meta.maximization === true && typeof meta.algorithm.name === 'string', `${file}: which way is better, and whose it is`);
    must(JSON.stringify(meta.attributes) === '["evaluations","raw_y"]', `${file}: other columns`);
    for (const scenario of meta.scenarios) {
      must(Number.isInteger(scenario.dimension) && scenario.dimension > 0, `${file}: no dimension`);
      must(scenario.path === `data_f${meta.function_id}_${meta.function_name}/IOHprofiler_f${meta.function_id}_DIM${scenario.dimension}.dat`, `${file}: ${scenario.path}`);
      must(existsSync(join(folder, search, scenario.path)), `${scenario.path} is missing`);
      const blocks = readFileSync(join(folder, search, scenario.path), 'utf8').split('evaluations raw_y\n');
      must(blocks.shift() === '', `${scenario.path} begins with something else`);
      must(blocks.length === scenario.runs.length, `${scenario.path} has ${blocks.length} blocks for ${scenario.runs.length} runs`);
      blocks.forEach((block, at) => {
        const run = scenario.runs[at];
        const rows = block.trimEnd().split('\n').map((row) => row.split(' ').map(Number));
        must(rows.every((row) => row.length === 2 && row.every(Number.isFinite)), `${scenario.path}: not two numbers in a row`);
        must(rows.every(([evaluations = 0, value = 0], i) => i === 0 || (evaluations > (rows[i - 1]?.[0] ?? 0) && value >= (rows[i - 1]?.[1] ?? 0))), `${scenario.path}: a best so far falls`);
        const [evaluations, value] = rows.at(-1) ?? [];
        must(evaluations === run.evals, `${scenario.path}: run ${at} ends elsewhere`);
        must(value === run.best.y && rows.some(([when, what]) => when === run.best.evals && what === run.best.y), `${scenario.path}: run ${at} has another best`);
        must(Number.isInteger(run.instance), `${file}: run ${at} has no instance`);
        runs++;
      });
    }
  }
}
console.log(runs);
