// SPDX-License-Identifier: MIT
#include "core/document/recording.h"

#include <algorithm>
#include <utility>

#include "core/rollout/models.h"

namespace gaitsmith {

namespace {

/// The least that a document may have: joints must keep up with rules of any time constant.
constexpr float kTauS = 0.02f;

}  // namespace

Document WithTrajectory(const Document& document, std::string name, std::span<const float> angles_rad,
                        int knots, CurveFit& fit) {
  SenseSpec senses = document.senses;
  const PortCount ports = CountPorts(document.model, document.figure);
  const int frames = static_cast<int>(angles_rad.size()) / ports.actuators;
  senses.kind = SenseKind::kTimer;
  senses.period_steps = std::max(2, frames - 1);
  senses.tau_min_s = kTauS;
  senses.tau_max_s = std::max(kTauS, senses.tau_max_s);
  senses.at_end = CurveEnd::kRest;
  fit = FitCurves(angles_rad, Skeleton(document.figure), CurveShape(knots, ports), senses);
  // What the next search makes stays as it is, but nothing may refer to the controllers that go.
  Document followed = document;
  followed.search.start = followed.search.in_place_of = -1;
  followed.search.handovers.clear();
  followed.lineage = {};
  followed.controllers = {{std::move(name), ControllerKind::kTrajectory, senses, knots, fit.genes}};
  followed.timeline = {{.controller = 0, .start_step = 0}};
  followed.hash = {};
  return followed;
}

Result<Recording> RecordAsCurves(const Document& document, int knots) {
  if (document.timeline.empty())
    return Fail(ErrorCode::kMissing, "timeline", "has no controller whose motion could be recorded");
  if (CountPorts(document.model, document.figure).actuators == 0)
    return Fail(ErrorCode::kMissing, "figure", "has no joint whose angle could be recorded");
  const Motion motion = Simulate(document);
  CurveFit fit;
  Document recorded = WithTrajectory(document, "recorded", motion.AnglesRad(), knots, fit);
  return Recording{std::move(recorded), fit.worst_rad, fit.typical_rad};
}

}  // namespace gaitsmith
