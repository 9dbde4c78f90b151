// SPDX-License-Identifier: MIT
#include "shell/body/figure_pose.h"

#include <array>

#include "core/physics/pose.h"
#include "core/springs/lattice.h"

namespace gaitsmith::shell {

std::vector<Bar> BarsOf(const Skeleton& skeleton) {
  std::vector<Bar> bars;
  bars.reserve(static_cast<std::size_t>(skeleton.rods));
  for (int rod = 0; rod < skeleton.rods; ++rod)
    bars.push_back({skeleton.limbs[static_cast<std::size_t>(rod)].start, rod + 1});
  return bars;
}

std::vector<Bar> BarsOf(const Figure& figure) {
  if (!figure.HasSprings()) return BarsOf(Skeleton(figure));
  std::vector<Bar> bars;
  bars.reserve(figure.springs.size());
  for (const Spring& spring : figure.springs) bars.push_back({spring.from, spring.to});
  return bars;
}

std::vector<Bar> ActuatorBarsOf(const Figure& figure) {
  std::vector<Bar> bars = BarsOf(figure);
  std::vector<Bar> moved;
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const bool moves = figure.HasSprings() ? figure.springs[i].IsMuscle() : i > 0;
    if (moves) moved.push_back(bars[i]);
  }
  return moved;
}

std::vector<BodyPoint> DrawnEndpoints(const Skeleton& skeleton, std::span<const float> angle_rad) {
  std::array<Lane<1>::F, kMaxJoints> angles{};
  for (std::size_t joint = 0; joint < angle_rad.size(); ++joint)
    angles[joint] = Lane<1>::Splat(angle_rad[joint]);
  Pose<1> pose;
  PoseFigure<1>(skeleton, angles, pose);
  // PoseFigure lays the root rod along x. Rotate the figure back to its drawn direction.
  const SineCosine turn = SinCos(skeleton.start_angle_rad);
  std::vector<BodyPoint> points;
  for (std::size_t k = 0; k < static_cast<std::size_t>(skeleton.endpoints); ++k) {
    const float x = pose.endpoint_x[k][0];
    const float y = pose.endpoint_y[k][0];
    points.push_back({x * turn.cosine - y * turn.sine, x * turn.sine + y * turn.cosine});
  }
  return points;
}

std::vector<BodyPoint> DrawnEndpoints(const Figure& figure) {
  if (!figure.HasSprings()) return DrawnEndpoints(Skeleton(figure), {});
  const Lattice lattice(figure);
  std::vector<BodyPoint> points;
  points.reserve(lattice.nodes);
  for (std::size_t node = 0; node < lattice.nodes; ++node)
    points.push_back({lattice.drawn_x[node], lattice.drawn_y[node]});
  return points;
}

}  // namespace gaitsmith::shell
