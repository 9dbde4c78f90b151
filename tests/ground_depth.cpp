// SPDX-License-Identifier: MIT
#include "tests/ground_depth.h"

#include <algorithm>
#include <cmath>

namespace gaitsmith::test {

namespace {

double DepthOfPoint(const Terrain& terrain, double x, double y) {
  const double below = terrain.HeightAt(x) - y;
  if (below <= 0.0) return 0.0;
  double depth = below;
  for (const Terrain::Face& face : terrain.FacesBetween(x - below, x + below)) {
    const double along = std::clamp(face.Along(x, y), 0.0, face.length);
    depth = std::min(depth, std::hypot(face.x + along * face.ux - x, face.y + along * face.uy - y));
  }
  return depth;
}

}  // namespace

double DepthOfRod(const Terrain& terrain, double ax, double ay, double bx, double by) {
  double deepest = 0.0;
  for (int i = 0; i <= 100; ++i) {
    const double part = 0.01 * i;
    deepest = std::max(deepest, DepthOfPoint(terrain, ax + part * (bx - ax), ay + part * (by - ay)));
  }
  return deepest;
}

double DepthOf(const Terrain& terrain, const Motion& motion, int frame) {
  const Motion::Frame& f = motion.At(frame);
  const Skeleton& bones = motion.Bones();
  double deepest = 0.0;
  if (motion.Connections().muscles) {
    for (int node = 0; node < motion.Connections().contacts; ++node) {
      const Motion::Point at = motion.Endpoint(frame, node);
      deepest = std::max(deepest, DepthOfPoint(terrain, f.x_m + static_cast<double>(at.x),
                                               static_cast<double>(f.y_m) + static_cast<double>(at.y)));
    }
    return deepest;
  }
  for (int limb = 0; limb < bones.rods; ++limb) {
    const Motion::Point a = motion.Endpoint(frame, bones.limbs[static_cast<std::size_t>(limb)].start);
    const Motion::Point b = motion.Endpoint(frame, limb + 1);
    const double y = static_cast<double>(f.y_m);
    deepest =
        std::max(deepest, DepthOfRod(terrain, f.x_m + static_cast<double>(a.x), y + static_cast<double>(a.y),
                                     f.x_m + static_cast<double>(b.x), y + static_cast<double>(b.y)));
  }
  return deepest;
}

}  // namespace gaitsmith::test
