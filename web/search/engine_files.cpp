// SPDX-License-Identifier: MIT
// Files made of a motion, behind the engine's border. The small engine goes without them.
#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

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
  return OpenMotion(std::move(*document), std::move(*motion));
}
// Exported files, gs_motion_text_size() bytes.
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
/// A file that needs no words. @param id_size of an exporter's id in the input area
GS_EXPORT const char* gs_motion_file(MotionRole* role, std::size_t id_size) {
  const std::string_view id(reinterpret_cast<const char*>(Input().data()), id_size);
  const auto row = std::ranges::find(shell::kExporters, id, &shell::ExporterRow::id);
  if (row == shell::kExporters.end()) {
    Note({ErrorCode::kUnknownName, "", "there is no such export"});
    return nullptr;
  }
  auto file = shell::MakeFile(*row, role->document, role->motion, {});
  if (!file) {
    Note(file.error());
    return nullptr;
  }
  return Keep(role, std::move(*file));
}
