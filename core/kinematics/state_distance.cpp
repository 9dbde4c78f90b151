// SPDX-License-Identifier: MIT
#include "core/kinematics/state_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/numeric/scalar_math.h"
#include "core/world/environment.h"

namespace gaitsmith {

namespace {

/// A state as numbers without unit, the root's turn first.
void StateOf(const Motion& motion, int frame, std::vector<double>& state) {
  const auto length_m = static_cast<double>(motion.Bones().longest_rod_m);
  const double time_s = std::sqrt(length_m / static_cast<double>(kStandardGravity));
  const Motion::Frame &now = motion.At(frame), &before = motion.At(frame - 1);
  const auto turn = [](const Motion::Frame& of) { return static_cast<double>(of.turn_rad); };
  state.clear();
  state.push_back(turn(now));
  state.push_back((turn(now) - turn(before)) / static_cast<double>(kStep) * time_s);
  state.push_back(static_cast<double>(now.y_m) / length_m);
  state.push_back(static_cast<double>(now.velocity_x_mps) * time_s / length_m);
  state.push_back(static_cast<double>(now.velocity_y_mps) * time_s / length_m);
  for (int joint = 0; joint < motion.Connections().Actuators(); ++joint) {
    state.push_back(static_cast<double>(motion.AngleRad(frame, joint)));
    state.push_back(static_cast<double>(motion.RateRadps(frame, joint)) * time_s);
  }
  if (motion.Bones().rods > 0) return;
  // Muscles do not say where the nodes of a figure of springs are.
  for (int node = 0; node < motion.Connections().contacts; ++node) {
    const Motion::Point there = motion.Endpoint(frame, node), earlier = motion.Endpoint(frame - 1, node);
    for (const auto& [place, last] : {std::pair(there.x, earlier.x), std::pair(there.y, earlier.y)}) {
      state.push_back(static_cast<double>(place) / length_m);
      state.push_back(static_cast<double>(place - last) / static_cast<double>(kStep) * time_s / length_m);
    }
  }
}

}  // namespace

double StateDistance(const Motion& motion, int frame, const Motion& usual, int first) {
  std::vector<double> here, there;
  StateOf(motion, frame, here);
  double least = std::numeric_limits<double>::infinity();
  for (int i = first; i < usual.Frames(); ++i) {
    StateOf(usual, i, there);
    const double turns = (here[0] - there[0]) / (2.0 * kPi);
    const double turned = (turns - std::floor(turns + 0.5)) * (2.0 * kPi);
    double squares = turned * turned;
    for (std::size_t k = 1; k < here.size(); ++k) squares += (here[k] - there[k]) * (here[k] - there[k]);
    least = std::min(least, squares);
  }
  return std::sqrt(least / static_cast<double>(here.size()));
}

}  // namespace gaitsmith
