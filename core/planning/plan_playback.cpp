// SPDX-License-Identifier: MIT
#include "core/planning/plan_playback.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/document/recording.h"

namespace gaitsmith {

namespace {

constexpr int kMostCorrections = 16;
/// A miss that is as good as none [m].
constexpr double kCloseM = 0.002;
/// A little less than the whole miss, so that corrections do not swing around the mark.
constexpr double kShare = 0.9;

std::vector<float> AnglesOf(const PlannedMotion& planned) {
  std::vector<float> angles;
  for (int frame = 0; frame <= planned.Scene().plan.steps; ++frame) {
    for (const double angle : planned.At(frame * static_cast<double>(kStep)).angle_rad)
      angles.push_back(static_cast<float>(angle));
  }
  return angles;
}

/// A trajectory after a planned motion, and where it gets.
struct Played {
  Document document;
  std::vector<PlannedMotion::Vector> misses;  // of every place of every keyframe [m]
  double worst_m = 0.0;
};

Played Play(const Document& document, const PlannedMotion& planned) {
  CurveFit fit;
  Played played{WithTrajectory(document, "planned", AnglesOf(planned), kMaxRules, fit), {}};
  Document shown = played.document;
  shown.duration_steps = std::max(document.duration_steps, document.plan.steps);
  const Motion motion = Simulate(shown);
  for (const Keyframe& keyframe : document.plan.keyframes) {
    const Motion::Frame& frame = motion.At(keyframe.step);
    for (const Mark& mark : keyframe.marks) {
      double x = frame.x_m, y = static_cast<double>(frame.y_m);
      if (mark.endpoint != kCentreOfMass) {
        const Motion::Point arm = motion.Endpoint(keyframe.step, mark.endpoint);
        x += static_cast<double>(arm.x);
        y += static_cast<double>(arm.y);
      }
      PlannedMotion::Vector& miss = played.misses.emplace_back(0.0, 0.0);
      if (mark.axes != MarkAxes::kUp) miss.x = x - static_cast<double>(mark.x_m);
      if (mark.axes != MarkAxes::kAlong) miss.y = y - static_cast<double>(mark.y_m);
      played.worst_m = std::max(played.worst_m, std::sqrt(miss.x * miss.x + miss.y * miss.y));
    }
  }
  return played;
}

}  // namespace

PlanPlayback PlayPlan(const Document& document, const PlannedMotion& planned, const PlanWatch& watch) {
  Played best = Play(document, planned);
  PlanPlayback playback{.document = best.document, .miss_m = best.worst_m, .first_m = best.worst_m};
  Plan nearest = document.plan;  // whose motion is played best
  std::vector<PlannedMotion::Vector> misses = best.misses;
  double share = kShare;
  std::optional<PlannedMotion> from;
  for (int i = 0; i < kMostCorrections && playback.miss_m > kCloseM; ++i) {
    PlanScene scene = planned.Scene();
    scene.plan = nearest;
    std::size_t at = 0;
    for (Keyframe& keyframe : scene.plan.keyframes) {
      for (Mark& mark : keyframe.marks) {
        mark.x_m -= static_cast<float>(share * misses[at].x);
        mark.y_m -= static_cast<float>(share * misses[at].y);
        ++at;
      }
    }
    PlanAnswer answer = SolvePlan(scene, planned.Grid(), from ? &*from : &planned, watch);
    if (answer.cancelled) break;
    Played played = answer.motion ? Play(document, *answer.motion) : Played{};
    if (!answer.motion || played.worst_m >= playback.miss_m) {
      share *= 0.5;  // too far
      continue;
    }
    share = kShare;
    nearest = scene.plan;
    misses = played.misses;
    from = std::move(answer.motion);
    playback.document = std::move(played.document);
    playback.miss_m = played.worst_m;
    playback.corrections = i + 1;
  }
  playback.document = WithSolution(playback.document, planned);
  return playback;
}

Document WithSolution(const Document& document, const PlannedMotion& planned) {
  Document solved = document;
  solved.plan.solved = {planned.Grid().degree, planned.Grid().pieces_per_second, {}};
  for (const double value : planned.Unknowns())
    solved.plan.solved.unknowns.push_back(static_cast<float>(value));
  return solved;
}

PlannedMotion SolvedMotion(const Document& document) {
  const PlanSolution& solved = document.plan.solved;
  const std::vector<double> unknowns(solved.unknowns.begin(), solved.unknowns.end());
  return {SceneOf(document), {solved.degree, solved.pieces_per_second}, unknowns};
}

}  // namespace gaitsmith
