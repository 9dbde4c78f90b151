// SPDX-License-Identifier: MIT
// gaitsmith measure: every term of a document's motion, and the score.
#include <array>
#include <cstdio>
#include <string_view>

#include "shell/command_line/arguments.h"
#include "shell/command_line/commands.h"
#include "shell/command_line/files.h"
#include "shell/command_line/problem_options.h"

namespace gaitsmith::shell {

Outcome MeasureCommand(Words words) {
  static constexpr std::array<std::string_view, 2> kOptions = {"joints", "ground"};
  const auto arguments = Arguments::Parse(words, kOptions);
  if (!arguments) return std::unexpected(arguments.error());
  auto document = TheDocument(*arguments);
  if (!document) return std::unexpected(document.error());
  if (auto set = SetProblemOptions(*arguments, *document); !set) return set;
  const Motion motion = Simulate(*document);
  const Terms& terms = motion.TermsAt(motion.Frames() - 1);

  std::string names = "travel", values;
  const auto add = [&values](float value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.9g,", static_cast<double>(value));
    values += text;
  };
  add(terms.travel_m);
  const auto add_terms = [&](int first, int end) {
    for (int term = first; term < end; ++term) {
      names += "," + std::string(kStyleTermNames[static_cast<std::size_t>(term)]);
      add(terms.Style(static_cast<StyleTerm>(term)));
    }
  };
  add_terms(0, kFreeTerms);
  add(Fitness(document->task, terms));
  names += ",fitness,hash";
  values += HashText(motion.Hash()) + ",";
  add_terms(kFreeTerms, kStyleTerms);  // later columns than the hash
  values.pop_back();
  std::printf("%s\n%s\n", names.c_str(), values.c_str());
  return {};
}

}  // namespace gaitsmith::shell
