// SPDX-License-Identifier: MIT
// Godot 3 opens the scenes that we export, and plays them: at some times of each, every bone is where the motion has it.
//   node tests/peers/godot.mjs GAITSMITH [--out CSV]
// GAITSMITH is the built program. Writes a row for each document: the greatest error of a bone's start [px]. Fails at a pixel.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const ROOT = fileURLToPath(new URL('../../', import.meta.url));
const PX_PER_M = 100;
const MOMENTS = 40; // of each motion
const MOST_PX = 1;

// Prints where each bone starts, a line for each moment.
const SCRIPT = `extends SceneTree

func _initialize():
  var figure = load("res://motion.tscn").instance()
  get_root().add_child(figure)
  var player = figure.get_node("AnimationPlayer")
  player.play("motion")
  var bones = []
  collect(figure.get_node("Skeleton"), bones)
  for moment in range(${MOMENTS + 1}):
    player.seek(player.get_animation("motion").length * moment / ${MOMENTS}.0, true)
    var line = "AT"
    for bone in bones:
      var place = bone.get_global_transform()
      line += " %.4f %.4f" % [place.origin.x, place.origin.y]
    print(line)
  quit()

func collect(node, bones):
  for child in node.get_children():
    if child is Bone2D:
      bones.append(child)
      collect(child, bones)
`;

const [gaitsmith, ...options] = process.argv.slice(2);
const work = mkdtempSync(join(tmpdir(), 'godot-'));
process.on('exit', () => rmSync(work, { recursive: true }));
writeFileSync(join(work, 'project.godot'), 'config_version=4\n\n[application]\nconfig/name="judge"\n');
writeFileSync(join(work, 'play.gd'), SCRIPT);

/** Where rods start in the motion, by row and then by rod [m]. @param {string} csv @param {number[]} starts  endpoints */
function placesOf(csv, starts) {
  const [header, ...rows] = csv.trim().split('\n').map((line) => line.split(','));
  return rows.map((row) => starts.map((k) => ['x', 'y'].map((axis) => Number(row[header.indexOf(`node${k}_${axis}`)]))));
}

/** Rods in walking order and depth first, as Godot finds them: where each starts. @param {{parent: number, parent_end: string}[]} rods  of an exported controller */
function startsOf(rods) {
  const start = rods.map(({ parent, parent_end: end }) => (parent < 0 ? 0 : end === 'end' ? parent + 1 : -1 - parent));
  /** @type {(k: number) => number} */
  const find = (k) => (k >= 0 ? k : find(start[-1 - k]));
  const at = start.map(find);
  /** @type {(rod: number) => number[]} */
  const from = (rod) => [rod, ...rods.flatMap(({ parent }, child) => (parent === rod ? from(child) : []))];
  return from(0).map((rod) => at[rod]);
}

const rows = ['# ./dev peers', 'document,worst_px'];
const faults = [];
for (const file of readdirSync(join(ROOT, 'examples')).filter((name) => name.endsWith('.json')).sort()) {
  const document = join(ROOT, 'examples', file);
  execFileSync(gaitsmith, ['export', document, '--godot3', join(work, 'motion.tscn')]);
  const csv = execFileSync(gaitsmith, ['export', document, '--csv', '-'], { encoding: 'utf8' });
  const { figure } = JSON.parse(execFileSync(gaitsmith, ['export', document, '--controller', '-'], { encoding: 'utf8' }));
  const places = placesOf(csv, startsOf(figure.rods));
  const output = execFileSync('godot3-server', ['--path', work, '-s', 'play.gd'], { encoding: 'utf8' });
  const lines = output.split('\n').filter((line) => line.startsWith('AT ')).map((line) => line.split(' ').slice(1).map(Number));
  let worst = lines.length === MOMENTS + 1 ? 0 : Infinity;
  lines.forEach((line, moment) => {
    const at = (moment / MOMENTS) * (places.length - 1);
    const [before, after] = [places[Math.floor(at)], places[Math.ceil(at)]];
    before.forEach(([x, y], bone) => {
      const share = at % 1;
      const [ownX, ownY] = [x + share * (after[bone][0] - x), y + share * (after[bone][1] - y)];
      worst = Math.max(worst, Math.hypot(line[2 * bone] - PX_PER_M * ownX, line[2 * bone + 1] + PX_PER_M * ownY));
    });
  });
  rows.push(`${file.replace('.json', '')},${worst.toFixed(2)}`);
  if (!(worst <= MOST_PX)) faults.push(`${file}: a bone is ${worst} px away in Godot`);
}

if (options.includes('--out')) writeFileSync(options[options.indexOf('--out') + 1], `${rows.join('\n')}\n`);
else console.log(rows.join('\n'));
for (const fault of faults) console.error(fault);
process.exitCode = faults.length ? 1 : 0;
