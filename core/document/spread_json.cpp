// SPDX-License-Identifier: MIT
#include "core/document/spread_json.h"

#include <charconv>
#include <limits>
#include <string_view>

namespace gaitsmith {
namespace {

struct Field {
  std::string_view name;
  float Spread::* value;
};
constexpr Field kFields[] = {{"least", &Spread::least},
                             {"lowerQuartile", &Spread::lower_quartile},
                             {"median", &Spread::median},
                             {"upperQuartile", &Spread::upper_quartile},
                             {"best", &Spread::best}};

// As a double, so that a reader with doubles alone has exactly the float's value.
std::string Exactly(float value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, static_cast<double>(value));
  return {text, end.ptr};
}

}  // namespace

std::string SpreadJson(const Spread& spread) {
  std::string json = "{\"members\":" + std::to_string(spread.members);
  for (const auto& [name, value] : kFields) json += "," + QuoteJson(name) + ":" + Exactly(spread.*value);
  return json + "}";
}

std::optional<Spread> SpreadFromJson(const JsonValue& json) {
  const auto number = [&](std::string_view name) -> std::optional<double> {
    const JsonValue* value = json.Find(name);
    if (value == nullptr || value->kind != JsonValue::Kind::kNumber) return std::nullopt;
    return value->number;
  };
  const auto members = number("members");
  if (!members || !(*members >= 2.0 && *members <= std::numeric_limits<std::int32_t>::max()))
    return std::nullopt;
  Spread spread{};
  spread.members = static_cast<std::int32_t>(*members);
  if (static_cast<double>(spread.members) != *members) return std::nullopt;
  for (const auto& [name, value] : kFields) {
    const auto given = number(name);
    if (!given) return std::nullopt;
    spread.*value = static_cast<float>(*given);
  }
  return spread;
}

}  // namespace gaitsmith
