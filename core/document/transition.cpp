// SPDX-License-Identifier: MIT
#include "core/document/transition.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/document/parts.h"
#include "core/document/timeline_edit.h"

namespace gaitsmith {

namespace {

/// The numbers by which two states are compared, and the size of a small difference of each.
class Features {
 public:
  explicit Features(const Motion& motion) : motion_(motion) {
    const auto joints = static_cast<std::size_t>(motion.Bones().joints);
    small_.insert(small_.end(), joints, 0.1f);               // angle [rad]
    small_.insert(small_.end(), joints, 0.5f);               // rate [rad/s]
    small_.insert(small_.end(), 2, 0.2f);                    // direction of the root
    small_.push_back(0.05f * motion.Bones().longest_rod_m);  // height [m]
    small_.insert(small_.end(), 2, 0.2f);                    // velocity [m/s]
  }
  [[nodiscard]] std::size_t Count() const { return small_.size(); }
  [[nodiscard]] float Small(std::size_t feature) const { return small_[feature]; }
  void Of(const Motion& motion, int frame, std::vector<float>& values) const {
    values.clear();
    const int joints = motion_.Bones().joints;
    for (int j = 0; j < joints; ++j) values.push_back(motion.AngleRad(frame, j));
    for (int j = 0; j < joints; ++j) values.push_back(motion.RateRadps(frame, j));
    const Motion::Frame& f = motion.At(frame);
    const double turn = f.turn_rad - 2.0 * kPi * std::floor(f.turn_rad / (2.0 * kPi));
    const SineCosine direction = SinCos(static_cast<float>(turn));
    values.insert(values.end(),
                  {direction.sine, direction.cosine, f.y_m, f.velocity_x_mps, f.velocity_y_mps});
  }

 private:
  const Motion& motion_;
  std::vector<float> small_;
};

}  // namespace

Nearness NearnessOf(const Motion& motion, int frame, const Motion& usual) {
  const Features features(usual);
  const std::size_t count = features.Count();
  std::vector<float> here, there;
  features.Of(motion, frame, here);
  // The standard deviation of each number in the usual motion.
  std::vector<double> mean(count, 0.0), square(count, 0.0);
  for (int at = 0; at < usual.Frames(); ++at) {
    features.Of(usual, at, there);
    for (std::size_t i = 0; i < count; ++i) {
      const auto value = static_cast<double>(there[i]);
      mean[i] += value / usual.Frames();
      square[i] += value * value / usual.Frames();
    }
  }
  std::vector<float> scale(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double variance = std::max(0.0, square[i] - mean[i] * mean[i]);
    scale[i] = 1.0f / std::max(features.Small(i), static_cast<float>(std::sqrt(variance)));
  }
  Nearness nearest{.distance = std::numeric_limits<float>::infinity()};
  for (int at = 0; at < usual.Frames(); ++at) {
    features.Of(usual, at, there);
    float sum = 0.0f;
    for (std::size_t i = 0; i < count; ++i) {
      const float off = (here[i] - there[i]) * scale[i];
      sum += off * off;
    }
    const float distance = std::sqrt(sum / static_cast<float>(count));
    if (distance < nearest.distance) nearest = {distance, at};
  }
  return nearest;
}

Motion UsualMotion(const Document& d, int controller) {
  const Clip whole{.controller = controller, .start_step = 0};
  Script script = ScriptOf(d);
  script.pushes = {};
  script.clips = std::span(&whole, 1);
  script.steps = d.task.duration_steps;
  return Motion(script);
}

std::vector<int> TransitionSteps(const Document& d, int clip) {
  std::vector<int> steps;
  if (clip < 1 || clip >= static_cast<int>(d.timeline.size())) return steps;
  const auto i = static_cast<std::size_t>(clip);
  const int low = d.timeline[i - 1].start_step + kShortestClip;
  const int high = EndOf(d, i) - kShortestClip;
  const int first = (low + kMomentSpacing - 1) / kMomentSpacing * kMomentSpacing;
  for (int step = first; step <= high; step += kMomentSpacing) steps.push_back(step);
  return steps;
}

Document TransitionRequest(const Document& d, int clip) {
  const auto last = static_cast<std::size_t>(clip);
  const Controller& controller = d.controllers[static_cast<std::size_t>(d.timeline[last].controller)];
  Document request;
  CopyParts(d, {kScene, Part::kPushes, kTask, Part::kControllers}, request);
  request.task.duration_steps = std::min(d.task.duration_steps, kLongestWatch);
  request.senses = controller.senses;
  request.rules = controller.rules;
  request.kind = controller.kind;
  for (Controller& one : request.controllers) one.name.clear();
  request.timeline.assign(d.timeline.begin(), d.timeline.begin() + clip + 1);
  request.timeline[last].start_step = request.timeline[last - 1].start_step + kShortestClip;
  request.duration_steps = EndOf(d, last);
  request.search.in_place_of = clip;
  DropUnusedControllers(request);
  return request;
}

TransitionMap TransitionMapOf(const Document& request) {
  Problem problem = ProblemOf(request);
  problem.task.duration_steps = std::min(request.task.duration_steps, kLongestWatch);
  const auto clip = static_cast<std::size_t>(request.search.in_place_of);
  const int controller = request.timeline[clip].controller;
  const Controller& taking = request.controllers[static_cast<std::size_t>(controller)];
  problem.senses = taking.senses;
  problem.rules = taking.rules;
  problem.kind = taking.kind;
  const Motion usual = UsualMotion(request, controller);
  const double way_m = usual.At(usual.Frames() - 1).x_m - usual.At(0).x_m;
  TaskKind& kind = problem.task.kind;
  if (kind == TaskKind::kTravelRight && way_m < 0.0) {
    kind = TaskKind::kTravelLeft;
  } else if (kind == TaskKind::kTravelLeft && way_m > 0.0) {
    kind = TaskKind::kTravelRight;
  }
  return {problem, taking.genes, TransitionSteps(request, request.search.in_place_of)};
}

float ShareOfUsual(float score, float usual) {
  if (score <= kVoidScore) return kVoidScore;
  const float unit = std::abs(usual);
  if (usual <= kVoidScore || !(unit > 0.0f)) return score >= usual ? 1.0f : 0.0f;
  return 1.0f + (score - usual) / unit;
}

}  // namespace gaitsmith
