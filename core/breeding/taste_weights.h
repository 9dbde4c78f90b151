// SPDX-License-Identifier: MIT
// A learned taste as the ordinary weights of a document, so that it can be tuned by hand, shared, and used by
// every search.
#pragma once

#include "core/breeding/taste.h"
#include "core/document/style_weights.h"

namespace gaitsmith {

/// Whether a trait's weight is greater than its doubt.
[[nodiscard]] inline bool SureOf(const Taste& taste, Trait trait) {
  return std::abs(TraitOf(taste.Weights(), trait)) > TraitOf(taste.Doubts(), trait);
}

/// Weights for the document's task with which its fitness orders motions as the taste does, as far as style
/// terms can: a metre of the primary term stays worth 1. Terms whose weight is far smaller than its doubt get
/// 0. If the taste does not care for the primary term, its metre still counts a little, because documents
/// have no weight for it.
[[nodiscard]] std::array<float, kStyleTerms> WeightsOf(const Taste&, const Document&);

}  // namespace gaitsmith
