// SPDX-License-Identifier: MIT
// What the physics promises of every motion, as numbers: how far a motion is from keeping each law. Whoever
// doubts it (the laws' tests, the fuzzer, the adversary) asks here.
//
// Muscles are as strong as they need to be: joint angles are prescribed, so a figure's energy may change by
// any amount through its joints, and no law speaks of that. What is promised is what the ground, gravity and
// flight may do. A motion counts as void from the step in which a guard trips (constants.h); laws hold before
// it.
#pragma once

#include <array>
#include <string_view>

#include "core/document/document.h"

namespace gaitsmith::test {

enum class Law {
  kFinite,       // every number of every frame is finite: how many are not
  kJointLimits,  // no joint is past its limits [rad]
  kAboveGround,  // no endpoint is below ground at the end of a step, as a share of the figure's reach
  kPush,         // the ground never pulls: normal impulse below zero over mass [m/s]
  kCone,         // |T| <= mu N: the part of |T| that lies outside
  kMomentum,     // linear momentum changes by gravity, pushes and the ground's impulses alone; what is
                 // missing, as a share of all momenta that took part
  kFlight,       // without ground and pushes the angular momentum keeps its bits: change over itself
  kMoment,       // the ground's impulses act where the endpoints are: error of their lever arm, over the
                 // figure's reach and its way in the step
  kStillEnergy,  // while no joint moves, kinetic energy grows by gravity's work at most: gained in a step,
                 // over M g l and the energy E of the figure's motion as one body
  kStillGain,    // the same, all steps that gain added up [a second]
  kGroundWork,   // the ground gives no energy, neither by its impulses, at the mean of the velocities before
                 // and after them, nor by lifting: given in a step, over M g l + E
  kGroundGain,   // the same, all steps that gain added up [a second]
  kLifting,      // the way that the figure is lifted out of the ground [m/s]
};
inline constexpr int kLaws = 13;

/// How much of an offence is rounding or the stated limit of the model, and why, in docs/physics.md.
struct LawLimit {
  std::string_view name;
  std::string_view unit;
  double most;  // [unit]
};
extern const std::array<LawLimit, kLaws> kLawLimits;
[[nodiscard]] inline const LawLimit& LimitOf(Law law) { return kLawLimits[static_cast<std::size_t>(law)]; }

/// The worst that a motion did against a law.
struct Offence {
  double by = 0.0;  // in the law's unit; not a number counts as infinite
  int frame = 0;    // where; of a sum the last
};

struct Offences {
  std::array<Offence, kLaws> of{};
  int judged = 0;  // frames before a guard trips

  [[nodiscard]] const Offence& Against(Law law) const { return of[static_cast<std::size_t>(law)]; }
  /// The first law that was broken by more than its limit; kLaws if none was.
  [[nodiscard]] int FirstBroken() const;
};

/// M g l of the guard: standard gravity, longest rod [J].
[[nodiscard]] double EnergyUnit(const Skeleton&);

/// @param motion that of the document
[[nodiscard]] Offences Judge(const Document& document, const Motion& motion);

/// In how many lane counts the evaluator's bits differ from the motion's, or that of a second simulation from
/// the first: 0. The figure moves among strangers, first in one lane, then in another.
/// @param document one clip, from the start
[[nodiscard]] int DifferingBits(const Document& document, const Motion& motion);

}  // namespace gaitsmith::test
