// SPDX-License-Identifier: MIT
#include "core/document/recording.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/rollout/models.h"

namespace gaitsmith {

namespace {

/// The least that a document may have: joints must keep up with rules of any time constant.
constexpr float kTauS = 0.02f;
/// Of a curve that goes on beyond its clip.
constexpr int kFreeKnots = 4;

}  // namespace

Recording WithTrajectories(const Document& document, const std::string& name,
                           std::span<const float> angles_rad, int knots, int clips) {
  const PortCount ports = CountPorts(document.model, document.figure);
  const auto joints = static_cast<std::size_t>(ports.actuators);
  const int last = static_cast<int>(angles_rad.size() / joints) - 1;
  const Skeleton skeleton(document.figure);
  // What the next search makes stays as it is, but nothing may refer to the controllers that go.
  Recording recording{.document = document};
  Document& followed = recording.document;
  followed.search.start = followed.search.in_place_of = -1;
  followed.search.handovers.clear();
  followed.lineage = {};
  followed.controllers.clear();
  followed.timeline.clear();
  followed.hash = {};
  double squares = 0.0;
  CurveFit fit;
  for (int clip = 0; clip < clips; ++clip) {
    const int first = last * clip / clips, end = last * (clip + 1) / clips;
    SenseSpec senses = document.senses;
    senses.kind = SenseKind::kTimer;
    senses.period_steps = std::max(2, end - first);
    senses.tau_min_s = kTauS;
    senses.tau_max_s = std::max(kTauS, senses.tau_max_s);
    senses.at_end = CurveEnd::kRest;
    if (clip + 1 < clips) {
      // A curve that rests begins and ends without speed. One that repeats may end before it meets its
      // beginning.
      senses.at_end = CurveEnd::kRepeat;
      senses.period_steps = (end - first) * knots / (knots - kFreeKnots) + 1;
    }
    const auto part = angles_rad.subspan(static_cast<std::size_t>(first) * joints,
                                         static_cast<std::size_t>(end - first + 1) * joints);
    fit = FitCurves(part, skeleton, CurveShape(knots, ports), senses, fit.end);
    recording.worst_rad = std::max(recording.worst_rad, fit.worst_rad);
    squares += fit.typical_rad * fit.typical_rad / clips;
    const std::string numbered = clips == 1 ? name : name + " " + std::to_string(clip + 1);
    followed.controllers.push_back({numbered, ControllerKind::kTrajectory, senses, knots, fit.genes});
    followed.timeline.push_back({.controller = clip, .start_step = first});
  }
  recording.typical_rad = std::sqrt(squares);
  return recording;
}

Result<Recording> RecordAsCurves(const Document& document, int knots) {
  if (document.timeline.empty())
    return Fail(ErrorCode::kMissing, "timeline", "has no controller whose motion could be recorded");
  if (document.figure.HasSprings())
    return Fail(ErrorCode::kStructure, "figure", "has springs: only angles of joints are recorded as curves");
  if (CountPorts(document.model, document.figure).actuators == 0)
    return Fail(ErrorCode::kMissing, "figure", "has no joint whose angle could be recorded");
  const Motion motion = Simulate(document);
  return WithTrajectories(document, "recorded", motion.AnglesRad(), knots, 1);
}

}  // namespace gaitsmith
