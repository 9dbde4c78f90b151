// SPDX-License-Identifier: MIT
// gaitsmith measure: every term of a document's motion, and the score.
#include <cstdio>

#include "shell/command_line/arguments.h"
#include "shell/command_line/commands.h"
#include "shell/command_line/files.h"

namespace gaitsmith::shell {

Outcome MeasureCommand(Words words) {
  const auto arguments = Arguments::Parse(words, {});
  if (!arguments) return std::unexpected(arguments.error());
  if (arguments->Positional().size() != 1)
    return Fail(ErrorCode::kMissing, "DOC", "give exactly one document");
  const auto document = ReadDocument(arguments->Positional()[0]);
  if (!document) return std::unexpected(document.error());
  const Motion motion = Simulate(*document);
  const Terms& terms = motion.TermsAt(motion.Frames() - 1);

  std::string names = "travel", values;
  const auto add = [&values](float value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.9g,", static_cast<double>(value));
    values += text;
  };
  add(terms.travel_m);
  for (int term = 0; term < kStyleTerms; ++term) {
    names += "," + std::string(kStyleTermNames[static_cast<std::size_t>(term)]);
    add(terms.Style(static_cast<StyleTerm>(term)));
  }
  add(Fitness(document->task, terms));
  std::printf("%s,fitness,hash\n%s%s\n", names.c_str(), values.c_str(), HashText(motion.Hash()).c_str());
  return {};
}

}  // namespace gaitsmith::shell
