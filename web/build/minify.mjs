// Writes the page's scripts as small as they get. What they export keeps its name.
//
//   node web/build/minify.mjs <output folder> <source folder> <file.js in the source folder>...
import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { dirname, join, relative } from 'node:path';
import { minify } from 'terser';

const [folder, source, ...files] = process.argv.slice(2);
await Promise.all(files.map(async (file) => {
  const { code = '' } = await minify(await readFile(file, 'utf8'), { module: true, compress: { passes: 2 } });
  const path = join(folder, relative(source, file));
  await mkdir(dirname(path), { recursive: true });
  await writeFile(path, code);
}));
