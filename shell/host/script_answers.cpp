// SPDX-License-Identifier: MIT
#include "shell/host/script_answers.h"

#include <cmath>
#include <cstdio>
#include <limits>

#include "core/document/joints.h"
#include "core/document/json_value.h"
#include "core/document/link.h"
#include "core/document/schema.h"
#include "shell/words/control_modes.h"
#include "shell/words/language.h"
#include "shell/words/search_words.h"
#include "shell/words/style_words.h"

namespace gaitsmith::shell {
namespace {

std::string Exact(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

std::string SearchMembers(const SearchSettings& search, int evaluations) {
  return ",\"algorithm\":" + QuoteJson(kAlgorithmNames[static_cast<std::size_t>(search.algorithm)]) +
         ",\"seed\":" + std::to_string(search.seed) + ",\"evaluations\":" + std::to_string(evaluations);
}

/// The word of docs/embedding.md: usual, earth (usual but for limited joints) or other.
std::string_view WorldOf(const Document& document) {
  const StartState &start = document.start, usual;
  if (document.environment != Environment{} || start.drop_height_m != usual.drop_height_m ||
      start.velocity_x_mps != usual.velocity_x_mps || start.velocity_y_mps != usual.velocity_y_mps ||
      start.spin_radps != usual.spin_radps)
    return "other";
  return HasLimitedJoints(document) ? "earth" : "usual";
}

}  // namespace

std::string QueueJson(const SearchQueue& queue) {
  std::string json = "[";
  for (const SearchQueue::Entry& entry : queue.Waiting()) {
    if (json.size() > 1) json += ",\n";
    const SearchSettings& search = entry.document.search;
    json += "{\"title\":" + QuoteJson(SearchName(entry.document)) +
            SearchMembers(search, search.evaluations) + "}";
  }
  return json + "]";
}

std::string FoundJson(const FoundMotions& found) {
  std::string json = "[";
  for (const FoundMotions::Entry* entry : found.Sorted(FoundMotions::Order::kNewest)) {
    if (json.size() > 1) json += ",\n";
    const FoundMotion& motion = entry->motion;
    const bool scored = motion.Score() > kVoidScore;
    json += "{\"id\":" + QuoteJson(entry->id) + ",\"title\":" + QuoteJson(motion.document.title) +
            (motion.name.empty() ? "" : ",\"name\":" + QuoteJson(motion.name)) +
            ",\"origin\":" + QuoteJson(NameOf(motion.origin)) +
            ",\"score\":" + (scored ? Exact(static_cast<double>(motion.Score()), 9) : "null") +
            SearchMembers(motion.document.search, motion.evaluations) +
            ",\"kept\":" + (motion.kept ? "true" : "false") + ",\"when\":" + Exact(motion.when_s, 15) +
            ",\"hash\":" + QuoteJson(motion.document.hash ? HashText(*motion.document.hash) : "") +
            ",\"link\":" + QuoteJson(EncodeLink(motion.document)) + "}";
  }
  return json + "]";
}

std::string MeasuresJson(const Session& session) {
  const Motion& motion = session.Player().Shown();
  const Terms& terms = motion.TermsAt(motion.Frames() - 1);
  std::string json = "{\"terms\":[";
  const auto add = [&json](std::string_view name, const char* label, const char* unit, int decimals,
                           float value) {
    if (!json.ends_with('[')) json += ",\n";
    json += "{\"name\":" + QuoteJson(name) + ",\"label\":" + QuoteJson(label) +
            ",\"unit\":" + QuoteJson(unit) + ",\"decimals\":" + std::to_string(decimals) +
            ",\"value\":" + (std::isfinite(value) ? Exact(static_cast<double>(value), 9) : "null") + "}";
  };
  add("distance", Tr("Distance"), "m", 2, std::abs(terms.travel_m));
  add("travel", Tr("Travel to the right"), "m", 2, terms.travel_m);
  for (std::size_t i = 0; i < static_cast<std::size_t>(kStyleTerms); ++i) {
    const TermWords words = TermTextFor(session.Doc().figure, i);
    add(kStyleTermNames[i], Tr(words.label), *words.unit == '\0' ? "" : Tr(words.unit), words.decimals,
        terms.Style(static_cast<StyleTerm>(i)));
  }
  const Document& document = session.Doc();
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  const auto seconds = [](int step) { return static_cast<float>(step) * kStep; };
  const bool one_push = document.pushes.size() == 1, switches = document.timeline.size() > 1;
  add("seed", Tr("Seed"), "", 0, static_cast<float>(session.Origins().SeedOf(document)));
  add("pushes", Tr("Pushes"), "", 0, static_cast<float>(document.pushes.size()));
  add("push_right", Tr("Push to the right"), "N s", 1, one_push ? document.pushes[0].impulse_x_ns : kNone);
  add("push_time", Tr("Time of the push"), "s", 2, one_push ? seconds(document.pushes[0].step) : kNone);
  add("switch", Tr("Last switch"), "s", 2, switches ? seconds(document.timeline.back().start_step) : kNone);
  add("generations", Tr("Generations bred here"), "", 0,
      static_cast<float>(session.Origins().GenerationsOf(document)));
  add("strength", Tr("Strength of the joints"), "M g L", 2,
      HasLimitedJoints(document) ? JointStrength(document) : kNone);
  const Controller* controller = session.Timeline().ShownController();
  const std::string_view sense = controller == nullptr ? "" : ControlModeOf(*controller).name;
  return json + "],\"sense\":" + QuoteJson(sense) +
         ",\"controller\":" + QuoteJson(session.Origins().Of(document)) +
         ",\"world\":" + QuoteJson(WorldOf(document)) +
         ",\"rules\":" + std::to_string(controller == nullptr ? 0 : controller->rules) +
         ",\"broke\":" + (terms.broke_physics ? "true" : "false") +
         ",\"preview\":" + (session.Following().Previewing() ? "true" : "false") + "}";
}

}  // namespace gaitsmith::shell
