// SPDX-License-Identifier: MIT
#include "shell/body/figure_pose.h"

#include <array>

#include "core/physics/pose.h"

namespace gaitsmith::shell {

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

}  // namespace gaitsmith::shell
