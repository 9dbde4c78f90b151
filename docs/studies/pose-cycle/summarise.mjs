// SPDX-License-Identifier: MIT
// The tables of docs/search.md, "Pose cycles", from the result files beside this one:
//   node docs/studies/pose-cycle/summarise.mjs build/release/shell/gaitsmith
import { execFileSync } from 'node:child_process';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { holm } from '../holm.mjs';
import { cartwheel, shuffle, travel } from '../style/kinds.mjs';

/** @typedef {Record<string, string>} Row */
const [, , gaitsmith = 'gaitsmith'] = process.argv;
const path = (/** @type {string} */ name) => fileURLToPath(new URL(`${name}.csv`, import.meta.url));
/** Lines of a CSV as objects. @param {string} name @returns {Row[]} */
function rowsOf(name) {
  const [head = '', ...lines] = readFileSync(path(name), 'utf8').trim().split('\n').filter((line) => !line.startsWith('#'));
  const names = head.split(',');
  return lines.map((line) => Object.fromEntries(line.split(',').map((value, i) => [names[i], value])));
}
const ascending = (/** @type {number[]} */ values) => [...values].sort((a, b) => a - b);
const bests = (/** @type {string} */ name) => ascending(rowsOf(name).map(({ best }) => Number(best)));
/** The value below which this share lies, between neighbours. @param {number[]} sorted @param {number} share */
function quantile(sorted, share) {
  const at = share * (sorted.length - 1), low = Math.floor(at);
  return (sorted[low] ?? 0) + (at - low) * ((sorted[Math.ceil(at)] ?? 0) - (sorted[low] ?? 0));
}
const median = (/** @type {number[]} */ values) => quantile(ascending(values), 0.5);
const cell = (/** @type {number[]} */ all) => `${median(all).toFixed(2)} (${quantile(all, 0.25).toFixed(2)}–${quantile(all, 0.75).toFixed(2)})`;

/** The same draws each time it is run: a multiplicative congruential generator. @param {number} seed */
function generator(seed) {
  let state = seed;
  return () => (state = (state * 48271) % 2147483647) / 2147483647;
}
/** A 95 % bootstrap interval of a ratio of medians. @param {number[]} a @param {number[]} b */
function interval(a, b) {
  const random = generator(1994);
  const again = (/** @type {number[]} */ values) => median(values.map(() => values[Math.floor(random() * values.length)] ?? 0));
  const ratios = ascending(Array.from({ length: 4000 }, () => again(a) / again(b)));
  return `${quantile(ratios, 0.025).toFixed(2)}–${quantile(ratios, 0.975).toFixed(2)}`;
}

/** Evaluations after which the median of the best so far is at least `goal`. @param {string} name @param {number} goal */
function passes(name, goal) {
  /** @type {Map<number, number[]>} */
  const at = new Map();
  for (const { evaluation, best } of rowsOf(`curves/${name}`)) at.set(Number(evaluation), [...(at.get(Number(evaluation)) ?? []), Number(best)]);
  for (const [evaluation, all] of [...at].sort(([a], [b]) => a - b)) {
    if (median(all) >= goal) return evaluation.toLocaleString('en');
  }
  return 'not in 4,000';
}
/** The rank test of two files: the chance that a run of the first ends better, and p. @param {string} a @param {string} b */
function ranks(a, b) {
  const words = execFileSync(gaitsmith, ['compare', `--summary=${path(a)}`, `--summary=${path(b)}`], { encoding: 'utf8' });
  const [, , , , , a12, p] = (words.trim().split('\n').at(-1) ?? '').split(',');
  return { a12: Number(a12), p: Number(p) };
}

function problems() {
  // Medians of 40,000 evaluations of SPHC on seeds 1 to 20 (docs/studies/searches): the goals set beforehand.
  const goals = { physical: [15.58, 14.01, 13.35, 12.92, 5.80], timer: [14.16, 15.69, 9.91, 14.76, 5.82] };
  const compared = /** @type {const} */ (['physical', 'timer']).flatMap((sense) =>
    ['star-man-travel', 'beryl-travel', 'fred-travel', 'inchworm-travel', 'hopper-jump'].map((problem, i) => {
      const [ours, theirs] = [`${problem}-${sense}-pose-cycle`, `${problem}-${sense}-sphc`];
      return { name: `${problem}, ${sense}`, ours, a: bests(ours), b: bests(theirs), goal: goals[sense][i] ?? NaN, ...ranks(ours, theirs) };
    }));
  const adjusted = holm(compared.map(({ p }) => p));
  console.log('| | pose-cycle, 4,000 | goal | SPHC, 40,000 | ratio (95 %) | chance to be better | p (Holm) | passes the goal after |\n|---|---|---|---|---|---|---|---|');
  for (const [i, { name, ours, a, b, goal, a12 }] of compared.entries()) {
    console.log(`| ${name} | ${cell(a)} | ${goal.toFixed(2)} | ${cell(b)} | ${(median(a) / median(b)).toFixed(2)} (${interval(a, b)}) | ` +
      `${a12.toFixed(2)} | ${(adjusted[i] ?? NaN) < 0.001 ? '< 0.001' : (adjusted[i] ?? NaN).toFixed(3)} | ${passes(ours, goal)} |`);
  }
}

