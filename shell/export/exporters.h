// SPDX-License-Identifier: MIT
// The table of export formats for motions, which the command line, the page's engine, its Export dialog and
// the catalogue read. The page itself makes PNG pictures and films (web/share/export.js).
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/document/document.h"
#include "shell/export/film_strip.h"

namespace gaitsmith::shell {

/// A motion as a glTF 2.0 scene: rods as nodes, turned by an animation. Blender and Godot open it. Metres, y
/// upwards. The ground is the plane y = 0, tilted with the slope but without its sway. Node 0 is the scene.
/// The others are the rods in walking order, each along its own x from its start. A drawn ground is the last
/// node, a strip 2 m wide.
/// @param motion of the document
[[nodiscard]] std::string SkeletonGltf(const Document& document, const Motion& motion);

/// A motion as CSV: one row per step, including the start. docs/command-line.md documents the columns.
/// @param motion of the document
[[nodiscard]] std::string TrajectoryCsv(const Document& document, const Motion& motion);

/// The controller of a clip as JSON, for games that move the figure with their own physics. docs/runtime.md
/// explains it. @param clip an index of the timeline
[[nodiscard]] std::string ControllerJson(const Document& document, std::size_t clip = 0);

/// The error of a document without a controller.
[[nodiscard]] Result<void> HasController(const Document& document);

/// Marks a text of a row that the page translates, as TrLater does in rooms that may use words.
constexpr const char* PageText(const char* english) { return english; }

struct ExporterRow {
  std::string_view id;      // the command line's option and the page's choice
  std::string_view ending;  // file name extension
  std::string_view type;    // MIME type
  const char* label;        // in the Export dialog, to be translated
  const char* note;         // below the label: what the file is good for, to be translated
  /// @param strip used only by film strips
  std::string (*make)(const Document&, const Motion&, const FilmStripOptions& strip);
  /// What the document lacks for this file; nullptr: no document lacks it.
  Result<void> (*check)(const Document&) = nullptr;
};

/// The content of an exported file, or why the document has none.
[[nodiscard]] inline Result<std::string> MakeFile(const ExporterRow& row, const Document& document,
                                                  const Motion& motion, const FilmStripOptions& strip) {
  if (row.check != nullptr) {
    const auto checked = row.check(document);
    if (!checked) return std::unexpected(checked.error());
  }
  return row.make(document, motion, strip);
}

/// In the order in which the command line lists and writes them. The first one is the page's usual choice.
inline constexpr auto kExporters = std::to_array<ExporterRow>({
    {"svg", "svg", "image/svg+xml", PageText("Poses, SVG"),
     PageText("For print: sharp at any size, and its parts can be edited"), FilmStripSvg},
    {"gltf", "gltf", "model/gltf+json", PageText("Animation, glTF"),
     PageText("For Blender, Godot and other 3D programs"),
     [](const Document& document, const Motion& motion, const FilmStripOptions&) {
       return SkeletonGltf(document, motion);
     }},
    {"csv", "csv", "text/csv", PageText("Numbers, CSV"),
     PageText("For spreadsheets and scripts: every step of the motion"),
     [](const Document& document, const Motion& motion, const FilmStripOptions&) {
       return TrajectoryCsv(document, motion);
     }},
    {"controller", "json", "application/json", PageText("Controller, JSON"),
     PageText("For games: their own engine moves the figure, the controller decides"),
     [](const Document& document, const Motion&, const FilmStripOptions&) {
       return ControllerJson(document);
     },
     HasController},
});

}  // namespace gaitsmith::shell
