// SPDX-License-Identifier: MIT
// The children of a round of a document's lineage, and what they are bred in. Children follow from their
// round and those before it: same document, same children, on every machine.
#pragma once

#include <memory>
#include <span>

#include "core/breeding/brood.h"
#include "core/document/document.h"

namespace gaitsmith {

/// Simulations that a round may take.
inline constexpr int kRoundEvaluations = 2000;

/// The document that a round of children is bred in: figure and ground of `document` without pushes, and a
/// lineage with this one round, whose founders are its parents. It has no controllers.
/// @param document valid, with a lineage
/// @param round of its lineage
/// @param litter the children of the round's parent, in their order; unused if that is the founders
/// @return an error if a child was picked that is not there, or does not fit
[[nodiscard]] Result<Document> NurseryOf(const Document& document, int round, std::span<const Genome> litter);

/// A nursery for parents that were picked outside a lineage. @param wish whose parent and picks are not read
[[nodiscard]] Document NurseryOf(const Document& document, std::vector<Controller> parents, BreedRound wish);

/// What the children of a nursery are scored in: also their traits are measured.
[[nodiscard]] Problem NurseryProblem(const Document& nursery);
/// The search for the children of a nursery. Rounds of a lineage have the standard numbers.
/// @param evaluations at least 200
[[nodiscard]] std::unique_ptr<Brood> BroodOf(const Document& nursery, int evaluations = kRoundEvaluations,
                                             int children = kLitter);

/// A document that shows one child for the duration of its task, without pushes. Its lineage stays.
/// @param document a nursery, or one whose founders have the child's shape
[[nodiscard]] Document ChildOf(const Document& document, Genome child);

}  // namespace gaitsmith
