// SPDX-License-Identifier: MIT
// Found motions as text, for the host's storage.
#include <algorithm>
#include <array>
#include <cstdio>

#include "core/document/json_value.h"
#include "core/document/link.h"
#include "shell/results/found_motions.h"

namespace gaitsmith::shell {
namespace {

// In the order of Origin.
constexpr std::array<std::string_view, 4> kOriginNames = {"done", "stopped", "failed", "by-hand"};

// Whether a style term is in the text. Those that are measured against what was shown are left out if nothing
// was, those of the muscles if none of them has a weight.
bool Stores(const Document& document, std::size_t term) {
  if (term < kFreeTerms) return true;
  if (term < kWorkTerms) return document.task.shown != Demonstration{};
  const auto& weights = document.task.weights;
  return std::any_of(weights.begin() + kWorkTerms, weights.end(),
                     [](float weight) { return weight != 0.0f; });
}

// Calls `use` on the terms in the order of the text: the two that are not style terms, then the style table.
// Older texts may have fewer, since new terms are only appended.
template <class T, class Use>
void ForEachTerm(const Document& document, T& terms, Use use) {
  use(terms.travel_m);
  use(terms.start_height_m);
  for (std::size_t term = 0; term < kStyleTerms; ++term) {
    if (Stores(document, term)) use(terms.*kStyleTable[term].value);
  }
}

constexpr std::size_t kMinTerms = 2 + kPaperTerms;

std::string Exact(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

std::unexpected<Error> Bad(const char* where) {
  return std::unexpected(Error{ErrorCode::kStructure, where, "is not that of a found motion"});
}

}  // namespace

std::string_view NameOf(Origin origin) { return kOriginNames[static_cast<std::size_t>(origin)]; }

std::string EncodeFound(const FoundMotion& found) {
  // The terms of a motion that broke physics may be NaN or infinite, and are not used.
  std::string terms = found.terms.broke_physics ? "null" : "";
  if (terms.empty()) {
    ForEachTerm(found.document, found.terms, [&](float value) {
      terms += (terms.empty() ? "[" : ",") + Exact(static_cast<double>(value), 9);
    });
    terms += "]";
  }
  return "{\"link\":" + QuoteJson(EncodeLink(found.document)) +
         ",\"origin\":" + QuoteJson(NameOf(found.origin)) +
         ",\"evaluations\":" + std::to_string(found.evaluations) + ",\"when\":" + Exact(found.when_s, 15) +
         ",\"kept\":" + (found.kept ? "true" : "false") +
         (found.name.empty() ? "" : ",\"name\":" + QuoteJson(found.name)) + ",\"terms\":" + terms + "}";
}

Result<FoundMotion> DecodeFound(std::string_view text) {
  using Kind = JsonValue::Kind;
  const auto json = ParseJson(text);
  if (!json) return std::unexpected(json.error());
  const auto member = [&](const char* name, Kind kind) -> const JsonValue* {
    const JsonValue* value = json->Find(name);
    return value != nullptr && value->kind == kind ? value : nullptr;
  };
  const JsonValue* link = member("link", Kind::kString);
  const JsonValue* origin = member("origin", Kind::kString);
  const JsonValue* evaluations = member("evaluations", Kind::kNumber);
  const JsonValue* when = member("when", Kind::kNumber);
  const JsonValue* kept = member("kept", Kind::kBool);
  if (link == nullptr || when == nullptr || kept == nullptr) return Bad("");
  auto document = DecodeLink(link->text);
  if (!document) return std::unexpected(document.error());
  FoundMotion found{.document = std::move(*document), .when_s = when->number, .kept = kept->boolean};
  const auto name = origin == nullptr ? kOriginNames.end() : std::ranges::find(kOriginNames, origin->text);
  if (name == kOriginNames.end()) return Bad("origin");
  found.origin = static_cast<Origin>(name - kOriginNames.begin());
  if (evaluations == nullptr || !(evaluations->number >= 0.0 && evaluations->number <= 1e9))
    return Bad("evaluations");
  found.evaluations = static_cast<int>(evaluations->number);
  if (json->Find("name") != nullptr) {
    const JsonValue* given = member("name", Kind::kString);
    if (given == nullptr || !CheckName(given->text)) return Bad("name");
    found.name = given->text;
  }
  const JsonValue* terms = json->Find("terms");
  if (terms == nullptr) return Bad("terms");
  if (terms->kind == Kind::kNull) {
    found.terms.broke_physics = true;
    return found;
  }
  const auto& values = terms->items;
  const bool numbers = terms->kind == Kind::kArray && std::ranges::all_of(values, [](const JsonValue& value) {
                         return value.kind == Kind::kNumber;
                       });
  std::size_t known = 0;
  ForEachTerm(found.document, found.terms, [&](float) { ++known; });
  if (!numbers || values.size() < kMinTerms || values.size() > known) return Bad("terms");
  if (values.size() < known) {
    // Stored before the last terms were added: measure them now.
    if (found.Moves()) found.terms = Measured(found.document, found.origin, found.evaluations).terms;
    return found;
  }
  std::size_t next = 0;
  ForEachTerm(found.document, found.terms,
              [&](float& value) { value = static_cast<float>(values[next++].number); });
  return found;
}

}  // namespace gaitsmith::shell
