// SPDX-License-Identifier: MIT
#include "core/gait/cycle_ends.h"

#include <algorithm>
#include <cmath>

#include "core/numeric/scalar_math.h"

namespace gaitsmith {

namespace {

/// A foot that slides is seen more easily than a limb that is moved.
constexpr double kSlideWeight = 2.0;
/// A jump of velocity counts as the way that it makes in this time [s].
constexpr double kJumpS = 0.02;

}  // namespace

CycleEnds::CycleEnds(const Motion& motion, const LimbPairs& pairs)
    : motion_(motion), pairs_(pairs), length_m_(static_cast<double>(motion.Bones().longest_rod_m)) {
  points_.reserve(static_cast<std::size_t>(motion.Frames()));
  for (int frame = 0; frame < motion.Frames(); ++frame) {
    const Motion::Frame& at = motion.At(frame);
    std::vector<WorldPoint>& points = points_.emplace_back();
    points.reserve(static_cast<std::size_t>(motion.Connections().contacts));
    for (int k = 0; k < motion.Connections().contacts; ++k) {
      const Motion::Point point = motion.Endpoint(frame, k);
      points.push_back({at.x_m + static_cast<double>(point.x), static_cast<double>(at.y_m + point.y)});
    }
  }
}

std::vector<WorldPoint> CycleEnds::PointsAt(double frame) const {
  const int whole = static_cast<int>(std::floor(frame));
  if (frame == whole) return Points(whole);
  return EndpointsOf(motion_.Bones(), PostureBetween(motion_, frame));
}

int CycleEnds::Turns(int first, double second) const {
  const double turned = PostureBetween(motion_, second).direction_rad - motion_.At(first).turn_rad;
  return static_cast<int>(std::lround(turned / (2.0 * kPi)));
}

CycleEnds::Fit CycleEnds::At(int first, double second) const {
  const std::vector<WorldPoint> later = PointsAt(second);
  const double came_m = PostureBetween(motion_, second).x_m - motion_.At(first).x_m;
  const int nearest = static_cast<int>(std::lround(second));
  Fit fit{.distance_m = came_m};
  double ways_m = 0.0;
  std::vector<double> way_m, rise_m;
  for (std::size_t k = 0; k < later.size(); ++k) {
    const auto partner = static_cast<std::size_t>(pairs_.endpoint[k]);
    const WorldPoint before = Points(first)[partner];
    const double along = later[k].x_m - before.x_m, up = later[k].y_m - before.y_m;
    fit.gap = std::max(fit.gap, WorldPoint{along - came_m, up}.Length() / length_m_);
    const bool bears = motion_.Force(first, static_cast<int>(partner)).y > 0.0f &&
                       motion_.Force(nearest, static_cast<int>(k)).y > 0.0f;
    if (!bears) continue;
    ways_m += along;
    way_m.push_back(along);
    rise_m.push_back(up);
  }
  if (!way_m.empty()) fit.distance_m = ways_m / static_cast<double>(way_m.size());
  for (std::size_t i = 0; i < way_m.size(); ++i)
    fit.slide = std::max(fit.slide, WorldPoint{way_m[i] - fit.distance_m, rise_m[i]}.Length() / length_m_);
  return fit;
}

double CycleEnds::Misfit(int first, double second) const {
  const Fit fit = At(first, second);
  const std::vector<WorldPoint> later = PointsAt(second), before = PointsAt(second - 1.0);
  double jump = 0.0;
  for (std::size_t k = 0; k < later.size(); ++k) {
    const auto partner = static_cast<std::size_t>(pairs_.endpoint[k]);
    const WorldPoint now = Points(first)[partner], was = Points(first - 1)[partner];
    jump = std::max(jump, WorldPoint{later[k].x_m - before[k].x_m - now.x_m + was.x_m,
                                     later[k].y_m - before[k].y_m - now.y_m + was.y_m}
                              .Length());
  }
  return fit.gap + kSlideWeight * fit.slide +
         jump * kJumpS / static_cast<double>(motion_.StepS()) / length_m_;
}

}  // namespace gaitsmith
