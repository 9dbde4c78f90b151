// SPDX-License-Identifier: MIT
// The document with which a person begins, in the page and with `gaitsmith new`.
#pragma once

#include "core/document/document.h"

namespace gaitsmith {

/// A tenth of the paper's budget, which the browser makes in about a second (docs/search.md).
inline constexpr int kQuickEvaluations = 4000;

/// Sets the search that a person begins with: pose-cycle with kQuickEvaluations. Keeps the seed. Documents of
/// core begin with SPHC.
void BeginWithQuickSearch(SearchSettings&);

/// The figure stands still, without a controller. Its next search is the quick one, and wants it to get as
/// far to the right in eight seconds as it can, in metres alone. The physical senses and the fastest response
/// are core's. docs/search.md, "The first press", says how far every shipped figure gets.
[[nodiscard]] Document Standing(const Figure&);

}  // namespace gaitsmith
