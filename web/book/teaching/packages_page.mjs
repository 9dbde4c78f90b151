// SPDX-License-Identifier: MIT
// The page where a teacher saves a lesson as a SCORM package (web/classroom/packages.js).
import { attributes, escaped } from '../html.mjs';

/** @param {import('../lesson_page.mjs').LessonPage[]} lessons @param {import('../languages/words.mjs').Language} language @returns {import('../template.mjs').Sheet} */
export const packagesPage = (lessons, language) => ({
  title: language.tr('Packages for learning systems'), address: `${language.folder}packages.html`, kind: 'tool', language,
  description: language.tr('Save a lesson as a SCORM package for Moodle, Canvas or another learning system.'),
  styles: ['teaching.css'], scripts: ['../classroom/packages.js'],
  body: bodyOf(lessons, language),
});

/** A lesson's package has the language in its name, as those of ./dev site --zip have. @param {import('../lesson_page.mjs').LessonPage} page */
const option = ({ name, address, lesson, language }) => `<option${attributes({ value: language.folder.replace('/', '-') + name, 'data-page': address })}>${lesson.number}. ${escaped(lesson.title)}</option>`;

/** @param {import('../lesson_page.mjs').LessonPage[]} lessons @param {import('../languages/words.mjs').Language} language */
const bodyOf = (lessons, { code, folder, tr }) => `<main id="main" tabindex="-1">
<p class="group"><a href="teachers.html">${tr('For teachers')}</a></p>
<h1>${tr('Packages for learning systems')}</h1>
<p class="hook">${tr('A SCORM package is a ZIP file that Moodle, Canvas and similar systems take as an activity. It holds the lesson and the playground, reports a score to your course, and keeps what your pupils did. It is made here, in your browser.')}</p>
<form id="package" class="tray">
<p><label for="package-lesson">${tr('Lesson')}</label> <select id="package-lesson">${lessons.map(option).join('')}</select></p>
<p><label for="package-version">${tr('SCORM version')}</label> <select id="package-version"><option>1.2</option><option>2004</option></select></p>
<p class="row"><button type="submit" class="primary" disabled>${tr('Save the package')}</button> <button type="button" id="package-cancel" class="bordered" hidden>${tr('Cancel')}</button>
<progress id="package-progress" max="1" value="0" aria-label="${tr('Progress')}" hidden></progress></p>
<p id="package-state" role="status"></p>
</form>
<p>${tr('Moodle takes either version. Other systems name the one they want. In Moodle, add the activity {1} and choose the file.', `<em>${tr('SCORM package')}</em>`)}</p>
<p>${tr('For an assignment of your own, open {1}, press {2}, unfold {3}, write a goal, and press {4}.', `<a href="${folder ? `../../?lang=${code}` : '../'}">${tr('the playground')}</a>`, `<em>${tr('Share')}</em>`, `<em>${tr('Embed, or make an assignment')}</em>`, `<em>${tr('Save a SCORM package')}</em>`)}
<a href="teachers.html#in-your-own-course-page">${tr('What packages report')}</a></p>
</main>`;
