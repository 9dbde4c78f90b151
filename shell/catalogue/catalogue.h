// SPDX-License-Identifier: MIT
// The catalogue: every table that the page, the documents and the command line have in common, as text.
// Whatever lists these names elsewhere reads it or is tested against it.
#pragma once

#include <string>

namespace gaitsmith::shell {

/// All tables as one JSON object, with two spaces a level and a row a line.
[[nodiscard]] std::string CatalogueJson();

/// The same as a module of JavaScript, without spaces: one exported list for each table that the page
/// reads, with what it reads of it.
/// web/catalogue/catalogue.d.ts has its types.
[[nodiscard]] std::string CatalogueModule();

}  // namespace gaitsmith::shell
