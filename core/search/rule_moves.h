// SPDX-License-Identifier: MIT
// Changes a bank where it acts: rules move, and new rules appear at states that its motion really passes.
//
// Random perturbation mostly changes rules that never act, or places boxes where no figure comes. With
// sightings of the motion a change picks rules that act and centres boxes on what was sensed.
#pragma once

#include <span>

#include "core/control/sighting.h"
#include "core/search/operators.h"

namespace gaitsmith {

/// A child that differs from its parent in at least one gene.
/// @param parent    of a bank
/// @param sightings of the parent's motion; empty: unknown, then all rules are changed alike and no box is
///                  centred on a sense
[[nodiscard]] Genome MoveRules(const Genome& parent, std::span<const Sighting> sightings,
                               const BankShape& bank, RandomStream& random);

}  // namespace gaitsmith
