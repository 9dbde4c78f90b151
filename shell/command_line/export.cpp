// SPDX-License-Identifier: MIT
// gaitsmith export: a document's motion as a picture, a scene or numbers, for other programs.
#include <algorithm>
#include <array>
#include <cstdio>
#include <span>
#include <vector>

#include "core/planning/plan_recorder.h"
#include "shell/command_line/arguments.h"
#include "shell/command_line/commands.h"
#include "shell/command_line/files.h"
#include "shell/export/exporters.h"

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
  const auto poses = arguments.Integer("poses", kMinPoses, kMaxPoses, FilmStripOptions{}.poses);
  if (!poses) return std::unexpected(poses.error());
  const auto from = Moment(arguments, "from", 0.0, duration_s);
  if (!from) return std::unexpected(from.error());
  const auto to = Moment(arguments, "to", duration_s, duration_s);
  if (!to) return std::unexpected(to.error());
  if (*to <= *from) return Fail(ErrorCode::kOutOfRange, "--to", "must be later than --from");
  return FilmStripOptions{.poses = static_cast<int>(*poses), .from_s = *from, .to_s = *to};
}

/// The error if no output file is given.
Outcome NoFile() {
  std::string what = "say where";
  for (const ExporterRow& row : std::span(kExporters).subspan(1))
    what.append(what.ends_with("where") ? ";" : ",").append(" or --").append(row.id);
  return Fail(ErrorCode::kMissing, "--" + std::string(kExporters[0].id), what);
}

}  // namespace

Outcome ExportCommand(Words words) {
  std::vector<std::string_view> options = {"poses", "from", "to"};
  for (const ExporterRow& row : kExporters) options.push_back(row.id);
  static constexpr std::array<std::string_view, 1> kFlags = {"planned"};
  const auto arguments = Arguments::Parse(words, options, kFlags);
  if (!arguments) return std::unexpected(arguments.error());
  if (arguments->Positional().size() != 1)
    return Fail(ErrorCode::kMissing, "DOC", "give exactly one document");
  if (std::ranges::none_of(kExporters, [&](const ExporterRow& row) { return arguments->Has(row.id); }))
    return NoFile();
  const auto document = ReadDocument(arguments->Positional()[0]);
  if (!document) return std::unexpected(document.error());
  const auto strip = StripOptions(*arguments, document->duration_steps * 0.01);
  if (!strip) return std::unexpected(strip.error());

  const Result<Motion> motion =
      arguments->Has("planned") ? RecordPlanned(*document) : Result<Motion>(Simulate(*document));
  if (!motion) return std::unexpected(motion.error());
  for (const ExporterRow& row : kExporters) {
    if (!arguments->Has(row.id)) continue;
    const auto file = MakeFile(row, *document, *motion, *strip);
    if (!file) return std::unexpected(file.error());
    const auto done = WriteText(arguments->Last(row.id), *file);
    if (!done) return std::unexpected(done.error());
  }
  return {};
}

}  // namespace gaitsmith::shell
