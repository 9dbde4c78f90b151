// SPDX-License-Identifier: MIT
// Weights of a style term that suit a figure. docs/style.md has the evidence.
#pragma once

#include <array>

#include "core/document/document.h"

namespace gaitsmith {

/// One weight for each term, in the order of StyleTerm, per unit of the term, above 0.
using StyleWeights = std::array<float, kStyleTerms>;

/// Weights with a clear effect that leave at least half of the travel. The figure is known by its name up to
/// a comma, and by the document's senses. A figure that was not calibrated gets weights between those of
/// others.
[[nodiscard]] StyleWeights UsualWeights(const Document&);

/// Weights with which travel usually stays the larger part of the score. Never above the usual ones.
[[nodiscard]] StyleWeights GentleWeights(const Document&);

}  // namespace gaitsmith
