// SPDX-License-Identifier: MIT
// Applies the theme that was chosen in the playground (web/page/theme.js) before the first paint. Not a module, because
// modules run later.
(() => {
  const dark = matchMedia('(prefers-color-scheme: dark)');
  const contrast = matchMedia('(prefers-contrast: more), (forced-colors: active)');

  function chosen() {
    try {
      return localStorage.getItem('gaitsmith-theme');
    } catch {
      return null; // no storage: the system's theme
    }
  }

  function look() {
    const { dataset } = document.documentElement;
    const theme = chosen();
    const strong = theme === 'contrast' || (theme !== 'light' && theme !== 'dark' && contrast.matches);
    if (theme === 'light' || theme === 'dark') dataset.theme = theme;
    else if (theme === 'projector') dataset.theme = 'strong-light';
    else dataset.theme = `${strong ? 'strong-' : ''}${dark.matches ? 'dark' : 'light'}`;
    dataset.scale = theme === 'projector' ? 'large' : 'normal';
  }

  look();
  for (const query of [dark, contrast]) query.addEventListener('change', look);
  addEventListener('storage', look); // chosen in another window, or in the playground on this page
})();
