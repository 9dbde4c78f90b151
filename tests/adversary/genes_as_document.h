// SPDX-License-Identifier: MIT
// Genes read as a whole document: figure, ground, start, pushes and controller. So the project's own searches
// can look for motions that break a law, over everything that a person can set.
#pragma once

#include <span>
#include <string_view>

#include "core/document/document.h"

namespace gaitsmith::test {

/// Where the adversary may look.
enum class World {
  kGait,      // a shipped figure on level ground: what searches meet every day; tau as hasty as it may be
  kOrdinary,  // rods of 0.2 to 2 m and 0.2 to 5 kg, the ground's usual figures, tau from 0.07 s
  kAny,       // the whole range that documents may ask for, extremes included
};
inline constexpr std::array<std::string_view, 3> kWorldNames = {"gait", "ordinary", "any"};

/// How many genes a document is made of; further ones are ignored.
inline constexpr std::size_t kDocumentGenes = 500;
/// A space of at least so many genes, of no meaning: for MakeSearch.
[[nodiscard]] SearchSpace SpaceOfDocuments();

/// @param still no controller: the figure holds its drawn pose
/// @return a valid document with one clip, or none if still
[[nodiscard]] Document DocumentOf(World world, bool still, std::span<const Gene> genes);

}  // namespace gaitsmith::test
