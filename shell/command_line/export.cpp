// SPDX-License-Identifier: MIT
// gaitsmith export: a document's motion as a picture, a scene or numbers, for other programs.
#include <cstdio>

#include "shell/command_line/arguments.h"
#include "shell/command_line/commands.h"
#include "shell/command_line/files.h"
#include "shell/export/film_strip.h"
#include "shell/export/skeleton_gltf.h"
#include "shell/export/trajectory_csv.h"

namespace gaitsmith::shell {

namespace {

Result<double> Moment(const Arguments& arguments, std::string_view option, double standard, double most) {
  if (!arguments.Has(option)) return standard;
  const std::string where = "--" + std::string(option);
  const auto seconds = ParseNumber(arguments.Last(option), where);
  if (!seconds) return seconds;
  if (*seconds >= 0.0 && *seconds <= most) return seconds;
  char range[64];
  std::snprintf(range, sizeof range, "must be from 0 to %g s, is \"", most);
  return Fail(ErrorCode::kOutOfRange, where, range + arguments.Last(option) + "\"");
}

Result<FilmStripOptions> StripOptions(const Arguments& arguments, double duration_s) {
  const auto poses = arguments.Integer("poses", kFewestPoses, kMostPoses, FilmStripOptions{}.poses);
  if (!poses) return std::unexpected(poses.error());
  const auto from = Moment(arguments, "from", 0.0, duration_s);
  if (!from) return std::unexpected(from.error());
  const auto to = Moment(arguments, "to", duration_s, duration_s);
  if (!to) return std::unexpected(to.error());
  if (*to <= *from) return Fail(ErrorCode::kOutOfRange, "--to", "must be later than --from");
  return FilmStripOptions{.poses = static_cast<int>(*poses), .from_s = *from, .to_s = *to};
}

}  // namespace

Outcome ExportCommand(Words words) {
  static constexpr std::string_view kOptions[] = {"svg", "gltf", "csv", "poses", "from", "to"};
  const auto arguments = Arguments::Parse(words, kOptions);
  if (!arguments) return std::unexpected(arguments.error());
  if (arguments->Positional().size() != 1)
    return Fail(ErrorCode::kMissing, "DOC", "give exactly one document");
  if (!arguments->Has("svg") && !arguments->Has("gltf") && !arguments->Has("csv"))
    return Fail(ErrorCode::kMissing, "--svg", "say where; or --gltf, or --csv");
  const auto document = ReadDocument(arguments->Positional()[0]);
  if (!document) return std::unexpected(document.error());
  const auto strip = StripOptions(*arguments, document->duration_steps * 0.01);
  if (!strip) return std::unexpected(strip.error());

  const Motion motion = Simulate(*document);
  const auto write = [&](std::string_view option, auto make) -> Result<void> {
    return arguments->Has(option) ? WriteText(arguments->Last(option), make()) : Result<void>{};
  };
  auto done = write("svg", [&] { return FilmStripSvg(*document, motion, *strip); });
  if (done) done = write("gltf", [&] { return SkeletonGltf(*document, motion); });
  if (done) done = write("csv", [&] { return TrajectoryCsv(*document, motion); });
  if (!done) return std::unexpected(done.error());
  return {};
}

}  // namespace gaitsmith::shell
