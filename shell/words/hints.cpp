// SPDX-License-Identifier: MIT
#include "shell/words/hints.h"

#include <algorithm>
#include <utility>

#include "core/document/json_value.h"

namespace gaitsmith::shell {
namespace {

// A global, like the language.
JsonValue& KnownHints() {
  static JsonValue table;
  return table;
}

// At the end of an id: why the widget is disabled.
constexpr char kReason = '!';
constexpr std::size_t kMaxHints = 1000;

// '*' in the name of a family stands for any text.
bool IsOf(std::string_view family, std::string_view id) {
  const std::size_t star = family.find('*');
  if (star == std::string_view::npos) return family == id;
  if (id.ends_with(kReason) != family.ends_with(kReason)) return false;
  return id.size() + 1 >= family.size() && id.starts_with(family.substr(0, star)) &&
         id.ends_with(family.substr(star + 1));
}

std::string_view SentenceFor(std::string_view id) {
  const JsonValue& table = KnownHints();
  const auto found =
      std::ranges::find_if(table.names, [&](const std::string& family) { return IsOf(family, id); });
  if (found == table.names.end()) return {};
  return table.items[static_cast<std::size_t>(found - table.names.begin())].text;
}

}  // namespace

bool SetHints(std::string_view json) {
  auto table = ParseJson(json, kMaxHints);
  if (!table || table->kind != JsonValue::Kind::kObject) return false;
  KnownHints() = std::move(*table);
  return true;
}

std::string HintFor(std::string_view id, bool disabled, std::string_view why_not) {
  std::string hint(SentenceFor(id));
  if (!disabled) return hint;
  const std::string reason(why_not.empty() ? SentenceFor(std::string(id) + kReason) : why_not);
  if (!hint.empty() && !reason.empty()) hint += ' ';
  return hint + reason;
}

}  // namespace gaitsmith::shell
