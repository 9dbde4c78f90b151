// SPDX-License-Identifier: MIT
#include "shell/words/language.h"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "core/document/json_value.h"

namespace gaitsmith::shell {
namespace {

using Table = std::map<std::string, std::string, std::less<>>;

struct Language {
  std::string decimal_mark = ".";
  std::string group_mark = ",";
  Table words;   // texts of the shell
  Table errors;  // errors of core
  Table titles;  // titles of documents
};

Language& Spoken() {
  static Language language;
  return language;
}

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

// The end of the number or quoted part that begins at `at`; `at` itself if none does.
std::size_t EndOfInsert(std::string_view text, std::size_t at) {
  if (text[at] == '"') {
    const std::size_t end = text.find('"', at + 1);
    return end == std::string_view::npos ? at : end + 1;
  }
  const std::size_t digits = at + (text[at] == '-' ? 1 : 0);
  const bool in_word = at > 0 && (IsDigit(text[at - 1]) || text[at - 1] == '_');
  if (in_word || digits >= text.size() || !IsDigit(text[digits])) return at;
  std::size_t end = digits;
  const auto digit_at = [&](std::size_t i) { return i < text.size() && IsDigit(text[i]); };
  const auto goes_on = [&](std::size_t i) {
    const char c = text[i];
    if (IsDigit(c)) return true;
    const bool sign = c == '+' || c == '-';
    const bool after_e = text[i - 1] == 'e' || text[i - 1] == 'E';
    if (c == '.' || c == ',' || (sign && after_e)) return digit_at(i + 1);
    const bool next_sign = i + 1 < text.size() && (text[i + 1] == '+' || text[i + 1] == '-');
    return (c == 'e' || c == 'E') && (digit_at(i + 1) || (next_sign && digit_at(i + 2)));
  };
  while (end < text.size() && goes_on(end)) ++end;
  return end;
}

// A sentence without its numbers, its "quoted" parts and the list of names that ends it.
struct Pattern {
  std::string text;
  std::vector<std::string> inserts;
};

Pattern PatternOf(std::string_view english) {
  constexpr std::size_t kMax = 9;
  constexpr std::string_view kBeforeNames = "choose from ";
  const std::size_t phrase = english.rfind(kBeforeNames);
  const std::size_t names = phrase == std::string_view::npos ? phrase : phrase + kBeforeNames.size();
  Pattern pattern;
  for (std::size_t at = 0; at < english.size();) {
    std::size_t end = pattern.inserts.size() < kMax ? EndOfInsert(english, at) : at;
    if (at == names) end = english.size();
    if (end == at) {
      pattern.text += english[at++];
      continue;
    }
    pattern.inserts.emplace_back(english.substr(at, end - at));
    pattern.text += "{" + std::to_string(pattern.inserts.size()) + "}";
    at = end;
  }
  return pattern;
}

std::string Filled(std::string_view pattern, const std::vector<std::string>& inserts) {
  std::string text;
  for (std::size_t at = 0; at < pattern.size(); ++at) {
    const bool place = pattern[at] == '{' && at + 2 < pattern.size() && pattern[at + 2] == '}';
    const auto which = static_cast<std::size_t>(place ? pattern[at + 1] - '1' : 0);
    if (!place || which >= inserts.size()) {
      text += pattern[at];
      continue;
    }
    text += inserts[which];
    at += 2;
  }
  return text;
}

// One part of a title, between its commas.
std::string TitlePart(std::string_view english) {
  Pattern pattern = PatternOf(english);
  for (const Table* table : {&Spoken().titles, &Spoken().words}) {
    const auto found = table->find(pattern.text);
    if (found == table->end()) continue;
    for (std::string& insert : pattern.inserts) {
      const std::size_t point = insert.find('.');
      if (IsDigit(insert.front()) && point != std::string::npos)
        insert.replace(point, 1, Spoken().decimal_mark);
    }
    return Filled(found->second, pattern.inserts);
  }
  return std::string(english);
}

// Adds an optional member of the table file. @return false: the member is not a table of texts
bool Take(const JsonValue* member, Table& table) {
  if (member == nullptr) return true;
  if (member->kind != JsonValue::Kind::kObject) return false;
  for (std::size_t i = 0; i < member->names.size(); ++i) {
    if (member->items[i].kind != JsonValue::Kind::kString) return false;
    table.emplace(member->names[i], member->items[i].text);
  }
  return true;
}

}  // namespace

Result<void> SetLanguage(std::string_view json) {
  if (json.empty()) {
    Spoken() = Language{};
    return {};
  }
  constexpr std::size_t kMaxWords = 4000;
  const auto table = ParseJson(json, kMaxWords);
  if (!table) return std::unexpected(table.error());
  const auto text = [&](const char* name) -> const JsonValue* {
    const JsonValue* value = table->Find(name);
    return value != nullptr && value->kind == JsonValue::Kind::kString ? value : nullptr;
  };
  const JsonValue* decimal = text("decimal_mark");
  const JsonValue* group = text("group_mark");
  const JsonValue* words = table->Find("words");
  if (decimal == nullptr || group == nullptr || words == nullptr)
    return Fail(ErrorCode::kStructure, "", "is not a table of words");
  Language language{decimal->text, group->text, {}, {}, {}};
  const bool taken = Take(words, language.words) && Take(table->Find("errors"), language.errors) &&
                     Take(table->Find("titles"), language.titles);
  if (!taken) return Fail(ErrorCode::kStructure, "", "is not a table of words");
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
  std::vector<std::string> texts;
  for (const Insert& insert : inserts) texts.push_back(insert.text);
  return Filled(pattern, texts);
}

std::string TrSentence(std::string_view english) {
  if (Spoken().words.empty()) return std::string(english);
  const Pattern pattern = PatternOf(english);
  for (const Table* table : {&Spoken().errors, &Spoken().words}) {
    if (const auto found = table->find(pattern.text); found != table->end())
      return Filled(found->second, pattern.inserts);
  }
  return std::string(english);
}

std::string TrTitle(std::string_view title) {
  if (Spoken().words.empty()) return std::string(title);
  if (const auto found = Spoken().titles.find(title); found != Spoken().titles.end()) return found->second;
  std::string text;
  for (std::size_t at = 0; at < title.size();) {
    constexpr std::string_view kComma = ", ", kDot = " · ";
    const std::size_t comma = title.find(kComma, at);
    const std::size_t dot = title.find(kDot, at);
    const std::size_t end = std::min({comma, dot, title.size()});
    const std::string_view mark = end == title.size() ? "" : end == dot ? kDot : kComma;
    const std::string_view part = title.substr(at, end - at);
    // The first part is a name.
    const auto name = at == 0 ? Spoken().titles.find(part) : Spoken().titles.end();
    text += name != Spoken().titles.end() ? name->second : at == 0 ? std::string(part) : TitlePart(part);
    text += mark;
    at = end + mark.size();
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
