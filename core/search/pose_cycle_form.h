// SPDX-License-Identifier: MIT
// Pose cycles: banks of rules, and trajectories, that cycle by construction, as points of a small cube.
//
// With physical senses rule k says "when the joints are near pose k - 1, go to pose k", so K rules pass the
// figure round K poses. With a timer the K poses share the period, and the sequence may repeat in it. All
// further rules never act. A trajectory's knots lie on the same sequence. A point has J + 2 numbers in [0, 1]
// for each pose: J joint angles, the time constant, and the width (how near is near) or the share of the
// period.
#pragma once

#include <span>
#include <vector>

#include "core/search/operators.h"

namespace gaitsmith {

/// The discrete part of a pose cycle.
struct CycleForm {
  int poses = 2;    // K, [1, rules]
  int repeats = 1;  // of the sequence in a timer's period, [1, rules / K]; 1 with physical senses

  bool operator==(const CycleForm&) const = default;
};

/// Number of coordinates of a point.
[[nodiscard]] inline std::size_t DimensionsOf(const CycleForm& form, const BankShape& bank) {
  return static_cast<std::size_t>(form.poses) * static_cast<std::size_t>(bank.joints + 2);
}

/// Draws a form: 2 poses with physical senses; 3 poses and any number of repeats with a timer.
[[nodiscard]] CycleForm DrawForm(const BankShape& bank, SenseKind senses, RandomStream& random);

/// Draws a point from the prior. It prefers what winning cycles of nine figures had in common: fast
/// responses, wide boxes, and joints near the ends of their ranges. docs/search.md has the figures.
[[nodiscard]] std::vector<double> DrawPoint(const CycleForm& form, const BankShape& bank,
                                            RandomStream& random);

/// The trajectory of a point: in each pose's share of the period the joints move evenly to it from the pose
/// before, for the share of that time that stands for the time constant, and then stay.
/// @param point clamped to [0, 1]
[[nodiscard]] Genome CycleAt(const CycleForm& form, std::span<const double> point, const CurveShape& curves);

/// The bank of a point. @param point clamped to [0, 1]
[[nodiscard]] Genome CycleAt(const CycleForm& form, std::span<const double> point, const BankShape& bank,
                             SenseKind senses);

/// Makes a rule silent: its stimulus is one point at the end of the first sense, where no figure stays.
void Silence(Genome& genes, const BankShape& bank, int rule);
/// Lets a rule ignore every sense.
void IgnoreAll(Genome& genes, const BankShape& bank, int rule);

/// A share in [0, 1] as a gene. @param share clamped
[[nodiscard]] Gene GeneOf(double share);

}  // namespace gaitsmith
