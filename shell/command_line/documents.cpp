// SPDX-License-Identifier: MIT
// The commands that inspect one document: hash, validate, link.
#include <algorithm>
#include <cstdio>

#include "core/document/json.h"
#include "core/document/link.h"
#include "core/rollout/evaluator.h"
#include "shell/command_line/arguments.h"
#include "shell/command_line/commands.h"
#include "shell/command_line/files.h"

namespace gaitsmith::shell {

namespace {

/// Simulates the motion with the searches' SIMD evaluator, in each lane in turn, with other motions in the
/// other lanes.
Result<void> HashInLanes(const Document& document, int lanes) {
  if (std::ranges::none_of(Evaluator::kLaneCounts, [&](int count) { return count == lanes; })) {
    return Fail(ErrorCode::kOutOfRange, "--lanes", "must be 1, 2, 4, 8 or 16");
  }
  if (document.timeline.size() != 1) {
    return Fail(ErrorCode::kStructure, "--lanes", "needs a document with exactly one clip");
  }
  const Controller& controller =
      document.controllers[static_cast<std::size_t>(document.timeline[0].controller)];
  const Problem problem = ReplayProblem(document, controller);
  const Evaluator evaluator(problem, lanes, true);
  std::optional<std::uint64_t> hash;
  for (std::size_t place = 0; place < static_cast<std::size_t>(lanes); ++place) {
    std::vector<Genome> genomes;
    for (std::uint64_t lane = 0; lane < static_cast<std::uint64_t>(lanes); ++lane) {
      RandomStream random(place, lane, 0);
      genomes.push_back(RandomGenome(problem.Shape(), problem.senses, Variation{}, random));
    }
    genomes[place] = controller.genes;
    const std::uint64_t found = evaluator.Evaluate(genomes)[place].trajectory_hash;
    if (hash.value_or(found) != found) {
      return Fail(ErrorCode::kStructure, "--lanes", "lanes disagree: this is a bug of Gaitsmith");
    }
    hash = found;
  }
  std::printf("%s\n", HashText(*hash).c_str());
  return {};
}

}  // namespace

Outcome HashCommand(Words words) {
  static constexpr std::string_view kOptions[] = {"lanes", "out"};
  const auto arguments = Arguments::Parse(words, kOptions);
  if (!arguments) return std::unexpected(arguments.error());
  auto document = TheDocument(*arguments);
  if (!document) return std::unexpected(document.error());
  const auto lanes = arguments->Integer("lanes", 0, 16, 0);
  if (!lanes) return std::unexpected(lanes.error());
  if (*lanes != 0) return HashInLanes(*document, static_cast<int>(*lanes));
  document->hash = Simulate(*document).Hash();
  std::printf("%s\n", HashText(*document->hash).c_str());
  if (!arguments->Has("out")) return {};
  return WriteText(arguments->Last("out"), EncodeJson(*document));
}

Outcome ValidateCommand(Words words) {
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
  const Figure& figure = document->figure;
  const std::string parts = figure.HasSprings() ? std::to_string(figure.nodes.size()) + " nodes, " +
                                                      std::to_string(figure.springs.size()) + " springs, " +
                                                      std::to_string(figure.Muscles()) + " muscles"
                                                : std::to_string(figure.Rods()) + " rods";
  std::printf("valid: %s, %s, %zu controllers, %zu clips, %g s\n", figure.name.c_str(), parts.c_str(),
              document->controllers.size(), document->timeline.size(),
              document->duration_steps * static_cast<double>(kStep));
  return {};
}

Outcome LinkCommand(Words words) {
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
