// SPDX-License-Identifier: MIT
// Translation of all texts. The English texts in the code are the keys: each languages/*.json is one table of
// translations. tests/web/language.test.mjs checks that the tables are complete and have no unused entries.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "core/numeric/error.h"

namespace gaitsmith::shell {

/// Sets the language of all texts from now on.
/// @param json a table of shell/words/languages; empty: English
/// @return an error if it is not such a table; then the language is unchanged
Result<void> SetLanguage(std::string_view json);

/// The text in the present language, valid until the next SetLanguage. @param english a key of the tables
[[nodiscard]] const char* Tr(const char* english);

/// Marks a literal that is passed to Tr later, for instance in a table.
constexpr const char* TrLater(const char* english) { return english; }

/// The text that replaces {1}, {2}, …
struct Insert {
  Insert(const char* words) : text(words) {}
  Insert(std::string_view words) : text(words) {}
  Insert(const std::string& words) : text(words) {}
  Insert(int number) : text(std::to_string(number)) {}
  std::string text;
};

[[nodiscard]] std::string Fill(std::string_view pattern, std::initializer_list<Insert> inserts);

/// Translates a whole sentence and fills it in: Tr("{1} of {2}", 3, 7). The order of parts differs between
/// languages.
template <class... Inserts>
  requires(sizeof...(Inserts) > 0)
[[nodiscard]] std::string Tr(const char* english, const Inserts&... inserts) {
  return Fill(Tr(english), {Insert(inserts)...});
}

/// Translates a complete sentence, for instance from core's decoders. The table has {1}, {2}, … in place of
/// numbers and "quoted" parts. Returns the sentence unchanged if the table has no entry.
[[nodiscard]] std::string TrSentence(std::string_view english);
/// Translates the name of a document or a controller if it is a shipped one or written by a search: "Mr.
/// Star-Man · travel, 10 rules with physical senses, seed 3". The stored name stays English.
[[nodiscard]] std::string TrTitle(std::string_view title);
/// Translates an error, but not its location.
[[nodiscard]] std::string TrError(const Error&);

/// The separators of decimals and of thousands.
[[nodiscard]] std::string_view DecimalMark();
[[nodiscard]] std::string_view GroupMark();

}  // namespace gaitsmith::shell
