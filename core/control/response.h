// SPDX-License-Identifier: MIT
// What controllers ask of the joints, lane by lane.
#pragma once

#include <array>

#include "core/numeric/lane.h"
#include "core/physics/constants.h"

namespace gaitsmith {

template <int W>
struct Response {
  using F = typename Lane<W>::F;
  std::array<F, kMaxJoints> target_rad;
  std::array<F, kMaxJoints> decay;        // exp(-h / tau)
  std::array<F, kMaxJoints> inverse_tau;  // [1/s]
};

}  // namespace gaitsmith
