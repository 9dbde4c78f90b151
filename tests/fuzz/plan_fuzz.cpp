// SPDX-License-Identifier: MIT
// Any plan: whatever a document asks for, the solver ends, and what it says it found obeys the equations of
// the centre of mass, stays in the cone of friction and can be stored. Input: a document as JSON.
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "core/document/json.h"
#include "core/document/planning.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gaitsmith;
  const auto document = DecodeJson({reinterpret_cast<const char*>(data), size});
  if (!document || document->plan.steps > 300 || document->figure.rods.size() > 6) return 0;
  if (!CanBePlanned(*document)) return 0;
  int iterations = 0;
  CarryOutPlan(*document, {.degree = 3, .pieces_per_second = 12}, [&](const PlanReport& report) {
    if (report.stage == PlanReport::Stage::kCoarse) {
      const PlannedMotion motion = SolvedMotion(report.document);
      const auto friction = static_cast<double>(document->environment.friction);
      for (int i = 0; i <= 50; ++i) {
        const PlannedMotion::Instant at = motion.At(motion.DurationS() * i / 50);
        if (!(at.force_residual < 1e-3)) std::abort();  // coefficients are stored as floats
        for (const auto& force : at.forces)
          if (!(std::abs(force.x) <= friction * force.y * 1.001 + 1e-3)) std::abort();
      }
    }
    return ++iterations < 60;
  });
  return 0;
}
