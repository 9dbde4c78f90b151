// SPDX-License-Identifier: MIT
// The usual weight of a style term: it gives a clear effect and leaves at least half of the travel.
#pragma once

#include <array>

#include "core/document/document.h"

namespace gaitsmith {

/// The usual weights for a document's figure, known by its name up to a comma, and its senses. docs/style.md
/// has the evidence. A figure that was not calibrated gets weights between those of calibrated figures.
/// @return in the order of StyleTerm, per unit of the term, above 0
[[nodiscard]] std::array<float, kStyleTerms> UsualWeights(const Document&);

}  // namespace gaitsmith
