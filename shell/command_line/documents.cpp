// SPDX-License-Identifier: MIT
// The commands that look at one document: hash, validate, link.
#include <algorithm>
#include <cstdio>

#include "core/document/json.h"
#include "core/document/link.h"
#include "core/physics/evaluator.h"
#include "shell/command_line/arguments.h"
#include "shell/command_line/commands.h"
#include "shell/command_line/files.h"

namespace gaitsmith::shell {

namespace {

/// The one document a command was given.
Result<Document> TheDocument(const Arguments& arguments) {
  if (arguments.Positional().size() != 1)
    return Fail(ErrorCode::kMissing, "DOC", "give exactly one document");
  return ReadDocument(arguments.Positional()[0]);
}

}  // namespace

Result<void> HashCommand(Words words) {
  static constexpr std::string_view kOptions[] = {"lanes"};
  const auto arguments = Arguments::Parse(words, kOptions);
  if (!arguments) return std::unexpected(arguments.error());
  const auto document = TheDocument(*arguments);
  if (!document) return std::unexpected(document.error());
  const auto lanes = arguments->Integer("lanes", 0, 16, 0);
  if (!lanes) return std::unexpected(lanes.error());
  if (*lanes == 0) {
    std::printf("%s\n", HashText(Simulate(*document).Hash()).c_str());
    return {};
  }
  // The same motion by the searchers' evaluator, with so many lanes, in each of them.
  const auto is_count = [&](int count) { return count == *lanes; };
  if (std::ranges::none_of(Evaluator::kLaneCounts, is_count)) {
    return Fail(ErrorCode::kOutOfRange, "--lanes", "must be 1, 2, 4, 8 or 16");
  }
  if (document->timeline.size() != 1) {
    return Fail(ErrorCode::kStructure, "--lanes", "needs a document with exactly one clip");
  }
  const Controller& controller =
      document->controllers[static_cast<std::size_t>(document->timeline[0].controller)];
  const std::vector<Genome> genomes(static_cast<std::size_t>(*lanes), controller.genes);
  const auto results =
      Evaluator(ReplayProblem(*document, controller), static_cast<int>(*lanes), true).Evaluate(genomes);
  for (const Evaluation& result : results) {
    if (result.trajectory_hash != results[0].trajectory_hash) {
      return Fail(ErrorCode::kStructure, "--lanes", "lanes disagree: this is a bug of Gaitsmith");
    }
  }
  std::printf("%s\n", HashText(results[0].trajectory_hash).c_str());
  return {};
}

Result<void> ValidateCommand(Words words) {
  const auto arguments = Arguments::Parse(words, {});
  if (!arguments) return std::unexpected(arguments.error());
  const auto document = TheDocument(*arguments);
  if (!document) return std::unexpected(document.error());
  if (document->hash) {
    const std::uint64_t found = Simulate(*document).Hash();
    if (found != *document->hash) {
      return Fail(ErrorCode::kChecksum, "hash",
                  "the motion differs from the one its maker saw: " + HashText(found) + " instead of " +
                      HashText(*document->hash));
    }
  }
  std::printf("valid: %s, %d rods, %zu controllers, %zu clips, %g s\n", document->figure.name.c_str(),
              document->figure.Rods(), document->controllers.size(), document->timeline.size(),
              document->duration_steps * static_cast<double>(kStep));
  return {};
}

Result<void> LinkCommand(Words words) {
  static constexpr std::string_view kOptions[] = {"out"};
  const auto arguments = Arguments::Parse(words, kOptions);
  if (!arguments) return std::unexpected(arguments.error());
  const auto& rest = arguments->Positional();
  if (rest.size() != 2 || (rest[0] != "encode" && rest[0] != "decode")) {
    return Fail(ErrorCode::kMissing, "", "say `link encode DOC` or `link decode LINK`");
  }
  const std::string out = arguments->Last("out", "-");
  if (rest[0] == "encode") {
    const auto document = ReadDocument(rest[1]);
    if (!document) return std::unexpected(document.error());
    return WriteText(out, EncodeLink(*document) + "\n");
  }
  std::string link = rest[1];
  if (link == "-") {
    auto text = ReadText(link);
    if (!text) return std::unexpected(text.error());
    link = *text;
  }
  const auto document = DecodeLink(link);
  if (!document) return std::unexpected(document.error());
  return WriteText(out, EncodeJson(*document));
}

}  // namespace gaitsmith::shell
