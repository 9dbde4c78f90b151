// SPDX-License-Identifier: MIT
// What a person reads, in the language they chose. English stands where it is used and is the key to every
// other language: languages/*.json hold all of it in one table each, and tests/web/language.test.mjs sees
// that nothing is missing there and nothing left over.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "core/numeric/error.h"

namespace gaitsmith::shell {

/// Replaces the language in which everything is said from now on.
/// @param json a table of shell/languages; empty: English
/// @return an error, and nothing changed, where it is no table
Result<void> SpeakLanguage(std::string_view json);

/// In the language spoken now: good until the next SpeakLanguage. @param english a literal, or the same text
[[nodiscard]] const char* Tr(const char* english);

/// Marks a literal that goes through Tr later, for instance in a table.
constexpr const char* TrLater(const char* english) { return english; }

/// What stands in the place of {1}, {2} and so on.
struct Insert {
  Insert(const char* words) : text(words) {}
  Insert(std::string_view words) : text(words) {}
  Insert(const std::string& words) : text(words) {}
  Insert(int number) : text(std::to_string(number)) {}
  std::string text;
};

[[nodiscard]] std::string Fill(std::string_view pattern, std::initializer_list<Insert> inserts);

/// Tr("{1} of {2}", 3, 7): whole sentences, since other languages order their parts otherwise.
template <class... Inserts>
  requires(sizeof...(Inserts) > 0)
[[nodiscard]] std::string Tr(const char* english, const Inserts&... inserts) {
  return Fill(Tr(english), {Insert(inserts)...});
}

/// A sentence made elsewhere, for instance by core's decoders, whose numbers and "quoted" parts stand in the
/// table as {1}, {2}...; as it is where the table has none.
[[nodiscard]] std::string TrSentence(std::string_view english);
/// The name of a document or a controller, which stays as it was made, as a person reads it: shipped ones,
/// and what a search has written: "Mr. Star-Man · travel, 10 rules with physical senses, seed 3".
[[nodiscard]] std::string TrTitle(std::string_view title);
/// An error as a person reads it: the place stays as the document names it.
[[nodiscard]] std::string TrError(const Error&);

/// Between whole and broken part, and between thousands.
[[nodiscard]] std::string_view DecimalMark();
[[nodiscard]] std::string_view GroupMark();

}  // namespace gaitsmith::shell
