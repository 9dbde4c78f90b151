// SPDX-License-Identifier: MIT
#include "core/document/recording.h"

#include <algorithm>
#include <utility>

#include "core/rollout/curve_fit.h"
#include "core/rollout/models.h"

namespace gaitsmith {

namespace {

/// The least that a document may have: joints must keep up with rules of any time constant.
constexpr float kTauS = 0.02f;

}  // namespace

Result<Recording> RecordAsCurves(const Document& document, int knots) {
  if (document.timeline.empty())
    return Fail(ErrorCode::kMissing, "timeline", "has no controller whose motion could be recorded");
  const PortCount ports = CountPorts(document.model, document.figure);
  if (ports.actuators == 0)
    return Fail(ErrorCode::kMissing, "figure", "has no joint whose angle could be recorded");
  SenseSpec senses = document.senses;
  senses.kind = SenseKind::kTimer;
  senses.period_steps = std::max(2, document.duration_steps);
  senses.tau_min_s = kTauS;
  senses.tau_max_s = std::max(kTauS, senses.tau_max_s);
  senses.at_end = CurveEnd::kRest;
  CurveFit fit = FitCurves(Simulate(document), CurveShape(knots, ports), senses);
  // What the next search makes stays as it is, but nothing may refer to the controllers that go.
  Document recorded = document;
  recorded.search.start = recorded.search.in_place_of = -1;
  recorded.search.handovers.clear();
  recorded.lineage = {};
  recorded.controllers = {{"recorded", ControllerKind::kTrajectory, senses, knots, std::move(fit.genes)}};
  recorded.timeline = {{.controller = 0, .start_step = 0}};
  recorded.hash = {};
  return Recording{std::move(recorded), fit.worst_rad, fit.typical_rad};
}

}  // namespace gaitsmith
