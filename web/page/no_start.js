// SPDX-License-Identifier: MIT
// Reports the reason if the browser cannot load the modules. So it is not a module itself.
document.addEventListener('error', (event) => {
  const failed = event.target;
  const ours = failed instanceof HTMLScriptElement && failed.type === 'module';
  if (!ours) return;
  const reason = location.protocol === 'file:'
    ? 'Browsers do not run Gaitsmith from a file. Put its folder on any web server, or open it on the web.'
    : self.origin === 'null'
      ? 'This page was put into another one in a way that keeps its scripts from loading: the frame’s sandbox needs allow-same-origin. Open Gaitsmith in a tab of its own instead.'
      : 'A part of Gaitsmith could not be loaded. Reload the page.';
  addEventListener('DOMContentLoaded', () => {
    const place = document.querySelector('#loading p');
    if (place) place.textContent = reason;
  });
}, true);
