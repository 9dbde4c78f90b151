// SPDX-License-Identifier: MIT
#include "core/document/transition.h"

#include <algorithm>
#include <cmath>

#include "core/document/parts.h"
#include "core/document/timeline_edit.h"

namespace gaitsmith {

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
