// SPDX-License-Identifier: MIT
// gaitsmith export: a document's motion as a picture, a scene or numbers, for other programs.
#include <algorithm>
#include <array>
#include <cstdio>
#include <span>
#include <vector>

#include "core/gait/document_loop.h"
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

Result<SpriteOptions> SpritesAsked(const Arguments& arguments) {
  const auto frames = arguments.Integer("sprite-frames", SpriteOptions::kLeastFrames,
                                        SpriteOptions::kMostFrames, SpriteOptions{}.frames);
  if (!frames) return std::unexpected(frames.error());
  const auto size = arguments.Integer("sprite-size", SpriteOptions::kLeastSize, SpriteOptions::kMostSize,
                                      SpriteOptions{}.size);
  if (!size) return std::unexpected(size.error());
  SpriteOptions sprites{.frames = static_cast<int>(*frames), .size = static_cast<int>(*size)};
  if (!arguments.Has("sprite-scale")) return sprites;
  if (arguments.Has("sprite-size"))
    return Fail(ErrorCode::kOutOfRange, "--sprite-scale",
                "does not go with --sprite-size: it says how large frames are");
  const auto scale = ParseNumber(arguments.Last("sprite-scale"), "--sprite-scale");
  if (!scale) return std::unexpected(scale.error());
  if (!(*scale >= SpriteOptions::kLeastScale && *scale <= SpriteOptions::kMostScale))
    return Fail(ErrorCode::kOutOfRange, "--sprite-scale",
                "must be from 1 to 1000 pixels a metre, is \"" + arguments.Last("sprite-scale") + "\"");
  sprites.scale = *scale;
  return sprites;
}

/// The error if no output file is given.
Outcome NoFile() {
  std::string what = "say where";
  for (const ExporterRow& row : std::span(kExporters).subspan(1))
    what.append(what.ends_with("where") ? ";" : ",").append(" or --").append(row.id);
  return Fail(ErrorCode::kMissing, "--" + std::string(kExporters[0].id), what);
}

/// The motion to export: as the simulator plays it, as it is planned, or one cycle of it.
Result<Motion> Chosen(const Arguments& arguments, const Document& document) {
  const bool loop = arguments.Has("loop");
  for (const char* option : {"halves", "in-place"}) {
    if (arguments.Has(option) && !loop)
      return Fail(ErrorCode::kMissing, std::string("--") + option, "needs --loop");
  }
  if (!arguments.Has("planned") && !loop) return Simulate(document);
  if (!loop) return RecordPlanned(document);
  if (arguments.Has("planned"))
    return Fail(ErrorCode::kOutOfRange, "--loop",
                "does not go with --planned: loops are found in what is played");
  const auto found = LoopOf(document, Simulate(document), arguments.Has("halves"));
  if (!found) return std::unexpected(found.error());
  return RecordLoop(document, found->loop, arguments.Has("in-place"));
}

}  // namespace

Outcome ExportCommand(Words words) {
  std::vector<std::string_view> options = {"poses",         "from",        "to",
                                           "sprite-frames", "sprite-size", "sprite-scale"};
  for (const ExporterRow& row : kExporters) options.push_back(row.id);
  static constexpr std::array<std::string_view, 4> kFlags = {"planned", "loop", "halves", "in-place"};
  const auto arguments = Arguments::Parse(words, options, kFlags);
  if (!arguments) return std::unexpected(arguments.error());
  if (arguments->Positional().size() != 1)
    return Fail(ErrorCode::kMissing, "DOC", "give exactly one document");
  if (std::ranges::none_of(kExporters, [&](const ExporterRow& row) { return arguments->Has(row.id); }))
    return NoFile();
  const auto document = ReadDocument(arguments->Positional()[0]);
  if (!document) return std::unexpected(document.error());
  const auto motion = Chosen(*arguments, *document);
  if (!motion) return std::unexpected(motion.error());
  const auto strip = StripOptions(*arguments, (motion->Frames() - 1) * 0.01);
  if (!strip) return std::unexpected(strip.error());
  const auto sprites = SpritesAsked(*arguments);
  if (!sprites) return std::unexpected(sprites.error());
  for (const ExporterRow& row : kExporters) {
    if (!arguments->Has(row.id)) continue;
    const auto file = MakeFile(row, *document, *motion,
                               {.strip = *strip,
                                .sprites = *sprites,
                                .loops = arguments->Has("loop"),
                                .from_start = !arguments->Has("loop") && !arguments->Has("planned")});
    if (!file) return std::unexpected(file.error());
    const auto done = WriteText(arguments->Last(row.id), *file);
    if (!done) return std::unexpected(done.error());
  }
  return {};
}

}  // namespace gaitsmith::shell
