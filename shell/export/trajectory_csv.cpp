// SPDX-License-Identifier: MIT
// Columns and rows of a motion's CSV.
#include <cstdio>

#include "shell/export/exporters.h"

namespace gaitsmith::shell {

namespace {

constexpr int kDigits = 9;
constexpr int kPositionDigits = 17;

void Append(std::string& line, double value, int digits = kDigits) {
  char text[40];
  std::snprintf(text, sizeof text, "%s%.*g", line.empty() || line.back() == '\n' ? "" : ",", digits, value);
  line += text;
}

std::string Header(const Skeleton& bones) {
  std::string line = "t,x,y,vx,vy,phi,L,rule";
  for (int j = 1; j <= bones.joints; ++j) line += ",theta_" + std::to_string(j);
  for (int k = 0; k < bones.endpoints; ++k) {
    line += ",node" + std::to_string(k) + "_x,node" + std::to_string(k) + "_y";
  }
  for (int k = 0; k < bones.endpoints; ++k) line += ",fn" + std::to_string(k) + ",ft" + std::to_string(k);
  return line + "\n";
}

/// The active rule, or a trajectory's nearest knot, counted from 1; the number of hidden nodes that fire.
int RuleColumn(const Document& document, const Motion::Frame& frame) {
  if (frame.clip < 0) return 0;
  const auto& clip = document.timeline[static_cast<std::size_t>(frame.clip)];
  const Controller& controller = document.controllers[static_cast<std::size_t>(clip.controller)];
  return controller.kind == ControllerKind::kNetwork ? frame.rule : frame.rule + 1;
}

}  // namespace

std::string TrajectoryCsv(const Document& document, const Motion& motion) {
  const Skeleton& bones = motion.Bones();
  std::string csv = Header(bones);
  for (int i = 0; i < motion.Frames(); ++i) {
    const Motion::Frame& frame = motion.At(i);
    Append(csv, i * 0.01);
    Append(csv, frame.x_m, kPositionDigits);
    Append(csv, static_cast<double>(frame.y_m), kPositionDigits);
    Append(csv, static_cast<double>(frame.velocity_x_mps));
    Append(csv, static_cast<double>(frame.velocity_y_mps));
    Append(csv, frame.turn_rad);
    Append(csv, static_cast<double>(frame.angular_momentum));
    Append(csv, RuleColumn(document, frame));
    for (int j = 0; j < bones.joints; ++j) Append(csv, static_cast<double>(motion.AngleRad(i, j)));
    for (int k = 0; k < bones.endpoints; ++k) {
      const Motion::Point point = motion.Endpoint(i, k);
      Append(csv, frame.x_m + static_cast<double>(point.x), kPositionDigits);
      Append(csv, static_cast<double>(frame.y_m) + static_cast<double>(point.y), kPositionDigits);
    }
    for (int k = 0; k < bones.endpoints; ++k) {
      Append(csv, static_cast<double>(motion.Force(i, k).y));
      Append(csv, static_cast<double>(motion.Force(i, k).x));
    }
    csv += "\n";
  }
  return csv;
}

}  // namespace gaitsmith::shell
