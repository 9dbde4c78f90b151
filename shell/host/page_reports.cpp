// SPDX-License-Identifier: MIT
// Takes what the page's workers report: the progress of searches, parts of transition maps, and plans.
#include <emscripten.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "core/document/binary.h"
#include "core/planning/planning.h"
#include "shell/host/page_session.h"
#include "shell/results/progress_record.h"
#include "shell/words/language.h"

using namespace gaitsmith;         // NOLINT: the functions below have no namespace
using namespace gaitsmith::shell;  // NOLINT

extern "C" {

/// Reports the progress of a search in the format of DecodeProgress. @return an empty text, or the error in
/// the report, which is then ignored
EMSCRIPTEN_KEEPALIVE const char* gs_search_progress(const char* report, const std::uint8_t* bytes,
                                                    int count) {
  auto progress = DecodeProgress(report, {bytes, static_cast<std::size_t>(std::max(count, 0))});
  if (!progress) {
    static std::string fault;
    fault = TrError(progress.error());
    return fault.c_str();
  }
  progress->workers = TheSession().Search().Workers();
  TheSession().OnSearchProgress(std::move(*progress));
  TheWindow().RequestOneFrame();
  return "";
}

/// Reports a part of a transition map: scores from place `first` on, and the usual score.
EMSCRIPTEN_KEEPALIVE void gs_transitions_mapped(int generation, int first, const float* scores, int count,
                                                float usual) {
  TheSession().Timeline().Transitions().OnScores(
      {.generation = generation, .first = first, .usual = usual, .scores = {scores, scores + count}});
  TheWindow().RequestOneFrame();
}
/// Reports that no more parts of this generation's map will arrive.
EMSCRIPTEN_KEEPALIVE void gs_transitions_failed(int generation) {
  TheSession().Timeline().Transitions().OnFailed(generation);
  TheWindow().RequestOneFrame();
}

/// Reports how this generation's plan is getting on. @param stage of kPlanStageNames
/// @param document in binary form; of a refused plan 0 bytes @param misses four numbers each
EMSCRIPTEN_KEEPALIVE void gs_plan_reported(int generation, const char* stage, const std::uint8_t* document,
                                           int bytes, int iterations, double cost, double played_miss_m,
                                           double first_miss_m, int corrections, const double* misses,
                                           int count) {
  PlanRun& plan = TheSession().Planning();
  TheWindow().RequestOneFrame();
  const auto named = std::ranges::find(kPlanStageNames, std::string_view(stage));
  if (named == kPlanStageNames.end()) return plan.OnFailed(generation);
  PlanReport report{.stage = static_cast<PlanReport::Stage>(named - kPlanStageNames.begin()),
                    .document = {},
                    .iterations = iterations,
                    .cost = cost,
                    .played_miss_m = played_miss_m,
                    .first_miss_m = first_miss_m,
                    .corrections = corrections};
  if (report.stage != PlanReport::Stage::kRefused) {
    auto decoded = DecodeBinary({document, static_cast<std::size_t>(std::max(bytes, 0))});
    if (!decoded) return plan.OnFailed(generation);
    report.document = std::move(*decoded);
  }
  for (const double* miss = misses; miss < misses + 4 * count; miss += 4)
    report.misses.push_back({.part = {.kind = static_cast<PlanPart::Kind>(miss[0]),
                                      .index = static_cast<int>(miss[1]),
                                      .which = static_cast<int>(miss[2])},
                             .amount = miss[3]});
  plan.OnReport(generation, std::move(report));
}
/// Reports that this generation's plan will not be carried out.
EMSCRIPTEN_KEEPALIVE void gs_plan_failed(int generation) {
  TheSession().Planning().OnFailed(generation);
  TheWindow().RequestOneFrame();
}

}  // extern "C"
