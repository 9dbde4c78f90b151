// SPDX-License-Identifier: MIT
#include "core/document/recording.h"

#include <algorithm>

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
  Document recorded = document;
  recorded.kind = ControllerKind::kTrajectory;
  recorded.rules = knots;
  recorded.senses.kind = SenseKind::kTimer;
  recorded.senses.period_steps = std::max(2, document.duration_steps);
  recorded.senses.tau_min_s = kTauS;
  recorded.senses.tau_max_s = std::max(kTauS, recorded.senses.tau_max_s);
  recorded.senses.at_end = CurveEnd::kRest;
  const CurveFit fit = FitCurves(Simulate(document), CurveShape(knots, ports), recorded.senses);
  // Nothing else of the document may refer to the controllers that go.
  recorded.search.start = recorded.search.in_place_of = -1;
  recorded.search.handovers.clear();
  recorded.lineage = {};
  recorded.controllers = {{"recorded", recorded.kind, recorded.senses, knots, fit.genes}};
  recorded.timeline = {{.controller = 0, .start_step = 0}};
  recorded.hash = {};
  return Recording{std::move(recorded), fit.worst_rad, fit.typical_rad};
}

}  // namespace gaitsmith
