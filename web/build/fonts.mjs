// Reduces the Inter typeface to the characters that Gaitsmith shows.
//
//   node web/build/fonts.mjs [folder, default build/fonts]
//
// Writes inter-{regular,semibold}.ttf with TrueType outlines, because Dear ImGui's stb_truetype cannot read WOFF2. The
// page takes them from the application. Prints the characters that Inter lacks.
import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const FACES = { regular: 'Inter-Regular', semibold: 'Inter-SemiBold' };
const GREEK = 'τθφωμΔπΣ';
const PUNCTUATION = '“”„‘’–—…·';
const SYMBOLS = '×÷±≤≥≪≫→←↔↑↓−°²³⟲✓▶';
// Dear ImGui draws one glyph per character, without kerning, and the page matches it. Only digits of equal width are
// needed, for changing numbers. Inter's other letter forms and its kerning are two thirds of its bytes.
const CUT = { noHinting: true, keepFeatures: ['tnum'], dropTables: ['GDEF', 'GPOS'] };
const SOFT_HYPHEN = 0xad;
const CHARACTERS = printableLatin1() + GREEK + PUNCTUATION + SYMBOLS;

function printableLatin1() {
  let text = '';
  for (let code = 0x20; code <= 0xff; code++) {
    const control = code >= 0x7f && code <= 0x9f;
    if (!control && code !== SOFT_HYPHEN) text += String.fromCodePoint(code);
  }
  return text;
}

/**
 * The code points that a TrueType file maps to glyphs, read from its format 4 and 12 'cmap' tables.
 * @param {Buffer} font
 */
function mappedCodePoints(font) {
  const points = new Set();
  for (let table = 0; table < font.readUInt16BE(4); table++) {
    const entry = 12 + 16 * table;
    if (font.toString('latin1', entry, entry + 4) !== 'cmap') continue;
    const cmap = font.readUInt32BE(entry + 8);
    for (let i = 0; i < font.readUInt16BE(cmap + 2); i++) {
      const map = cmap + font.readUInt32BE(cmap + 4 + 8 * i + 4);
      const format = font.readUInt16BE(map);
      if (format === 4) {
        const doubled = font.readUInt16BE(map + 6);
        for (let s = 0; s < doubled; s += 2) {
          const last = font.readUInt16BE(map + 14 + s);
          for (let c = font.readUInt16BE(map + 16 + doubled + s); c <= last && c !== 0xffff; c++) points.add(c);
        }
      } else if (format === 12) {
        for (let g = 0; g < font.readUInt32BE(map + 12); g++) {
          const group = map + 16 + 12 * g;
          for (let c = font.readUInt32BE(group); c <= font.readUInt32BE(group + 4); c++) points.add(c);
        }
      }
    }
  }
  return points;
}

/** @param {string} folder */
async function cutFonts(folder) {
  const require = createRequire(import.meta.url);
  /** @type {(font: Buffer, text: string, options: object) => Promise<Buffer>} */
  let subsetFont;
  let inter;
  try {
    subsetFont = require('subset-font');
    inter = join(dirname(require.resolve('inter-ui/package.json')), 'web');
  } catch {
    throw new Error('the node packages are not installed: run ./dev setup');
  }
  await mkdir(folder, { recursive: true });

  for (const [face, source] of Object.entries(FACES)) {
    const whole = await readFile(join(inter, `${source}.woff2`));
    const ttf = await subsetFont(whole, CHARACTERS, { targetFormat: 'truetype', ...CUT });
    await writeFile(join(folder, `inter-${face}.ttf`), ttf);

    const present = mappedCodePoints(ttf);
    const missing = [...CHARACTERS].filter((c) => !present.has(/** @type {number} */ (c.codePointAt(0))));
    console.log(`inter-${face}: ${ttf.length} bytes`
      + (missing.length ? `; Inter has no ${missing.join(' ')}` : ''));
  }
}

const folder = process.argv[2] ?? fileURLToPath(new URL('../../build/fonts', import.meta.url));
cutFonts(folder).catch((error) => {
  console.error(`fonts: ${error.message}`);
  process.exitCode = 1;
});