function figures() {
  const drawn = new Set(readdirSync(new URL('figures', import.meta.url)).map((file) => file.replace('.json', '')));
  const names = readdirSync(new URL('by-figure', import.meta.url)).flatMap((file) => /^(.*)-sphc\.csv$/.exec(file)?.[1] ?? []);
  const compared = names.map((name) => {
    const [a, b] = [bests(`by-figure/${name}-pose-cycle`), bests(`by-figure/${name}-sphc`)];
    return { name, a, b, ratio: median(a) / median(b) };
  }).sort((one, other) => one.ratio - other.ratio);
  console.log('\n| figure | pose-cycle, 4,000 | SPHC, 40,000 | ratio (95 %) |\n|---|---|---|---|');
  for (const { name, a, b, ratio } of compared)
    console.log(`| ${name}${drawn.has(name) ? ' *' : ''} | ${cell(a)} | ${cell(b)} | ${ratio.toFixed(2)} (${interval(a, b)}) |`);
  for (const [what, some] of /** @type {const} */ ([['all', compared], ['drawn for this', compared.filter(({ name }) => drawn.has(name))]])) {
    const ratios = some.map(({ ratio }) => ratio);
    console.log(`\n${what}: ${some.length} figures, median ratio ${median(ratios).toFixed(2)}, least ${Math.min(...ratios).toFixed(2)}`);
  }
}

/** Newcombe's 95 % interval of a difference of two shares. @param {number} x1 @param {number} n1 @param {number} x2 @param {number} n2 */
function difference(x1, n1, x2, n2) {
  const z = 1.96;
  const wilson = (/** @type {number} */ x, /** @type {number} */ n) => {
    const p = x / n, middle = (p + z * z / (2 * n)) / (1 + z * z / n);
    const half = z * Math.sqrt(p * (1 - p) / n + z * z / (4 * n * n)) / (1 + z * z / n);
    return [p, middle - half, middle + half];
  };
  const [p1 = 0, l1 = 0, u1 = 0] = wilson(x1, n1), [p2 = 0, l2 = 0, u2 = 0] = wilson(x2, n2), d = p1 - p2;
  const percent = (/** @type {number} */ share) => (100 * share).toFixed(0);
  return `${percent(d)} (${percent(d - Math.hypot(p1 - l1, u2 - p2))} to ${percent(d + Math.hypot(u1 - p1, p2 - l2))})`;
}

function styles() {
  const trialsOf = (/** @type {string} */ name) => rowsOf(name).map((row) => Object.fromEntries(Object.entries(row).map(([column, value]) => [column, Number(value)])));
  const kinds = /** @type {Record<string, typeof shuffle>} */ ({ slip_sum: shuffle, rotations: cartwheel });
  console.log('\n| problem | senses | term | pose-cycle obeys | SPHC obeys | stricter: pose-cycle, SPHC |\n|---|---|---|---|---|---|');
  let [ours, theirs, of] = [0, 0, 0];
  for (const problem of ['star-man-travel', 'beryl-travel']) {
    for (const sense of ['physical', 'timer']) {
      const plain = `by-style/${problem}-${sense}-none-sphc`;
      if (!existsSync(path(plain))) continue;
      const usual = trialsOf(plain), way = median(usual.map(travel));
      for (const term of ['max_cm_height', 'slip_sum', 'rotations']) {
        const files = ['pose-cycle', 'sphc'].map((search) => `by-style/${problem}-${sense}-${term}-${search}`);
        if (!files.every((file) => existsSync(path(file)))) continue;
        const [a = [], b = []] = files.map(trialsOf);
        const level = median(usual.map((t) => t[term] ?? NaN));
        const [x, y] = [a, b].map((trials) => trials.filter((t) => (t[term] ?? NaN) > level && travel(t) >= way / 3).length);
        ours += x ?? 0; theirs += y ?? 0; of += a.length;
        const strict = problem.startsWith('star-man') ? kinds[term] : undefined;
        console.log(`| ${problem} | ${sense} | ${term} | ${x} of ${a.length} | ${y} of ${b.length} | ${strict ? `${a.filter(strict).length}, ${b.filter(strict).length}` : ''} |`);
      }
    }
  }
  if (of > 0) console.log(`\npose-cycle obeys ${ours} of ${of}, SPHC ${theirs}: difference in percent ${difference(ours, of, theirs, of)}`);
}

