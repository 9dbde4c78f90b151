// SPDX-License-Identifier: MIT
#include "shell/results/progress_record.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include "core/document/json_value.h"
#include "core/document/spread_json.h"

namespace gaitsmith::shell {
namespace {

std::unexpected<Error> Bad(const char* where, const char* what) {
  return std::unexpected(Error{ErrorCode::kStructure, where, what});
}

/// A number of the record, or nothing if it is missing.
std::optional<double> NumberIn(const JsonValue& record, std::string_view name) {
  const JsonValue* value = record.Find(name);
  if (value == nullptr || value->kind != JsonValue::Kind::kNumber) return std::nullopt;
  return value->number;
}

/// A whole number from 0 to INT_MAX, or nothing.
std::optional<int> CountIn(const JsonValue& record, std::string_view name) {
  const auto number = NumberIn(record, name);
  if (!number || !(*number >= 0.0 && *number <= std::numeric_limits<int>::max())) return std::nullopt;
  const int count = static_cast<int>(*number);
  if (static_cast<double>(count) != *number) return std::nullopt;
  return count;
}

/// The next `size` bytes as items of one kind.
template <class Item>
bool TakeItems(std::span<const std::uint8_t>& bytes, int size, std::vector<Item>& items) {
  const auto taken = static_cast<std::size_t>(size);
  if (taken > bytes.size() || taken % sizeof(Item) != 0) return false;
  items.resize(taken / sizeof(Item));
  if (taken > 0) std::memcpy(items.data(), bytes.data(), taken);
  bytes = bytes.subspan(taken);
  return true;
}

}  // namespace

Result<SearchProgress> DecodeProgress(std::string_view json, std::span<const std::uint8_t> bytes) {
  const auto record = ParseJson(json);
  if (!record) return std::unexpected(record.error());
  SearchProgress progress;
  const JsonValue* state = record->Find("state");
  const auto name =
      state == nullptr ? kSearchStateNames.end() : std::ranges::find(kSearchStateNames, state->text);
  if (name == kSearchStateNames.end()) return Bad("state", "is not a state of a search");
  progress.state = static_cast<SearchState>(name - kSearchStateNames.begin());

  const auto evaluations = CountIn(*record, "evaluations"), budget = CountIn(*record, "budget");
  if (!evaluations) return Bad("evaluations", "must be a whole number");
  if (!budget) return Bad("budget", "must be a whole number");
  progress.evaluations = *evaluations;
  progress.budget = *budget;
  progress.evaluations_per_second = NumberIn(*record, "rate").value_or(0.0);
  progress.seconds_left = NumberIn(*record, "secondsLeft").value_or(0.0);
  if (const auto best = NumberIn(*record, "bestFitness")) progress.best_fitness = static_cast<float>(*best);
  if (const JsonValue* spread = record->Find("spread");
      spread != nullptr && spread->kind != JsonValue::Kind::kNull) {
    progress.spread = SpreadFromJson(*spread);
    if (!progress.spread) return Bad("spread", "lacks a number");
  }

  static_assert(sizeof(Search::CurvePoint) == 8 && sizeof(Gene) == 2);
  if (!TakeItems(bytes, CountIn(*record, "curveBytes").value_or(-1), progress.curve))
    return Bad("curveBytes", "do not fit the bytes given");
  if (!TakeItems(bytes, CountIn(*record, "genomeBytes").value_or(-1), progress.best_genome))
    return Bad("genomeBytes", "do not fit the bytes given");
  if (!TakeItems(bytes, CountIn(*record, "savedBytes").value_or(-1), progress.saved))
    return Bad("savedBytes", "do not fit the bytes given");
  if (!TakeItems(bytes, CountIn(*record, "attemptBytes").value_or(-1), progress.attempt) || !bytes.empty())
    return Bad("attemptBytes", "do not fit the bytes given");
  return progress;
}

}  // namespace gaitsmith::shell
