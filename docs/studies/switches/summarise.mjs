// Success of switches between controllers, by who takes over from whom, as the table of docs/animation.md.
//   node docs/studies/switches/summarise.mjs
import { readFile } from 'node:fs/promises';

const rows = (await readFile(new URL('switches.csv', import.meta.url), 'utf8')).trim().split('\n').slice(1).map((row) => row.split(','));
const kind = (/** @type {string} */ name) => `${name.startsWith('robust-') ? 'robust' : 'ordinary'} ${name.includes('timer') ? 'timer' : 'physical'}`;
/** @param {number[]} values */
const median = (values) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)];

/** @type {Map<string, {ratios: number[], successes: number, usual: Map<string, number>}>} */
const groups = new Map();
for (const [from, to, , score, usual, success] of rows) {
  if (from.startsWith('robust-')) continue; // robust controllers were made for the ends of ordinary ones
  if (to.replace('robust-', '') === from) continue; // nor from the one that it came from
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
  console.log(`| ${name} | ${ratios.length} | ${(100 * successes / ratios.length).toFixed(0)} % | ${median(ratios).toFixed(2)} | ${median([...usual.values()]).toFixed(1)} |`);
}
