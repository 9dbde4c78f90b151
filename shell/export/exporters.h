// SPDX-License-Identifier: MIT
// The one table of files that a motion becomes. The command line, the page's engine and the catalogue read
// it. The page makes pictures and films of these by itself (web/share/export.js).
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "shell/export/film_strip.h"
#include "shell/export/skeleton_gltf.h"
#include "shell/export/trajectory_csv.h"

namespace gaitsmith::shell {

struct ExporterRow {
  std::string_view id;      // of the command line's option and of the page's choice
  std::string_view ending;  // of the file's name
  std::string_view type;    // MIME type
  /// @param strip only film strips read it
  std::string (*make)(const Document&, const Motion&, const FilmStripOptions& strip);
};

/// In the order in which the command line names and writes them.
inline constexpr auto kExporters = std::to_array<ExporterRow>({
    {"svg", "svg", "image/svg+xml", FilmStripSvg},
    {"gltf", "gltf", "model/gltf+json",
     [](const Document& document, const Motion& motion, const FilmStripOptions&) {
       return SkeletonGltf(document, motion);
     }},
    {"csv", "csv", "text/csv",
     [](const Document& document, const Motion& motion, const FilmStripOptions&) {
       return TrajectoryCsv(document, motion);
     }},
});

}  // namespace gaitsmith::shell
