// SPDX-License-Identifier: MIT
// The page where a teacher saves a lesson as a SCORM package (web/classroom/packages.js).
import { attributes, escaped } from '../html.mjs';

/** @param {import('../lesson_page.mjs').LessonPage[]} lessons @returns {import('../template.mjs').Sheet} */
export const packagesPage = (lessons) => ({
  title: 'Packages for learning systems', address: 'packages.html', kind: 'tool',
  description: 'Save a lesson as a SCORM package for Moodle, Canvas or another learning system.',
  styles: ['teaching.css'], scripts: ['../classroom/packages.js'],
  body: `<main id="main" tabindex="-1">
<p class="group"><a href="teachers.html">For teachers</a></p>
<h1>Packages for learning systems</h1>
<p class="hook">A SCORM package is a ZIP file that Moodle, Canvas and similar systems take as an activity. It holds the lesson and the playground, reports a score to
your course, and keeps what your pupils did. It is made here, in your browser.</p>
<form id="package" class="tray">
<p><label for="package-lesson">Lesson</label> <select id="package-lesson">${lessons.map(({ name, lesson }) => `<option${attributes({ value: name })}>${lesson.number}. ${escaped(lesson.title)}</option>`).join('')}</select></p>
<p><label for="package-version">SCORM version</label> <select id="package-version"><option>1.2</option><option>2004</option></select></p>
<p class="row"><button type="submit" class="primary" disabled>Save the package</button> <button type="button" id="package-cancel" class="bordered" hidden>Cancel</button>
<progress id="package-progress" max="1" value="0" aria-label="Progress" hidden></progress></p>
<p id="package-state" role="status"></p>
</form>
<p>Moodle takes either version. Other systems name the one they want. In Moodle, add the activity <em>SCORM package</em> and choose the file.</p>
<p>For an assignment of your own, open <a href="../">the playground</a>, press <em>Share</em>, unfold <em>Embed, or make an assignment</em>, write a goal, and press
<em>Save a SCORM package</em>. <a href="teachers.html#in-your-own-course-page">What packages report</a></p>
</main>`,
});
