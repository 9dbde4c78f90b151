// SPDX-License-Identifier: MIT
// Muscles of figures of springs: how their rest follows a controller, and the work that they do.
#pragma once

#include <array>
#include <span>

#include "core/physics/joint_response.h"
#include "core/springs/lattice.h"
#include "core/springs/lattice_state.h"
#include "core/world/environment.h"

namespace gaitsmith {

/// Advances the rest of all muscles by one step, as joints follow their targets (physics/joint_response.h).
template <int W>
void MoveMuscles(const Lattice& body, const ActuatorTargets<W>& targets, float step_s, LatticeState<W>& s) {
  for (std::size_t j = 0; j < body.muscles; ++j) {
    const Lattice::Muscle& muscle = body.muscle[j];
    s.rest_change[j] = FollowTarget<W>({targets.target[j], targets.decay[j], targets.inverse_tau[j]}, step_s,
                                       muscle.least, muscle.greatest, s.rest[j], s.rest_rate[j]);
  }
}

/// What the muscles of model 3 did, for the terms of style.
template <int W>
class SpringMuscles {
  using F = typename Lane<W>::F;

 public:
  struct Memory {};  // nothing is remembered

  SpringMuscles(const Lattice& body, float /*step_s*/) : muscles_(body.muscles) {}

  [[nodiscard]] Memory Begin(const LatticeState<W>& /*state*/) const { return {}; }
  /// Work of all muscles in the last step, gained or lost [J].
  [[nodiscard]] F WorkOf(const LatticeState<W>& s) const {
    F work{};
    for (std::size_t j = 0; j < muscles_; ++j) work += Lane<W>::Abs(s.work_j[j]);
    return work;
  }

 private:
  std::size_t muscles_;
};

}  // namespace gaitsmith
