// SPDX-License-Identifier: MIT
// What the page for new lessons inserts into the text: motions, goals, predictions and questions, as the builder reads
// them.
import { PLAYGROUND } from '../links.mjs';

const PARAMETERS = ['panels', 'lock', 'goal'];

/**
 * A link of the playground as a lesson has it: the motion is in the link, so no file of examples is needed.
 * @param {string} link @returns {string} '': the text is none
 */
export function motionLink(link) {
  const [, query = '', payload] = /^[^?#]*(?:\?([^#]*))?#([\w-]+)\s*$/.exec(link.trim()) ?? [];
  if (payload === undefined) return '';
  const kept = new URLSearchParams([...new URLSearchParams(query)].filter(([key]) => PARAMETERS.includes(key))).toString();
  return `../../${PLAYGROUND}${kept && `?${kept}`}#${payload}`;
}

/** The words of a link or picture, and the line that goes to the end of the text. @param {string} text  so far @param {string} link  of motionLink() @param {string} words @param {boolean} strip */
export function motion(text, link, words, strip) {
  const numbers = [...text.matchAll(/^\[motion-(\d+)\]:/gm)].map(([, number]) => Number(number));
  const name = `motion-${Math.max(0, ...numbers) + 1}`;
  return { inserted: `${strip ? '!' : ''}[${words.replace(/[[\]]/g, '')}][${name}]`, end: `[${name}]: ${link}` };
}

/** @param {string} kind @param {string[]} lines */
const block = (kind, lines) => `\n\`\`\`${kind}\n${lines.map((line) => line.replace(/\s+/g, ' ').replaceAll('```', '').trim()).join('\n')}\n\`\`\`\n`;

/** @param {string} conditions @param {string} words */
export const goal = (conditions, words) => block('goal', [conditions, words]);

/** @param {string} question @param {string[]} answers  or one slider */
export const prediction = (question, answers) => block('predict', [question, ...answers.length === 1 ? answers : answers.map((answer) => `( ) ${answer}`)]);

/** @param {string} question @param {{answer: string, why: string, right: boolean}[]} answers */
export const quiz = (question, answers) => block('quiz', [question, ...answers.map(({ answer, why, right }) => `(${right ? 'x' : ' '}) ${answer.replaceAll('|', '/')} | ${why}`)]);
