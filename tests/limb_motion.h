// SPDX-License-Identifier: MIT
// How the limbs of a figure of model 2 move in a step, computed from the positions of a motion alone: their
// energy, the most that their joints can have given them, and their angular momentum.
#pragma once

#include <array>

#include "core/document/document.h"
#include "core/physics/mechanism.h"

namespace gaitsmith::test {

class LimbMotion {
 public:
  /// @param motion the document's motion, which must outlive this
  LimbMotion(const Document& document, const Motion& motion) : body_(document.figure), motion_(motion) {}

  /// Both seen from the centre of mass, in the middle of a step. @param frame the end of the step, at least 1
  struct Turning {
    double energy_j;          // kinetic
    double angular_momentum;  // [kg m^2/s]
    double of_all;            // what that would be if all parts had the same sign [kg m^2/s]
  };
  [[nodiscard]] Turning InStep(int frame) const;
  /// Of all limbs, each taken as if it lay where it counts most [kg m^2].
  [[nodiscard]] double WholeInertia() const;
  /// The most that joints of this strength can have worked from the middle of the step before to the middle
  /// of this step [J]. A stop does not work: it only takes energy. @param frame the end of this step, at
  /// least 2
  [[nodiscard]] double MostWork(int frame) const;

 private:
  /// Of a joint in a step [rad].
  [[nodiscard]] double Turned(int frame, int joint) const;

  Mechanism body_;
  const Motion& motion_;
};

}  // namespace gaitsmith::test
