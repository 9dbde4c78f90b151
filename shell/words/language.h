// SPDX-License-Identifier: MIT
// Translation of all texts. English texts stand in the code and are the keys of the other languages: each
// languages/*.json is one table of translations. tests/web/language.test.mjs checks that the tables are
// complete and have no unused entries.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "core/numeric/error.h"

namespace gaitsmith::shell {

/// Sets the language of all texts from now on.
/// @param json a table of shell/languages; empty: English
/// @return an error, with nothing changed, if it is not a table
Result<void> SpeakLanguage(std::string_view json);

/// The text in the present language, valid until the next SpeakLanguage. @param english a literal, or the
/// same text
[[nodiscard]] const char* Tr(const char* english);

/// Marks a literal that goes through Tr later, for instance in a table.
constexpr const char* TrLater(const char* english) { return english; }

/// The text that replaces {1}, {2} and so on.
struct Insert {
  Insert(const char* words) : text(words) {}
  Insert(std::string_view words) : text(words) {}
  Insert(const std::string& words) : text(words) {}
  Insert(int number) : text(std::to_string(number)) {}
  std::string text;
};

[[nodiscard]] std::string Fill(std::string_view pattern, std::initializer_list<Insert> inserts);

/// Tr("{1} of {2}", 3, 7): translates whole sentences, since the order of their parts differs between
/// languages.
template <class... Inserts>
  requires(sizeof...(Inserts) > 0)
[[nodiscard]] std::string Tr(const char* english, const Inserts&... inserts) {
  return Fill(Tr(english), {Insert(inserts)...});
}

/// Translates a sentence made elsewhere, for instance by core's decoders. In the table its numbers and
/// "quoted" parts are {1}, {2}... Unchanged if the table has no entry.
[[nodiscard]] std::string TrSentence(std::string_view english);
/// Translates the name of a document or a controller if it is a shipped one or written by a search: "Mr.
/// Star-Man · travel, 10 rules with physical senses, seed 3". The stored name stays English.
[[nodiscard]] std::string TrTitle(std::string_view title);
/// Translates an error. Its place stays as the document names it.
[[nodiscard]] std::string TrError(const Error&);

/// The separators of decimals and of thousands.
[[nodiscard]] std::string_view DecimalMark();
[[nodiscard]] std::string_view GroupMark();

}  // namespace gaitsmith::shell
