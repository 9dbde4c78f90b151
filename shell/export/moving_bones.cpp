// SPDX-License-Identifier: MIT
// Bones and keys of a motion.
#include "shell/export/moving_bones.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace gaitsmith::shell {

namespace {

constexpr double kThicknessShare = 0.16;  // of the rods' mean length
constexpr double kSpringShare = 0.04;     // of the longest spring

}  // namespace

std::string MovingBones::NameOf(int bone) const { return "rod " + std::to_string(Limb(bone).drawn + 1); }

double MovingBones::JointM(int bone) const {
  const int parent = ParentOf(bone);
  return parent >= 0 && Limb(bone).start == parent + 1 ? LengthM(parent) : 0.0;
}

MovingBones::Place MovingBones::PlaceOf(int frame, int bone) const {
  const auto start = EndpointM(frame, Limb(bone).start), end = EndpointM(frame, bone + 1);
  const double x = end[0] - start[0], y = end[1] - start[1];
  const double length = std::sqrt(x * x + y * y);
  return {.start_m = start, .along = {x / length, y / length}};
}

std::array<double, 2> MovingBones::Start(int frame) const { return EndpointM(frame, 0); }

std::array<double, 2> MovingBones::EndpointM(int frame, int endpoint) const {
  const Motion::Frame& at = motion_.At(frame);
  const Motion::Point point = motion_.Endpoint(frame, endpoint);
  return {at.x_m + static_cast<double>(point.x), static_cast<double>(at.y_m) + static_cast<double>(point.y)};
}

double MovingBones::AngleRad(int frame, int bone) const {
  if (bone == 0) return motion_.At(frame).turn_rad;
  return static_cast<double>(Limb(bone).rest_rad) + static_cast<double>(motion_.AngleRad(frame, bone - 1));
}

double MovingBones::ThicknessM() const {
  if (Count() == 0) return kSpringShare * static_cast<double>(skeleton_.longest_rod_m);
  double length_m = 0.0;
  for (int bone = 0; bone < Count(); ++bone) length_m += LengthM(bone);
  return kThicknessShare * length_m / Count();
}

Track KeysOf(const std::vector<std::array<double, 2>>& values, double tolerance) {
  std::vector<bool> kept(values.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> spans{{0, values.size() - 1}};
  while (!spans.empty()) {
    const auto [first, last] = spans.back();
    spans.pop_back();
    std::size_t worst = first;
    double error = tolerance;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double share = static_cast<double>(i - first) / static_cast<double>(last - first);
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const double straight = values[first][axis] + share * (values[last][axis] - values[first][axis]);
        const double off =
            values[i][axis] > straight ? values[i][axis] - straight : straight - values[i][axis];
        if (off <= error) continue;
        error = off;
        worst = i;
      }
    }
    if (worst == first) continue;
    kept[worst] = true;
    spans.emplace_back(first, worst);
    spans.emplace_back(worst, last);
  }
  Track track;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!kept[i]) continue;
    track.frames.push_back(static_cast<int>(i));
    track.values.push_back(values[i]);
  }
  return track;
}

}  // namespace gaitsmith::shell
