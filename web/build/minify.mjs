// The page's scripts as they are served: without comments, which are half of their bytes.
//
//   node web/build/strip.mjs <folder to write to> <folder that they lie in, with folders of its own> <file.js>...
import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { dirname, join, relative } from 'node:path';
import ts from 'typescript';

const [folder, source, ...files] = process.argv.slice(2);
const compilerOptions = { target: ts.ScriptTarget.ESNext, module: ts.ModuleKind.ESNext, removeComments: true };
await Promise.all(files.map(async (file) => {
  const { outputText } = ts.transpileModule(await readFile(file, 'utf8'), { fileName: file, compilerOptions });
  const path = join(folder, relative(source, file));
  await mkdir(dirname(path), { recursive: true });
  await writeFile(path, outputText);
}));
