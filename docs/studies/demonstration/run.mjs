// SPDX-License-Identifier: MIT
// Runs the study of question.md, and prints its table. Resumable: rows that are there are kept.
//   node docs/studies/demonstration/run.mjs build/release/shell/gaitsmith
import { execFileSync } from 'node:child_process';
import { appendFileSync, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const FIGURES = ['ostrich', 'horse', 'frog', 'mr-star-man', 'beryl-biped', 'snake'];
const SEEDS = Array.from({ length: 20 }, (_, i) => 12001 + i);
const gaitsmith = resolve(process.argv[2] ?? 'build/release/shell/gaitsmith');
const file = fileURLToPath(new URL('gaps.csv', import.meta.url));
const folder = mkdtempSync(join(tmpdir(), 'demonstration-'));
const call = (/** @type {string[]} */ ...words) => execFileSync(gaitsmith, words, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] });

/** The named columns of the only row. @param {string} document @returns {Record<string, number>} */
function measure(document) {
  const [names, values] = call('measure', document).trim().split('\n').map((line) => line.split(','));
  return Object.fromEntries(names.map((name, i) => [name, Number(values[i])]));
}

/** @param {string} figure @returns {[string, string, string[]][]} wish, column, options */
function wishes(figure) {
  const standing = join(folder, `${figure}.json`);
  call('new', '--figure', figure, '--out', standing);
  const { figure: { rods } } = JSON.parse(readFileSync(standing, 'utf8'));
  const [first] = call('simulate', standing).split('\n').slice(1);
  const height = Number(first.split(',')[2]);
  const turn = Number(first.split(',')[5]) + Math.PI;
  const pose = `2.5:${(turn > Math.PI ? turn - 2 * Math.PI : turn).toFixed(4)}${':0'.repeat(rods.length - 1)}`;
  return [
    ['way', 'on_way', ['--way', `0:0:${height},5:5:${height}`]],
    ['arch', 'on_way', ['--way', [0, 1.25, 2.5, 3.75, 5].map((s) => `${s}:${s}:${height + Math.sin((Math.PI * s) / 5)}`).join(',')]],
    ['pose', 'in_pose', ['--pose', pose]],
  ];
}

if (!existsSync(file)) writeFileSync(file, 'figure,wish,taught,seed,gap\n');
const done = new Set(readFileSync(file, 'utf8').trim().split('\n').map((row) => row.split(',').slice(0, 4).join(',')));
for (const figure of FIGURES) {
  for (const [wish, column, options] of wishes(figure)) {
    for (const taught of ['no', 'yes']) {
      for (const seed of SEEDS) {
        const key = [figure, wish, taught, seed].join(',');
        if (done.has(key)) continue;
        const out = join(folder, 'found.json');
        call('synthesize', '--figure', figure, '--task', 'travel-right', '--sense', 'timer=1', '--duration', '5', '--search', 'pose-cycle', '--threads', '1',
          '--evaluations', '4000', '--seed', String(seed), '--out', out, ...options, ...(taught === 'no' ? ['--weight', `${column}=0`] : []));
        appendFileSync(file, `${key},${-measure(out)[column]}\n`);
      }
    }
  }
}
rmSync(folder, { recursive: true });

const rows = readFileSync(file, 'utf8').trim().split('\n').slice(1).map((row) => row.split(','));
/** @param {number[]} gaps @param {number} share */
const quantile = (gaps, share) => {
  const at = (gaps.length - 1) * share;
  return gaps[Math.floor(at)] + (at % 1) * (gaps[Math.ceil(at)] - gaps[Math.floor(at)]);
};
console.log('| figure | wish | shown nothing | shown | closer, of 20 |\n|---|---|---|---|---|');
for (const figure of FIGURES) {
  for (const wish of ['way', 'arch', 'pose']) {
    const of = (/** @type {string} */ taught) => SEEDS.map((seed) => Number(rows.find((row) => row[0] === figure && row[1] === wish && row[2] === taught && row[3] === String(seed))?.[4]));
    const no = of('no'), yes = of('yes');
    const words = (/** @type {number[]} */ gaps) => {
      const sorted = [...gaps].sort((a, b) => a - b);
      return `${quantile(sorted, 0.5).toFixed(2)} (${quantile(sorted, 0.25).toFixed(2)} to ${quantile(sorted, 0.75).toFixed(2)})`;
    };
    console.log(`| ${figure} | ${wish} | ${words(no)} | ${words(yes)} | ${yes.filter((gap, i) => gap < no[i]).length} |`);
  }
}
