// SPDX-License-Identifier: MIT
// The files that make a copy of this site a SCORM package: what a learning system reads first, and the page it opens.

/** @typedef {'1.2' | '2004'} Version */

/**
 * Whether a package holds this file of the site. The service worker would take over addresses of the learning system.
 * @param {string} name
 */
export const isPackaged = (name) => !/^(package\/|book\/(reference|pictures)\/|book\/(\w\w\/)?search\.json|service_worker\.js|files\.json)/.test(name);

/** @param {string} text */
const escaped = (text) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;').replaceAll('"', '&quot;');

/**
 * Files to add to those of the site.
 * @param {{name: string, title: string, launch: string, version: Version, files: string[]}} parts  name: letters, digits and hyphens;
 * launch: address in the site, with ?scorm; files: of the site
 * @returns {Record<string, string>} texts by name
 */
export function scormFiles({ name, title, launch, version, files }) {
  return { 'imsmanifest.xml': manifest({ name, title, version, files: ['launch.html', ...files] }), 'launch.html': launcher(title, launch) };
}

/** A page of its own, because learning systems treat a query or a fragment in a manifest in different ways. @param {string} title @param {string} address */
const launcher = (title, address) => `<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta http-equiv="refresh" content="0; url=${escaped(address)}">
<title>${escaped(title)}</title>
<p><a href="${escaped(address)}">${escaped(title)}</a></p>
</html>
`;

/** @param {{name: string, title: string, version: Version, files: string[]}} parts */
function manifest({ name, title, version, files }) {
  const old = version === '1.2';
  const spaces = old
    ? 'xmlns="http://www.imsproject.org/xsd/imscp_rootv1p1p2" xmlns:adlcp="http://www.adlnet.org/xsd/adlcp_rootv1p2"'
    : 'xmlns="http://www.imsglobal.org/xsd/imscp_v1p1" xmlns:adlcp="http://www.adlnet.org/xsd/adlcp_v1p3" xmlns:imsss="http://www.imsglobal.org/xsd/imsss"';
  // The lesson itself says when it is completed.
  const sequencing = old ? '' : '<imsss:sequencing><imsss:deliveryControls completionSetByContent="true" objectiveSetByContent="true"/></imsss:sequencing>';
  return `<?xml version="1.0" encoding="UTF-8"?>
<manifest identifier="gaitsmith-${name}" version="1" ${spaces}>
<metadata><schema>ADL SCORM</schema><schemaversion>${old ? '1.2' : '2004 4th Edition'}</schemaversion></metadata>
<organizations default="course"><organization identifier="course"><title>${escaped(title)}</title>
<item identifier="lesson" identifierref="page"><title>${escaped(title)}</title>${sequencing}</item>
</organization></organizations>
<resources><resource identifier="page" type="webcontent" adlcp:${old ? 'scormtype' : 'scormType'}="sco" href="launch.html">
${files.map((file) => `<file href="${escaped(file)}"/>`).join('\n')}
</resource></resources>
</manifest>
`;
}
