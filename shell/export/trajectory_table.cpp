// SPDX-License-Identifier: MIT
#include "shell/export/trajectory_table.h"

#include <utility>

namespace gaitsmith::shell {

namespace {

constexpr int kDigits = 9;
constexpr int kPositionDigits = 17;

/// The active rule, or a trajectory's nearest knot, counted from 1; the number of hidden nodes that fire.
int RuleColumn(const Document& document, const Motion::Frame& frame) {
  if (frame.clip < 0) return 0;
  const auto& clip = document.timeline[static_cast<std::size_t>(frame.clip)];
  const Controller& controller = document.controllers[static_cast<std::size_t>(clip.controller)];
  return controller.kind == ControllerKind::kNetwork ? frame.rule : frame.rule + 1;
}

}  // namespace

std::vector<TrajectoryColumn> TrajectoryTable(const Document& document, const Motion& motion) {
  std::vector<TrajectoryColumn> table;
  const auto add = [&](std::string name, int digits, auto value_at) {
    table.push_back({.name = std::move(name), .digits = digits, .values = {}});
    std::vector<double>& values = table.back().values;
    values.reserve(static_cast<std::size_t>(motion.Frames()));
    for (int i = 0; i < motion.Frames(); ++i) values.push_back(static_cast<double>(value_at(i)));
  };
  add("t", kDigits, [](int i) { return i * 0.01; });
  add("x", kPositionDigits, [&](int i) { return motion.At(i).x_m; });
  add("y", kPositionDigits, [&](int i) { return motion.At(i).y_m; });
  add("vx", kDigits, [&](int i) { return motion.At(i).velocity_x_mps; });
  add("vy", kDigits, [&](int i) { return motion.At(i).velocity_y_mps; });
  add("phi", kDigits, [&](int i) { return motion.At(i).turn_rad; });
  add("L", kDigits, [&](int i) { return motion.At(i).angular_momentum; });
  add("rule", kDigits, [&](int i) { return RuleColumn(document, motion.At(i)); });
  const int actuators = motion.Connections().Actuators(), contacts = motion.Connections().contacts;
  const std::string position = motion.Connections().muscles ? "length_" : "theta_";
  for (int j = 0; j < actuators; ++j)
    add(position + std::to_string(j + 1), kDigits, [&, j](int i) { return motion.AngleRad(i, j); });
  for (int k = 0; k < contacts; ++k) {
    const std::string node = "node" + std::to_string(k);
    add(node + "_x", kPositionDigits,
        [&](int i) { return motion.At(i).x_m + static_cast<double>(motion.Endpoint(i, k).x); });
    add(node + "_y", kPositionDigits, [&](int i) {
      return static_cast<double>(motion.At(i).y_m) + static_cast<double>(motion.Endpoint(i, k).y);
    });
  }
  for (int k = 0; k < contacts; ++k) {
    add("fn" + std::to_string(k), kDigits, [&](int i) { return motion.Force(i, k).y; });
    add("ft" + std::to_string(k), kDigits, [&](int i) { return motion.Force(i, k).x; });
  }
  return table;
}

}  // namespace gaitsmith::shell
