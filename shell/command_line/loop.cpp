// SPDX-License-Identifier: MIT
// gaitsmith loop: which motions have a cycle, and how well it closes.
#include <array>
#include <cstdio>
#include <string>
#include <string_view>

#include "core/gait/document_loop.h"
#include "shell/command_line/arguments.h"
#include "shell/command_line/commands.h"
#include "shell/command_line/files.h"

namespace gaitsmith::shell {

Outcome LoopCommand(Words words) {
  static constexpr std::array<std::string_view, 1> kFlags = {"halves"};
  const auto arguments = Arguments::Parse(words, {}, kFlags);
  if (!arguments) return std::unexpected(arguments.error());
  if (arguments->Positional().empty()) return Fail(ErrorCode::kMissing, "DOC", "give at least one document");
  std::puts("document,period,distance,turns,likeness,gap,seam,slide,found,reason");
  for (const std::string& path : arguments->Positional()) {
    const auto document = ReadDocument(path);
    if (!document) return std::unexpected(document.error());
    const auto found = LoopOf(*document, Simulate(*document), arguments->Has("halves"));
    if (!found) {
      std::printf("%s,,,,,,,,none,\"%s\"\n", path.c_str(), found.error().what.c_str());
      continue;
    }
    const ClosedLoop& loop = found->loop;
    std::printf("%s,%.9g,%.9g,%d,%.9g,%.9g,%.9g,%.9g,%s,\n", path.c_str(), loop.cycle.PeriodS(),
                loop.distance_m, loop.turns, loop.cycle.likeness, loop.cycle.gap_rods, loop.seam_rods,
                loop.slide_rods, found->ran_on ? "later" : "shown");
  }
  return {};
}

}  // namespace gaitsmith::shell
