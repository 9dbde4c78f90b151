// SPDX-License-Identifier: MIT
// The laws that the physics keeps in every motion, as numbers: how far a motion is from keeping each law.
// Used by the laws' tests, the fuzzer and the adversary.
//
// In model 1 muscles are as strong as they need to be: joint angles are prescribed, so a figure's energy may
// change by any amount through its joints, and no law limits this. The laws limit ground, gravity and flight.
// In model 2 the limbs move each other, so what they gain in flight is limited by the joints' strength. A
// motion counts as void from the step in which a guard trips (constants.h). The laws hold before it.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/document/document.h"

namespace gaitsmith::test {

enum class Law {
  kFinite,       // every number of every frame is finite: count of the others
  kJointLimits,  // no joint exceeds its limits [rad]
  kAboveGround,  // no endpoint is below ground at the end of a step, as a share of the figure's reach
  kPush,         // the ground never pulls: negative normal impulse over mass [m/s]
  kCone,         // |T| <= mu N: the part of |T| outside
  kMomentum,  // linear momentum changes only by gravity, pushes and the ground's impulses: the difference, as
              // a share of all momenta involved
  kFlight,    // without ground and pushes the angular momentum keeps its bits: relative change
  kMoment,    // the ground's impulses act at the endpoints: error of their lever arm, over the figure's reach
              // and its path in the step
  kStillEnergy,  // while no joint moves, kinetic energy grows at most by gravity's work: gain in a step, over
                 // M g l plus the energy E of the figure's motion as one body
  kStillGain,    // gains of kStillEnergy summed over all steps [per second]
  kGroundWork,   // the ground adds no energy, neither by its impulses, at the mean of the velocities before
                 // and after them, nor by lifting: gain in a step, over M g l + E
  kGroundGain,   // gains of kGroundWork summed over all steps [per second]
  kLifting,      // distance that the figure is lifted out of the ground [m/s]
  // Of model 2 only.
  kLimbWork,  // in flight the limbs gain at most what their joints' strength gives: the rest of the gain in a
              // step, over M g l plus the energy of body and limbs
  kLimbGain,  // gains of kLimbWork summed over all steps [per second]
  kTurning,   // the angular momentum is that of the limbs' turning: difference as a share of all parts
};
inline constexpr int kLaws = 16;

/// The part of a violation that is rounding or the stated limit of the model. docs/physics.md gives the
/// reasons.
struct LawLimit {
  std::string_view name;
  std::string_view unit;
  double most;  // [unit]
};
/// The limits of a model. @param model [1, kModelVersion]
[[nodiscard]] const std::array<LawLimit, kLaws>& LawLimits(int model);
/// Whether a law is judged in a model. Springs have no joints; their plant shows no pull of the ground; their
/// energy is judged where all of it is known (tests/core/springs).
[[nodiscard]] constexpr bool Concerns(Law law, int model) {
  if (model == 3) return law <= Law::kMomentum && law != Law::kJointLimits && law != Law::kPush;
  return model > 1 || law < Law::kLimbWork;
}

/// The largest violation of a law in a motion.
struct Offence {
  double by = 0.0;  // in the law's unit; NaN counts as infinite
  int frame = 0;    // frame of the violation; for a sum the last frame
};

struct Offences {
  std::array<Offence, kLaws> of{};
  int judged = 0;  // number of frames before a guard trips
  int model = 1;   // whose limits count

  [[nodiscard]] const Offence& Against(Law law) const { return of[static_cast<std::size_t>(law)]; }
  /// The first law that was violated by more than its limit, or kLaws if there is none.
  [[nodiscard]] int FirstBroken() const;
  /// The first broken law in words: by how much, and where; empty if there is none.
  [[nodiscard]] std::string Sentence() const;
};

/// The M g l of the guard: standard gravity, longest rod [J].
[[nodiscard]] double EnergyUnit(const Skeleton&);

/// @param motion the document's motion
[[nodiscard]] Offences Judge(const Document& document, const Motion& motion);

/// Number of lane counts for which the evaluator's bits differ from the motion's, plus 1 if a second
/// simulation differs from the first. Should be 0. The controller runs in one lane, random ones in the
/// others.
/// @param document one clip, from the start
[[nodiscard]] int DifferingBits(const Document& document, const Motion& motion);

}  // namespace gaitsmith::test
