// SPDX-License-Identifier: MIT
// Reads genes as a whole document: figure, joints, ground, start, pushes and controller. The project's own
// searches can therefore look for motions that violate a law, over everything that a user can set.
#pragma once

#include <span>
#include <string_view>

#include "core/document/document.h"

namespace gaitsmith::test {

/// The range of documents that the adversary searches.
enum class Scope {
  kGait,      // a shipped figure on level ground, the most common case of searches; tau down to its limit
  kOrdinary,  // rods of 0.2 to 2 m and 0.2 to 5 kg, usual grounds, tau from 0.07 s
  kAny,       // the whole range of documents, extremes included
};
inline constexpr std::array<std::string_view, 3> kScopeNames = {"gait", "ordinary", "any"};

/// Number of genes that determine a document. Further ones are ignored.
inline constexpr std::size_t kDocumentGenes = 500;
/// A space with at least this number of genes, without meaning, for MakeSearch.
[[nodiscard]] SearchSpace SpaceOfDocuments();

/// @param model of the physics, [1, kModelVersion]. With model 2 the genes also determine the joints'
/// strength and stiffness, with model 3 a figure of springs. With model 1 they mean what they always meant,
/// so that old finds can be found again
/// @param still no controller: the figure holds its drawn pose
/// @return a valid document with one clip, or without clips if still
[[nodiscard]] Document DocumentOf(Scope scope, int model, bool still, std::span<const Gene> genes);

}  // namespace gaitsmith::test
