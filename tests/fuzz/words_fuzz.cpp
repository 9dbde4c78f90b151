// SPDX-License-Identifier: MIT
// Command-line arguments and address parameters: numbers within their ranges, known options, existing panels
// and locks, or an error message. Words are separated by spaces.
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "shell/command_line/arguments.h"
#include "shell/workspace/arrangement.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gaitsmith;
  using namespace gaitsmith::shell;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  std::vector<std::string_view> words;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    words.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  constexpr std::string_view kOptions[] = {"seed", "out", "weight"};
  constexpr std::string_view kFlags[] = {"best"};
  const auto arguments = Arguments::Parse(words, kOptions, kFlags);
  if (!arguments) {
    if (arguments.error().what.empty()) std::abort();
  } else if (const auto seed = arguments->Integer("seed", 0, 4294967295, 1);
             seed && (*seed < 0 || *seed > 4294967295)) {
    std::abort();
  }
  for (const std::string_view word : words) {
    if (const auto number = ParseNumber(word, "word"); number && !std::isfinite(*number)) std::abort();
    Arrangement arrangement;
    const auto no_panel = ShowPanels(word, arrangement);
    if (no_panel && word.find(*no_panel) == std::string_view::npos) std::abort();
    if (const auto no_part = LockParts(word, arrangement);
        no_part && arrangement.locked != Arrangement().locked)
      std::abort();
  }
  return 0;
}
