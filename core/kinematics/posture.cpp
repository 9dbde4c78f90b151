// SPDX-License-Identifier: MIT
#include "core/kinematics/posture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/numeric/scalar_math.h"

namespace gaitsmith {

Posture PostureAt(const Motion& motion, int frame) {
  const Motion::Frame& at = motion.At(frame);
  Posture posture{.x_m = at.x_m,
                  .y_m = static_cast<double>(at.y_m),
                  .direction_rad = at.turn_rad,
                  .angle_rad = {},
                  .nodes = {}};
  if (motion.Bones().rods == 0) {
    posture.nodes.reserve(static_cast<std::size_t>(motion.Connections().contacts));
    for (int node = 0; node < motion.Connections().contacts; ++node) {
      const Motion::Point point = motion.Endpoint(frame, node);
      posture.nodes.push_back({static_cast<double>(point.x), static_cast<double>(point.y)});
    }
  }
  posture.angle_rad.reserve(static_cast<std::size_t>(motion.Bones().joints));
  for (int joint = 0; joint < motion.Bones().joints; ++joint)
    posture.angle_rad.push_back(static_cast<double>(motion.AngleRad(frame, joint)));
  return posture;
}

Posture PostureBetween(const Motion& motion, double frame) {
  const int last = motion.Frames() - 1;
  const int before = std::clamp(static_cast<int>(std::floor(frame)), 0, last);
  const double share = frame - before;
  Posture mean = PostureAt(motion, before);
  if (share == 0.0) return mean;
  const std::array<Posture, 4> near = {PostureAt(motion, std::max(before - 1, 0)), mean,
                                       PostureAt(motion, std::min(before + 1, last)),
                                       PostureAt(motion, std::min(before + 2, last))};
  const double square = share * share, cube = square * share;
  const std::array<double, 4> weight = {-0.5 * cube + square - 0.5 * share, 1.5 * cube - 2.5 * square + 1.0,
                                        -1.5 * cube + 2.0 * square + 0.5 * share, 0.5 * cube - 0.5 * square};
  const auto mix = [&](const auto& number_of) {
    double sum = 0.0;
    for (std::size_t i = 0; i < near.size(); ++i) sum += weight[i] * number_of(near[i]);
    return sum;
  };
  mean.x_m = mix([](const Posture& one) { return one.x_m; });
  mean.y_m = mix([](const Posture& one) { return one.y_m; });
  mean.direction_rad = mix([](const Posture& one) { return one.direction_rad; });
  for (std::size_t joint = 0; joint < mean.angle_rad.size(); ++joint)
    mean.angle_rad[joint] = mix([&](const Posture& one) { return one.angle_rad[joint]; });
  for (std::size_t node = 0; node < mean.nodes.size(); ++node) {
    mean.nodes[node] = {mix([&](const Posture& one) { return one.nodes[node].x_m; }),
                        mix([&](const Posture& one) { return one.nodes[node].y_m; })};
  }
  return mean;
}

std::vector<double> DirectionsOf(const Skeleton& bones, const Posture& posture) {
  std::vector<double> directions = {posture.direction_rad};
  directions.reserve(static_cast<std::size_t>(bones.rods));
  for (std::size_t rod = 1; rod < static_cast<std::size_t>(bones.rods); ++rod) {
    const Skeleton::Limb& limb = bones.limbs[rod];
    directions.push_back(directions[static_cast<std::size_t>(limb.parent)] +
                         static_cast<double>(limb.rest_rad) + posture.angle_rad[rod - 1]);
  }
  return directions;
}

std::vector<WorldPoint> EndpointsOf(const Skeleton& bones, const Posture& posture) {
  if (bones.rods == 0) {
    std::vector<WorldPoint> places = posture.nodes;
    for (WorldPoint& place : places) place = {posture.x_m + place.x_m, posture.y_m + place.y_m};
    return places;
  }
  const std::vector<double> directions = DirectionsOf(bones, posture);
  std::vector<WorldPoint> points = {{0.0, 0.0}};
  points.reserve(static_cast<std::size_t>(bones.endpoints));
  double weighted_x = 0.0, weighted_y = 0.0;
  for (std::size_t rod = 0; rod < static_cast<std::size_t>(bones.rods); ++rod) {
    const Skeleton::Limb& limb = bones.limbs[rod];
    const auto length = static_cast<double>(limb.length_m), mass = static_cast<double>(limb.mass_kg);
    const FineSineCosine along = FineSinCos(directions[rod]);
    const WorldPoint start = points[static_cast<std::size_t>(limb.start)];
    const WorldPoint end = {start.x_m + length * along.cosine, start.y_m + length * along.sine};
    weighted_x += mass * 0.5 * (start.x_m + end.x_m);
    weighted_y += mass * 0.5 * (start.y_m + end.y_m);
    points.push_back(end);
  }
  const auto mass = static_cast<double>(bones.mass_kg);
  for (WorldPoint& point : points) {
    point.x_m += posture.x_m - weighted_x / mass;
    point.y_m += posture.y_m - weighted_y / mass;
  }
  return points;
}

}  // namespace gaitsmith
