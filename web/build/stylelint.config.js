// SPDX-License-Identifier: MIT
// What styles are checked for. ./dev lint runs it.
export default {
  extends: 'stylelint-config-standard',
  rules: {
    // One rule a line, as in a table; groups of them stand together.
    'declaration-block-single-line-max-declarations': null,
    'rule-empty-line-before': null,
    'at-rule-empty-line-before': null,
    'comment-empty-line-before': null,
    'custom-property-empty-line-before': null,
    // A state of a control stands beside the control, not sorted by weight.
    'no-descending-specificity': null,
    // Ranges like (width <= 700px) are younger than the browsers that the page runs in.
    'media-feature-range-notation': null,
    // The palettes are read by programs and people side by side: all six digits.
    'color-hex-length': null,
    // Names of typefaces keep their capitals, and Safari still wants its prefix.
    'function-url-quotes': 'never',
    'value-keyword-case': ['lower', { ignoreKeywords: [/^[A-Z]/] }],
    'property-no-vendor-prefix': null,
  },
};
