// SPDX-License-Identifier: MIT
// Quiz questions of a lesson. Choosing an answer shows its explanation.

/** @param {HTMLElement} quiz */
function start(quiz) {
  const feedback = quiz.querySelector('.feedback');
  const answers = quiz.querySelector('details');
  const explained = [...quiz.querySelectorAll('.why')];
  if (!feedback || !answers) return;
  answers.hidden = true; // only needed without JavaScript
  quiz.addEventListener('change', ({ target }) => {
    if (!(target instanceof HTMLInputElement)) return;
    feedback.replaceChildren(...[...explained[Number(target.value)].childNodes].map((node) => node.cloneNode(true)));
    feedback.classList.toggle('right', target.dataset.right !== undefined);
  });
}

export function startQuizzes() {
  for (const quiz of document.querySelectorAll('.quiz')) if (quiz instanceof HTMLElement) start(quiz);
}
