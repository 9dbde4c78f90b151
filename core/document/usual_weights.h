// SPDX-License-Identifier: MIT
// The weight of a style term that asks for it plainly and leaves at least half of the travel.
#pragma once

#include <array>

#include "core/document/document.h"

namespace gaitsmith {

/// For a document's figure, known by its name up to a comma, and its senses; docs/style.md has the evidence.
/// A figure that nobody has calibrated gets weights between those that were.
/// @return in the order of StyleTerm, per unit of the term, above 0
[[nodiscard]] std::array<float, kStyleTerms> UsualWeights(const Document&);

}  // namespace gaitsmith
