// SPDX-License-Identifier: MIT
// Runs the native program rounds.cpp, which simulates one round per command.
import { spawn } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import { ROOT } from '../browser/browsers.mjs';

export class NativeRounds {
  /** @type {((line: string) => void)[]} */
  #waiting = [];

  /** @param {string} program */
  constructor(program) {
    this.child = spawn(program, { stdio: ['pipe', 'pipe', 'inherit'] });
    createInterface({ input: this.child.stdout }).on('line', (line) => this.#waiting.shift()?.(line));
    this.child.once('error', (error) => { throw error; });
  }

  /** @param {string} build  a folder of build/ @returns {NativeRounds | null} null if not built */
  static of(build) {
    const program = join(ROOT, 'build', build, 'tests/bench/rounds');
    return existsSync(program) ? new NativeRounds(program) : null;
  }

  /** @param {string} command @returns {Promise<string>} the program's answer */
  ask(command) {
    return new Promise((resolve) => {
      this.#waiting.push(resolve);
      this.child.stdin.write(`${command}\n`);
    });
  }

  close() { this.child.stdin.end(); }
}
