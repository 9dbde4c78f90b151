// SPDX-License-Identifier: MIT
// Files made of a motion, behind the engine's border. The small engine goes without them.
#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "core/document/archive.h"
#include "core/gait/document_loop.h"
#include "core/planning/plan_recorder.h"
#include "shell/export/exporters.h"
#include "web/search/engine_border.h"
#include "web/search/motion_role.h"

using namespace gaitsmith;  // NOLINT: everything below is the border

/// The motion that is planned between the document's keyframes instead of the played one. A plan without a
/// solution is an error.
GS_EXPORT MotionRole* gs_motion_open_planned(std::size_t size) {
  auto document = TakeDocument(size);
  if (!document) return nullptr;
  auto motion = RecordPlanned(*document);
  if (!motion) {
    Note(motion.error());
    return nullptr;
  }
  MotionRole* role = OpenMotion(std::move(*document), std::move(*motion));
  role->from_start = false;
  return role;
}
/// One cycle of the motion, closed (core/gait/document_loop.h). An error says why it has none.
/// @param halves   make the second half of the first one @param in_place without its way
GS_EXPORT MotionRole* gs_motion_open_loop(std::size_t size, bool halves, bool in_place) {
  auto document = TakeDocument(size);
  if (!document) return nullptr;
  auto found = LoopOf(*document, Simulate(*document), halves);
  if (!found) {
    Note(found.error());
    return nullptr;
  }
  const ClosedLoop& loop = found->loop;
  Motion motion = RecordLoop(*document, loop, in_place);
  MotionRole* role = OpenMotion(std::move(*document), std::move(motion));
  role->from_start = false;
  role->loop = "{\"period\":" + RealText(static_cast<float>(loop.cycle.PeriodS())) +
               ",\"distance\":" + RealText(static_cast<float>(loop.distance_m)) +
               ",\"turns\":" + std::to_string(loop.turns) +
               ",\"likeness\":" + RealText(static_cast<float>(loop.cycle.likeness)) +
               ",\"gap\":" + RealText(static_cast<float>(loop.cycle.gap_rods)) +
               ",\"slide\":" + RealText(static_cast<float>(loop.slide_rods)) +
               ",\"later\":" + (found->ran_on ? "true" : "false") + "}";
  return role;
}
// Exported files, gs_motion_text_size() bytes.
/// What is known of a loop: its period [s], distance [m], turns, likeness, gap and slide [longest rod], and
/// whether the controller had to run on to find it; "null" for a whole motion. As JSON.
GS_EXPORT const char* gs_motion_loop(MotionRole* role) { return Keep(role, role->loop); }
/// @param words_size bytes of FilmStripWords in the input area, with a 0 byte after each
GS_EXPORT const char* gs_motion_film_strip(MotionRole* role, std::size_t words_size, int poses) {
  shell::FilmStripOptions options{.poses = poses};
  const std::string_view words(reinterpret_cast<const char*>(Input().data()), words_size);
  std::size_t at = 0;
  for (std::string* word : {&options.words.description, &options.words.slope, &options.words.decimal_mark}) {
    const std::size_t end = words.find('\0', at);
    if (end == std::string_view::npos) {
      Note({ErrorCode::kTruncated, "words", "fewer than expected"});
      return nullptr;
    }
    *word = words.substr(at, end - at);
    at = end + 1;
  }
  return Keep(role, shell::FilmStripSvg(role->document, role->motion, options));
}
namespace {

const char* FileOf(MotionRole* role, std::string_view id, const shell::SpriteOptions& sprites) {
  const auto row = std::ranges::find(shell::kExporters, id, &shell::ExporterRow::id);
  if (row == shell::kExporters.end()) {
    Note({ErrorCode::kUnknownName, "", "there is no such export"});
    return nullptr;
  }
  auto file =
      shell::MakeFile(*row, role->document, role->motion,
                      {.sprites = sprites, .loops = role->loop != "null", .from_start = role->from_start});
  if (!file) {
    Note(file.error());
    return nullptr;
  }
  return Keep(role, std::move(*file));
}

}  // namespace

/// A file that needs no words. @param id_size of an exporter's id in the input area
GS_EXPORT const char* gs_motion_file(MotionRole* role, std::size_t id_size) {
  return FileOf(role, {reinterpret_cast<const char*>(Input().data()), id_size}, {});
}
/// The sprite sheet. Numbers outside of their ranges (shell/export/sprite_sheet.h) are moved to their ends.
/// @param size the longer side of a frame [px]
GS_EXPORT const char* gs_motion_sprites(MotionRole* role, int frames, int size) {
  using Sprites = shell::SpriteOptions;
  return FileOf(role, "sprites",
                {.frames = std::clamp(frames, Sprites::kLeastFrames, Sprites::kMostFrames),
                 .size = std::clamp(size, Sprites::kLeastSize, Sprites::kMostSize)});
}
