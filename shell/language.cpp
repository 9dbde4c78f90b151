// SPDX-License-Identifier: MIT
#include "shell/language.h"

#include <functional>
#include <map>

#include "core/document/json_value.h"

namespace gaitsmith::shell {
namespace {

struct Language {
  std::string decimal_mark = ".";
  std::string group_mark = ",";
  std::map<std::string, std::string, std::less<>> words;
};

Language& Spoken() {
  static Language language;
  return language;
}

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

// The end of the number or quoted part that begins here; `at` itself: none does.
std::size_t EndOfInsert(std::string_view text, std::size_t at) {
  if (text[at] == '"') {
    const std::size_t end = text.find('"', at + 1);
    return end == std::string_view::npos ? at : end + 1;
  }
  const std::size_t digits = at + (text[at] == '-' ? 1 : 0);
  const bool in_word = at > 0 && (IsDigit(text[at - 1]) || text[at - 1] == '_');
  if (in_word || digits >= text.size() || !IsDigit(text[digits])) return at;
  std::size_t end = digits;
  const auto goes_on = [&](std::size_t i) {
    if (IsDigit(text[i])) return true;
    const bool mark = text[i] == '.' || text[i] == ',' || ((text[i] == '+' || text[i] == '-') && text[i - 1] == 'e');
    const bool exponent = text[i] == 'e' && i + 1 < text.size() && (text[i + 1] == '+' || text[i + 1] == '-');
    return exponent || (mark && i + 1 < text.size() && IsDigit(text[i + 1]));
  };
  while (end < text.size() && goes_on(end)) ++end;
  return end;
}

}  // namespace

Result<void> SpeakLanguage(std::string_view json) {
  if (json.empty()) {
    Spoken() = Language{};
    return {};
  }
  const auto table = ParseJson(json);
  if (!table) return std::unexpected(table.error());
  const auto text = [&](const char* name) -> const JsonValue* {
    const JsonValue* value = table->Find(name);
    return value != nullptr && value->kind == JsonValue::Kind::kString ? value : nullptr;
  };
  const JsonValue* decimal = text("decimal_mark");
  const JsonValue* group = text("group_mark");
  const JsonValue* words = table->Find("words");
  if (decimal == nullptr || group == nullptr || words == nullptr || words->kind != JsonValue::Kind::kObject)
    return Fail(ErrorCode::kStructure, "", "is not a table of words");
  Language language{decimal->text, group->text, {}};
  for (std::size_t i = 0; i < words->names.size(); ++i) {
    if (words->items[i].kind != JsonValue::Kind::kString)
      return Fail(ErrorCode::kStructure, words->names[i], "is not a string");
    language.words.emplace(words->names[i], words->items[i].text);
  }
  Spoken() = std::move(language);
  return {};
}

const char* Tr(const char* english) {
  const auto& words = Spoken().words;
  if (words.empty()) return english;
  const auto found = words.find(std::string_view(english));
  return found == words.end() ? english : found->second.c_str();
}

std::string Fill(std::string_view pattern, std::initializer_list<Insert> inserts) {
  std::string text;
  for (std::size_t at = 0; at < pattern.size(); ++at) {
    const bool place = pattern[at] == '{' && at + 2 < pattern.size() && pattern[at + 2] == '}';
    const auto which = static_cast<std::size_t>(place ? pattern[at + 1] - '1' : 0);
    if (!place || which >= inserts.size()) {
      text += pattern[at];
      continue;
    }
    text += inserts.begin()[which].text;
    at += 2;
  }
  return text;
}

std::string TrSentence(std::string_view english) {
  const auto& words = Spoken().words;
  if (words.empty()) return std::string(english);
  std::string pattern;
  std::vector<std::string> inserts;
  for (std::size_t at = 0; at < english.size();) {
    const std::size_t end = inserts.size() < 9 ? EndOfInsert(english, at) : at;
    if (end == at) {
      pattern += english[at++];
      continue;
    }
    inserts.emplace_back(english.substr(at, end - at));
    pattern += "{" + std::to_string(inserts.size()) + "}";
    at = end;
  }
  const auto found = words.find(pattern);
  if (found == words.end()) return std::string(english);
  std::string text = found->second;
  for (std::size_t i = inserts.size(); i-- > 0;) {
    const std::string place = "{" + std::to_string(i + 1) + "}";
    if (const std::size_t at = text.find(place); at != std::string::npos)
      text.replace(at, place.size(), inserts[i]);
  }
  return text;
}

std::string TrError(const Error& error) {
  const std::string what = TrSentence(error.what);
  return error.where.empty() ? what : TrSentence(error.where) + ": " + what;
}

std::string_view DecimalMark() { return Spoken().decimal_mark; }
std::string_view GroupMark() { return Spoken().group_mark; }

}  // namespace gaitsmith::shell
