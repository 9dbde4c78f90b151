// SPDX-License-Identifier: MIT
#include "core/gait/closed_loop.h"

#include <algorithm>
#include <cmath>

#include "core/gait/cycle_ends.h"
#include "core/numeric/scalar_math.h"

namespace gaitsmith {

namespace {

/// Part of the cycle that is blended, and the most steps of it.
constexpr double kBlended = 0.25;
constexpr int kMostBlended = 20;

/// From 0 to 1, without a jump of slope.
double Eased(double share) { return share * share * (3.0 - 2.0 * share); }

/// A posture less a share of another.
Posture Without(Posture one, const Posture& excess, double share) {
  one.x_m -= share * excess.x_m;
  one.y_m -= share * excess.y_m;
  one.direction_rad -= share * excess.direction_rad;
  for (std::size_t j = 0; j < one.angle_rad.size(); ++j) one.angle_rad[j] -= share * excess.angle_rad[j];
  for (std::size_t k = 0; k < one.nodes.size(); ++k) {
    one.nodes[k].x_m -= share * excess.nodes[k].x_m;
    one.nodes[k].y_m -= share * excess.nodes[k].y_m;
  }
  return one;
}

Posture MovedOn(Posture posture, double distance_m, int turns) {
  posture.x_m += distance_m;
  posture.direction_rad += 2.0 * kPi * turns;
  return posture;
}

KinematicFrame FrameAt(const Motion& motion, double frame) {
  const int source = static_cast<int>(std::lround(frame));
  KinematicFrame at{.posture = PostureBetween(motion, frame),
                    .forces = {},
                    .clip = motion.At(source).clip,
                    .rule = motion.At(source).rule};
  at.forces.reserve(static_cast<std::size_t>(motion.Connections().contacts));
  for (int k = 0; k < motion.Connections().contacts; ++k) at.forces.push_back(motion.Force(source, k));
  return at;
}

double Farthest(const std::vector<WorldPoint>& one, const std::vector<WorldPoint>& other, double along_m) {
  double farthest = 0.0;
  for (std::size_t k = 0; k < one.size(); ++k)
    farthest = std::max(farthest,
                        WorldPoint{one[k].x_m - other[k].x_m - along_m, one[k].y_m - other[k].y_m}.Length());
  return farthest;
}

/// The other half: the first with limbs exchanged.
void AddHalf(const Skeleton& bones, const LimbPairs& pairs, ClosedLoop& loop) {
  const std::size_t half = loop.frames.size();
  loop.frames.reserve(2 * half - 1);
  for (std::size_t i = 1; i < half; ++i) {
    KinematicFrame other = loop.frames[i];
    other.posture = MovedOn(Exchanged(bones, pairs, other.posture), loop.distance_m, loop.turns);
    for (std::size_t k = 0; k < other.forces.size(); ++k)
      other.forces[k] = loop.frames[i].forces[static_cast<std::size_t>(pairs.endpoint[k])];
    loop.frames.push_back(other);
  }
  loop.distance_m *= 2.0;
  loop.turns *= 2;
}

}  // namespace

ClosedLoop CloseLoop(const Motion& motion, const GaitCycle& cycle) {
  const Skeleton& bones = motion.Bones();
  const LimbPairs pairs = cycle.half ? LimbPairsOf(bones) : LimbPairs();
  const double end = cycle.first + cycle.frames;
  ClosedLoop loop{.cycle = cycle,
                  .frames = {},
                  .distance_m = CycleEnds(motion, pairs).DistanceM(cycle.first, end),
                  .turns = cycle.turns};
  const Posture begins = PostureAt(motion, cycle.first);
  const Posture ends = MovedOn(Exchanged(bones, pairs, begins), loop.distance_m, loop.turns);
  const Posture excess = Without(PostureBetween(motion, end), ends, 1.0);

  const int steps = std::max(2, static_cast<int>(std::lround(cycle.frames)));
  const int blended = std::clamp(static_cast<int>(kBlended * steps), 1, kMostBlended);
  const auto length_m = static_cast<double>(bones.longest_rod_m);
  loop.frames.reserve(static_cast<std::size_t>(steps) + 1);
  // By how much each standing foot has been moved when it came to stand.
  std::vector<WorldPoint> since(static_cast<std::size_t>(motion.Connections().contacts));
  std::vector<bool> stood(static_cast<std::size_t>(motion.Connections().contacts), false);
  for (int step = 0; step <= steps; ++step) {
    KinematicFrame frame = FrameAt(motion, cycle.first + cycle.frames * step / steps);
    const std::vector<WorldPoint> recorded = EndpointsOf(bones, frame.posture);
    const double share = Eased(std::clamp((step - steps + blended) / static_cast<double>(blended), 0.0, 1.0));
    frame.posture = step == steps ? ends : Without(frame.posture, excess, share);
    const std::vector<WorldPoint> closed = EndpointsOf(bones, frame.posture);
    for (std::size_t k = 0; k < closed.size(); ++k) {
      const WorldPoint moved = {closed[k].x_m - recorded[k].x_m, closed[k].y_m - recorded[k].y_m};
      const bool stands = frame.forces[k].y > 0.0f;
      if (stands && !stood[k]) since[k] = moved;
      stood[k] = stands;
      if (!stands) continue;
      loop.slide_rods =
          std::max(loop.slide_rods,
                   WorldPoint{moved.x_m - since[k].x_m, moved.y_m - since[k].y_m}.Length() / length_m);
    }
    loop.frames.push_back(frame);
  }
  if (cycle.half) AddHalf(bones, pairs, loop);
  loop.seam_rods = Farthest(EndpointsOf(bones, loop.frames.back().posture),
                            EndpointsOf(bones, loop.frames.front().posture), loop.distance_m) /
                   length_m;
  return loop;
}

}  // namespace gaitsmith
