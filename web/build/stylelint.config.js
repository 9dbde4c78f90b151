// SPDX-License-Identifier: MIT
// Checks of the style sheets. ./dev lint runs them.
export default {
  extends: 'stylelint-config-standard',
  rules: {
    // One rule per line, as in a table, in groups.
    'declaration-block-single-line-max-declarations': null,
    'rule-empty-line-before': null,
    'at-rule-empty-line-before': null,
    'comment-empty-line-before': null,
    'custom-property-empty-line-before': null,
    // A control's states are next to the control, not sorted by specificity.
    'no-descending-specificity': null,
    // Not all supported browsers understand ranges like (width <= 700px).
    'media-feature-range-notation': null,
    // Always six digits, because programs read the palettes, too.
    'color-hex-length': null,
    // Names of typefaces have capitals, and Safari still needs its prefix.
    'function-url-quotes': 'never',
    'value-keyword-case': ['lower', { ignoreKeywords: [/^[A-Z]/] }],
    'property-no-vendor-prefix': null,
  },
};
