// SPDX-License-Identifier: MIT
// Checks of the scripts, beside their types. ./dev lint runs them.
import { fileURLToPath } from 'node:url';
import eslint from '@eslint/js';
import stylistic from '@stylistic/eslint-plugin';
import tseslint from 'typescript-eslint';

const web = fileURLToPath(new URL('../', import.meta.url));

export default tseslint.config(
  { ignores: ['**/node_modules/', 'web/package/engine/example.js', 'build/'] },
  eslint.configs.recommended,
  tseslint.configs.base,
  stylistic.configs.customize({ indent: 2, quotes: 'single', semi: true, arrowParens: true, braceStyle: '1tbs', commaDangle: 'always-multiline', jsx: false }),
  {
    languageOptions: { parserOptions: { project: './tsconfig.json', tsconfigRootDir: web } },
    rules: {
      // Format: the customized rules above, but for short functions and conditions on one line.
      '@stylistic/max-statements-per-line': ['error', { max: 3 }],
      '@stylistic/multiline-ternary': 'off',
      '@stylistic/quote-props': ['error', 'as-needed'],
      'no-undef': 'off', // tsc checks this
      'no-unused-vars': ['error', { argsIgnorePattern: '^_', varsIgnorePattern: '^_', caughtErrors: 'none' }],
      'no-empty': ['error', { allowEmptyCatch: true }],
      'prefer-const': 'error',
      'no-var': 'error',
      eqeqeq: 'error',
      'no-implicit-coercion': 'off',
      'object-shorthand': 'error',
      '@typescript-eslint/await-thenable': 'error',
      '@typescript-eslint/no-floating-promises': ['error', { allowForKnownSafeCalls: [{ from: 'package', package: 'node:test', name: ['test', 'before', 'after', 'describe', 'it'] }] }],
      '@typescript-eslint/no-misused-promises': ['error', { checksVoidReturn: { arguments: false, attributes: false, properties: false } }],
      '@typescript-eslint/no-unnecessary-type-assertion': 'off',
      '@typescript-eslint/prefer-promise-reject-errors': 'error',
      '@typescript-eslint/only-throw-error': 'error',
      '@typescript-eslint/switch-exhaustiveness-check': 'off',
    },
  },
);
