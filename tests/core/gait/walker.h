// SPDX-License-Identifier: MIT
// A motion whose cycle is known: a biped whose joints follow sine curves, its legs half a period apart.
#pragma once

#include <cmath>

#include "core/kinematics/kinematic_recorder.h"
#include "core/kinematics/limb_pairs.h"
#include "core/numeric/scalar_math.h"
#include "tests/scene.h"

namespace gaitsmith::test {

struct Walker {
  double period_frames = 80.0;
  double speed_mps = 1.5;
  double swing_rad = 0.4;
  double growth = 0.0;           // by which the swing grows in each frame
  double limp = 0.0;             // by how much more the second leg swings
  double turns_per_cycle = 0.0;  // of the whole figure
};

inline Motion Walk(const Walker& walker, int frames) {
  const Figure figure = ShippedFigure("beryl-biped");
  const Skeleton bones(figure);
  const LimbPairs pairs = LimbPairsOf(bones);
  std::vector<KinematicFrame> all;
  for (int i = 0; i < frames; ++i) {
    const double phase = 2.0 * kPi * i / walker.period_frames;
    KinematicFrame frame{
        .posture = {.x_m = walker.speed_mps * i * 0.01,
                    .y_m = 1.0 + 0.05 * std::cos(2.0 * phase),
                    .direction_rad =
                        static_cast<double>(bones.start_angle_rad) + walker.turns_per_cycle * phase,
                    .angle_rad = {}},
        .forces = std::vector<Motion::Point>(figure.rods.size() + 1, Motion::Point{0.0f, 0.0f})};
    for (int rod = 1; rod < bones.rods; ++rod) {
      const int partner = pairs.rod[static_cast<std::size_t>(rod)];
      const bool second = partner < rod;
      const double swing = walker.swing_rad * (1.0 + walker.growth * i) * (second ? 1.0 + walker.limp : 1.0);
      // From the same direction, whichever way the two are drawn.
      const double rest =
          static_cast<double>(bones.limbs[static_cast<std::size_t>(second ? partner : rod)].rest_rad);
      const double own = static_cast<double>(bones.limbs[static_cast<std::size_t>(rod)].rest_rad);
      const double angle =
          rest - own + swing * std::sin(phase + (second ? kPi : 0.0) + 0.3 * (second ? partner : rod));
      frame.posture.angle_rad.push_back(angle);
      const bool bears = partner != rod && std::sin(phase + (second ? kPi : 0.0)) > 0.0;
      frame.forces[static_cast<std::size_t>(rod) + 1].y = bears ? 100.0f : 0.0f;
    }
    all.push_back(std::move(frame));
  }
  return RecordKinematic({.figure = figure,
                          .environment = {},
                          .start = {},
                          .pushes = {},
                          .controllers = {},
                          .clips = {},
                          .steps = 0},
                         all);
}

}  // namespace gaitsmith::test
