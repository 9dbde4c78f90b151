// SPDX-License-Identifier: MIT
// Files embedded into the program as arrays, written by embed.cmake: the typeface, the shipped documents and
// the translations.
#pragma once

#include <span>
#include <string_view>

namespace gaitsmith::shell {

[[nodiscard]] std::span<const unsigned char> InterRegular();
[[nodiscard]] std::span<const unsigned char> InterSemiBold();

/// A document, figure or problem of examples/.
struct Example {
  std::string_view name;  // the file's name without folder and extension, e.g. "star-man-shuffle"
  std::string_view json;
};
[[nodiscard]] std::span<const Example> ExampleDocuments();
[[nodiscard]] std::span<const Example> ExampleFigures();
/// Documents without a controller: a figure, a task and suitable senses.
[[nodiscard]] std::span<const Example> ExampleProblems();
/// The motions of docs/gallery.md and of docs/lessons. Empty in the page, to keep it small.
[[nodiscard]] std::span<const Example> ExampleGallery();

/// A language that the texts are in.
struct Language {
  std::string_view code;   // "de": the name of its table in shell/words/languages
  std::string_view name;   // in the language itself
  std::string_view json;   // the table; empty for English, and in the page, which downloads it
  std::string_view hints;  // the table of shell/words/hints; empty in the page
};
/// English first, then in the order of the codes.
[[nodiscard]] std::span<const Language> Languages();

}  // namespace gaitsmith::shell
