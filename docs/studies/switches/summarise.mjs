// Success of switches between controllers, by who takes over from whom, as the tables of docs/animation.md.
//   node docs/studies/switches/summarise.mjs
import { readFile } from 'node:fs/promises';

const kind = (/** @type {string} */ name) => `${name.startsWith('robust-') ? 'robust' : 'ordinary'} ${name.includes('timer') ? 'timer' : 'physical'}`;
const seedOf = (/** @type {string} */ name) => Number(/-(\d+)$/.exec(name)?.[1]);
/** @param {number[]} values */
const median = (values) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)];

/**
 * Prints a row for each kind of controller that takes over.
 * @param {string} file
 * @param {(from: string, to: string) => boolean} counts  whether a switch is counted
 */
async function table(file, counts) {
  const rows = (await readFile(new URL(file, import.meta.url), 'utf8')).trim().split('\n').slice(1).map((row) => row.split(','));
  /** @type {Map<string, {ratios: number[], successes: number, usual: Map<string, number>}>} */
  const groups = new Map();
  for (const [from = '', to = '', , score, usual, success] of rows) {
    if (!counts(from, to)) continue;
    for (const name of [kind(to), `${kind(to)} from ${from.includes('timer') ? 'timer' : 'physical'}`]) {
      const group = groups.get(name) ?? { ratios: [], successes: 0, usual: new Map() };
      group.ratios.push(Number(score) / Number(usual));
      group.successes += Number(success);
      group.usual.set(to, Number(usual));
      groups.set(name, group);
    }
  }
  console.log('| takes over | switches | succeed | median of score ÷ usual | median usual score (m) |\n|---|---|---|---|---|');
  for (const [name, { ratios, successes, usual }] of [...groups].sort()) {
    console.log(`| ${name} | ${ratios.length} | ${(100 * successes / ratios.length).toFixed(0)} % | ${median(ratios)?.toFixed(2)} | ${median([...usual.values()])?.toFixed(1)} |`);
  }
}

console.log('From fresh donors (seeds 6 to 10):\n');
await table('from-fresh.csv', (from, to) => seedOf(from) > 5 && seedOf(to) <= 5);
console.log('\nFrom the donors of the training (seeds 1 to 5). Not from robust ones, nor from the one that it came from:\n');
await table('switches.csv', (from, to) => !from.startsWith('robust-') && to.replace('robust-', '') !== from);
