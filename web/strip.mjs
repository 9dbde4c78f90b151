// The page's scripts as they are served: without comments, which are half of their bytes.
//
//   node web/strip.mjs <folder to write to> <file.js>...
import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { basename, join } from 'node:path';
import ts from 'typescript';

const [folder, ...files] = process.argv.slice(2);
const compilerOptions = { target: ts.ScriptTarget.ESNext, module: ts.ModuleKind.ESNext, removeComments: true };
await mkdir(folder, { recursive: true });
await Promise.all(files.map(async (file) => {
  const { outputText } = ts.transpileModule(await readFile(file, 'utf8'), { fileName: file, compilerOptions });
  await writeFile(join(folder, basename(file)), outputText);
}));
