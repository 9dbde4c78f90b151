// SPDX-License-Identifier: MIT
// An English page, prepared for translation: only what is words, and links that lead from one folder deeper.

/** The keys of a block's JSON that are words. */
export const WORDS = ['label', 'slider', 'says', 'names'];

/** @param {string} text  of a file in docs/ @param {string[]} translated  names in docs/ of all pages that languages have @returns {string} of its file in docs/<code>/ */
export function prepared(text, translated) {
  const names = new Set(translated.map((name) => name.split('/').pop()));
  return text
    .replace(/^---\n(.*?)\n---\n/s, (_, fields) => `---\n${/^title:.*$/m.exec(fields)?.[0] ?? 'title:'}\n---\n`)
    .replace(/^```(\w+)\n(.*?)^```$/gms, (whole, kind, content) => {
      if (kind === 'goal') return `\`\`\`goal\n${content.slice(content.indexOf('\n') + 1)}\`\`\``;
      if (kind === 'quiz' || kind === 'predict') return whole.replace(/^\(x\)/gm, '( )');
      if (kind !== 'do' && kind !== 'stage') return whole;
      const words = Object.entries(JSON.parse(content)).filter(([key]) => WORDS.includes(key));
      return `\`\`\`${kind}\n{${words.map(([key, value]) => `${JSON.stringify(key)}: ${JSON.stringify(value)}`).join(', ')}}\n\`\`\``;
    })
    // What is translated, too, lies at the same place of that folder.
    .replace(/\]\((?!https?:|#)([^)\s]+)\)/g, (whole, path) => (names.has(path.replace(/[?#].*$/, '').split('/').pop()) ? whole : `](../${path})`));
}
