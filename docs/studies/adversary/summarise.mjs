// The worst that the adversary has found of each law, world by world, as the tables of docs/physics.md.
//   node docs/studies/adversary/summarise.mjs [limited|springs]
// limited: of model 2; springs: of model 3
import { readFile } from 'node:fs/promises';

const rows = (await readFile(new URL(`${process.argv[2] ?? '.'}/found.csv`, import.meta.url), 'utf8')).trim().split('\n').slice(1).map((row) => row.split(','));
const worlds = ['gait', 'ordinary', 'any'];
const laws = new Map();
let motions = 0;
for (const [law, world, , , evaluations, worst, , unit] of rows) {
  motions += Number(evaluations);
  if (!laws.has(law)) laws.set(law, { unit, worst: new Map() });
  const known = laws.get(law).worst;
  known.set(world, Math.max(known.get(world) ?? 0, Number(worst)));
}
console.log(`${motions} motions, ${rows.length} searches\n`);
console.log(`| law | unit | ${worlds.join(' | ')} |\n|---|---|${worlds.map(() => '---|').join('')}`);
for (const [law, { unit, worst }] of laws) {
  console.log(`| ${law.replaceAll('-', ' ')} | ${unit} | ${worlds.map((world) => Number((worst.get(world) ?? 0).toPrecision(2))).join(' | ')} |`);
}
