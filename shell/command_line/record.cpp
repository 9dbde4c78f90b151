// SPDX-License-Identifier: MIT
// gaitsmith record: a motion as a trajectory.
#include <array>
#include <cstdio>
#include <string_view>

#include "core/document/json.h"
#include "core/document/recording.h"
#include "shell/command_line/arguments.h"
#include "shell/command_line/commands.h"
#include "shell/command_line/files.h"

namespace gaitsmith::shell {

Outcome RecordCommand(Words words) {
  static constexpr std::array<std::string_view, 2> kOptions = {"knots", "out"};
  const auto arguments = Arguments::Parse(words, kOptions);
  if (!arguments) return std::unexpected(arguments.error());
  const auto document = TheDocument(*arguments);
  if (!document) return std::unexpected(document.error());
  int knots = kMaxRules;
  if (arguments->Has("knots")) {
    const auto given = ParseWhole(arguments->Last("knots"), 2, kMaxRules, "--knots");
    if (!given) return std::unexpected(given.error());
    knots = static_cast<int>(*given);
  }
  auto recording = RecordAsCurves(*document, knots);
  if (!recording) return std::unexpected(recording.error());
  const Motion before = Simulate(*document), after = Simulate(recording->document);
  std::printf("knots,typical_rad,worst_rad,travel,recorded_travel\n%d,%.9g,%.9g,%.9g,%.9g\n", knots,
              recording->typical_rad, recording->worst_rad,
              static_cast<double>(before.TermsAt(before.Frames() - 1).travel_m),
              static_cast<double>(after.TermsAt(after.Frames() - 1).travel_m));
  if (!arguments->Has("out")) return {};
  recording->document.hash = after.Hash();
  return WriteText(arguments->Last("out"), EncodeJson(recording->document));
}

}  // namespace gaitsmith::shell
