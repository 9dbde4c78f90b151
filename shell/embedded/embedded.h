// SPDX-License-Identifier: MIT
// Files that travel inside the program, written as arrays by embed.cmake: the typeface, the shipped documents
// and another language.
#pragma once

#include <span>
#include <string_view>

namespace gaitsmith::shell {

[[nodiscard]] std::span<const unsigned char> InterRegular();
[[nodiscard]] std::span<const unsigned char> InterSemiBold();

/// A document, figure or problem of examples/.
struct Example {
  std::string_view name;  // the file's name without folder and ending, e.g. "star-man-shuffle"
  std::string_view json;
};
[[nodiscard]] std::span<const Example> ExampleDocuments();
[[nodiscard]] std::span<const Example> ExampleFigures();
/// Documents without a controller: a figure, a task and senses that go well together.
[[nodiscard]] std::span<const Example> ExampleProblems();
/// Ready motions, those of docs/gallery.md and of docs/lessons; empty in the page, which is light.
[[nodiscard]] std::span<const Example> ExampleGallery();

/// languages/de.json; empty in the page, which fetches it.
[[nodiscard]] std::string_view GermanTable();

}  // namespace gaitsmith::shell
