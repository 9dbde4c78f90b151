// SPDX-License-Identifier: MIT
// The planner: core's solver of plans behind a C interface, compiled to a small WebAssembly module of its own
// (planner_module.js, planner_module.wasm), which is loaded when the first plan is carried out. planner.js
// wraps it; nothing else calls it.
//
// The solver does not return before it has ended, so what it reports goes to a function of the module's
// creator, Module.reported. Whatever it gets is valid until it returns.
#include <emscripten/emscripten.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/document/binary.h"
#include "core/planning/planning.h"

EM_JS(void, Reported,
      (const char* stage, std::size_t letters, const std::uint8_t* document, std::size_t bytes,
       int iterations, double cost, double played_miss_m, double first_miss_m, int corrections,
       const double* misses, std::size_t count),
      {
        Module.reported(stage, letters, document, bytes, iterations, cost, played_miss_m, first_miss_m,
                        corrections, misses, count);
      });

namespace gaitsmith {
namespace {

/// Least time between two motions that relax [ms]: enough of them to look like one movement.
constexpr double kFrameMs = 40.0;

std::vector<std::uint8_t>& Input() {
  static std::vector<std::uint8_t> input;
  return input;
}

void Tell(const PlanReport& report) {
  std::vector<std::uint8_t> document;
  if (report.stage != PlanReport::Stage::kRefused) document = EncodeBinary(report.document);
  std::vector<double> misses;
  for (const auto& [part, amount] : report.misses)
    misses.insert(misses.end(), {static_cast<double>(part.kind), static_cast<double>(part.index),
                                 static_cast<double>(part.which), amount});
  const std::string_view stage = kPlanStageNames[static_cast<std::size_t>(report.stage)];
  Reported(stage.data(), stage.size(), document.data(), document.size(), report.iterations, report.cost,
           report.played_miss_m, report.first_miss_m, report.corrections, misses.data(), misses.size());
}

}  // namespace
}  // namespace gaitsmith

using namespace gaitsmith;  // NOLINT: the functions below have no namespace

extern "C" {

/// The input area: the caller writes a document there, then calls gs_plan.
EMSCRIPTEN_KEEPALIVE std::uint8_t* gs_input(std::size_t size) {
  Input().resize(size);
  return Input().data();
}

/// Carries out the plan of the document in the first bytes of the input area.
/// @return false: core refuses the document, or its plan
EMSCRIPTEN_KEEPALIVE bool gs_plan(std::size_t size) {
  const auto document = DecodeBinary(std::span(Input()).first(size));
  if (!document || !CanBePlanned(*document)) return false;
  double told_ms = emscripten_get_now();
  CarryOutPlan(*document, kFinePlan, [&told_ms](const PlanReport& report) {
    if (report.stage == PlanReport::Stage::kRelaxing) {
      const double now_ms = emscripten_get_now();
      // A motion may be out of every range on its way.
      if (now_ms - told_ms < kFrameMs || !Validate(report.document)) return true;
      told_ms = now_ms;
    }
    Tell(report);
    return true;
  });
  return true;
}

}  // extern "C"