/** The further style terms: further.csv has them all. */
function further() {
  const rows = rowsOf('further'), terms = { effort: -1, upright: 1, smoothness: 1, head_height: 1 };
  const weights = /** @type {Record<string, number>} */ ({ effort: 0.05, upright: 5, smoothness: 0.2, head_height: 2 });
  const of = (/** @type {string[]} */ ...cell) => rows.filter((row) => [row.problem, row.senses, row.term, row.search].join() === cell.join());
  const way = (/** @type {Row} */ row) => Math.abs(Number(row.travel));
  console.log('\n| problem | senses | term | pose-cycle obeys | SPHC obeys | travel the larger part: pose-cycle, SPHC |\n|---|---|---|---|---|---|');
  let [ours, theirs, all] = [0, 0, 0];
  for (const problem of ['star-man-travel', 'beryl-travel']) {
    for (const sense of ['physical', 'timer']) {
      const plain = of(problem, sense, 'none', 'sphc'), least = median(plain.map(way)) / 3;
      for (const [term, sign] of Object.entries(terms)) {
        const level = sign * median(plain.map((row) => Number(row[term])));
        const cells = ['pose-cycle', 'sphc'].map((search) => of(problem, sense, term, search));
        const [x = 0, y = 0] = cells.map((cell) => cell.filter((row) => sign * Number(row[term]) > level && way(row) >= least).length);
        const larger = cells.map((cell) => cell.filter((row) => way(row) >= Math.abs(Number(row[term]) * (weights[term] ?? 0))).length);
        const n = cells[0]?.length ?? 0;
        ours += x; theirs += y; all += n;
        console.log(`| ${problem} | ${sense} | ${term} | ${x} of ${n} | ${y} of ${n} | ${larger.join(', ')} |`);
      }
    }
  }
  console.log(`\npose-cycle obeys ${ours} of ${all}, SPHC ${theirs}: difference in percent ${difference(ours, all, theirs, all)}`);
}

function elsewhere() {
  const rows = rowsOf('elsewhere');
  const of = (/** @type {string} */ what, /** @type {string} */ search, evaluations = '') =>
    rows.filter((row) => row.case === what && row.search === search && (!evaluations || row.evaluations === evaluations)).map(({ best }) => Number(best));
  console.log('\n| elsewhere | pose-cycle, 4,000 | SPHC, 40,000 | ratio (95 %) |\n|---|---|---|---|');
  const line = (/** @type {string} */ name, /** @type {number[]} */ a, /** @type {number[]} */ b) =>
    console.log(`| ${name} | ${cell(ascending(a))} | ${cell(ascending(b))} | ${(median(a) / median(b)).toFixed(2)} (${interval(a, b)}) |`);
  for (const problem of ['star-man', 'beryl']) {
    for (const sense of ['physical', 'timer'])
      line(`${problem} jumps, ${sense}`, bests(`elsewhere/${problem}-jump-${sense}-pose-cycle`), bests(`elsewhere/${problem}-jump-${sense}-sphc`));
  }
  for (const [name, clip] of /** @type {const} */ ([['there-and-back', 2], ['figure-12', 3]])) line(`${name}, clip ${clip} in place`, of(name, 'pose-cycle'), of(name, 'sphc'));
  line('Star-Man travels, network', of('network', 'pose-cycle'), of('network', 'sphc', '40000'));
  for (const search of ['sphc', 'two-stage']) console.log(`| the same, ${search} with 4,000 | ${cell(ascending(of('network', search, '4000')))} | | |`);
  const robust = [...new Set(rows.map((row) => row.case ?? ''))].filter((name) => name.includes('.plain-'));
  console.log('\n| robust from | pose-cycle, 2,000 | SPHC, 2,000 |\n|---|---|---|');
  for (const name of robust) console.log(`| ${name} | ${of(name, 'pose-cycle')[0]?.toFixed(2)} | ${of(name, 'sphc')[0]?.toFixed(2)} |`);
}

problems();
if (existsSync(path('by-figure/acrobat-sphc'))) figures();
if (existsSync(path('by-style/star-man-travel-physical-none-sphc'))) styles();
if (existsSync(path('further'))) further();
if (existsSync(path('elsewhere'))) elsewhere();
