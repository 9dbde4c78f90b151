// SPDX-License-Identifier: MIT
// The table of export formats for motions, which the command line, the page's engine and the catalogue read.
// The page itself makes pictures and films from the exported files (web/share/export.js).
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "shell/export/film_strip.h"
#include "shell/export/skeleton_gltf.h"
#include "shell/export/trajectory_csv.h"

namespace gaitsmith::shell {

struct ExporterRow {
  std::string_view id;      // the command line's option and the page's choice
  std::string_view ending;  // file name extension
  std::string_view type;    // MIME type
  /// @param strip used only by film strips
  std::string (*make)(const Document&, const Motion&, const FilmStripOptions& strip);
};

/// In the order in which the command line lists and writes them.
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
