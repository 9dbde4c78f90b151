// SPDX-License-Identifier: MIT
// Any plan: whatever a document asks for, the solver ends, and what it says it found can be drawn. Input: a
// document as JSON.
#include <cmath>
#include <cstdlib>

#include "core/document/json.h"
#include "core/planning/plan_recorder.h"
#include "core/planning/planning.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gaitsmith;
  const auto document = DecodeJson({reinterpret_cast<const char*>(data), size});
  if (!document || document->plan.steps > 300 || document->figure.rods.size() > 6) return 0;
  if (!CanBePlanned(*document)) return 0;
  int iterations = 0;
  CarryOutPlan(*document, {.degree = 3, .pieces_per_second = 12}, [&](const PlanReport& report) {
    // What was found can be drawn: no number of it is infinite or none.
    if (report.stage == PlanReport::Stage::kCoarse) {
      for (const float unknown : report.document.plan.solved.unknowns)
        if (!std::isfinite(unknown)) std::abort();
      if (RecordPlanned(report.document, SolvedMotion(report.document)).Frames() < 2) std::abort();
    }
    return ++iterations < 60;
  });
  return 0;
}
