// SPDX-License-Identifier: MIT
// The table of export formats for motions, which the command line, the page's engine, its Export dialog and
// the catalogue read. The page itself makes PNG pictures and films (web/share/export.js).
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/document/document.h"
#include "shell/export/film_strip.h"
#include "shell/export/sprite_sheet.h"

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

/// What an export may be asked for.
struct ExportOptions {
  FilmStripOptions strip = {};  // used only by film strips
  SpriteOptions sprites = {};   // used only by sprite sheets
  bool loops = false;           // the motion ends as it begins, and goes on without an end
  bool from_start = true;       // it begins as the document's start says, neither a loop nor planned
};

// Motions that other programs play. Lengths in pixels point downwards there, and angles turn clockwise. Their
// keys are only where they are needed (moving_bones.h). A slope is drawn level.
/// For web pages and papers: a picture that moves by CSS, follows the reader's theme, and stands still where
/// a reader wants less motion. 640 by 360 pixels.
[[nodiscard]] std::string AnimatedSvg(const Document&, const Motion&, const ExportOptions&);
/// For apps and pages, with the same view.
[[nodiscard]] std::string LottieJson(const Document&, const Motion&, const ExportOptions&);
/// A Skeleton2D with an AnimationPlayer, without ground, 100 pixels a metre; for Godot 4, or 3.
[[nodiscard]] std::string GodotScene(const Document&, const Motion&, const ExportOptions&);
[[nodiscard]] std::string Godot3Scene(const Document&, const Motion&, const ExportOptions&);
/// The figure, its joints, their servos and the ground for MuJoCo (MJCF). Keyframes are the start and the
/// poses of the motion; what moves the joints there is left to its reader.
[[nodiscard]] std::string MujocoModel(const Document&, const Motion&, const ExportOptions&);

/// The picture of AnimatedSvg in its light colours, without texts, as PNG: 25 frames a second.
[[nodiscard]] std::string AnimatedPng(const Document&, const Motion&, const ExportOptions&);
/// The figure's skeleton, animation and parts for DragonBones 5.5: a ZIP of two JSON files and a picture. 100
/// pixels a metre, without ground.
[[nodiscard]] std::string DragonBonesZip(const Document&, const Motion&, const ExportOptions&);
/// The figure in frames side by side: a ZIP of a PNG and a JSON as Aseprite writes it.
[[nodiscard]] std::string SpriteSheetZip(const Document&, const Motion&, const ExportOptions&);
/// The error of a sheet that would be too large.
[[nodiscard]] Result<void> SpritesFit(const Document&, const Motion&, const ExportOptions&);

/// The controller of a clip as JSON, for games that move the figure with their own physics. docs/runtime.md
/// explains it. @param clip an index of the timeline
[[nodiscard]] std::string ControllerJson(const Document& document, std::size_t clip = 0);

/// The error of a document without a controller.
[[nodiscard]] Result<void> HasController(const Document& document);

/// Marks a text of a row that the page translates, as TrLater does in rooms that may use words.
constexpr const char* PageText(const char* english) { return english; }

enum class ExportGroup { kPictures, kPrograms };  // where the Export dialog lists a format
inline constexpr std::array<std::string_view, 2> kExportGroupNames = {"pictures", "programs"};

struct ExporterRow {
  std::string_view id;      // the command line's option and the page's choice
  std::string_view ending;  // file name extension
  std::string_view type;    // MIME type
  ExportGroup group;
  const char* label;  // in the Export dialog, to be translated
  const char* note;   // below the label: what the file is good for, to be translated
  std::string (*make)(const Document&, const Motion&, const ExportOptions&);
  /// Why there is no such file; nullptr: there is one of each figure that it can show.
  Result<void> (*check)(const Document&, const Motion&, const ExportOptions&) = nullptr;
  bool springs = false;  // whether it can show figures of springs; if not, MakeFile refuses them
};

/// The content of an exported file, or why the document has none.
[[nodiscard]] inline Result<std::string> MakeFile(const ExporterRow& row, const Document& document,
                                                  const Motion& motion, const ExportOptions& options) {
  if (document.figure.HasSprings() && !row.springs)
    return Fail(ErrorCode::kStructure, "figure", "has springs, and this kind of file shows rods");
  if (row.check != nullptr) {
    const auto checked = row.check(document, motion, options);
    if (!checked) return std::unexpected(checked.error());
  }
  return row.make(document, motion, options);
}

/// In the order in which the command line lists and writes them. The first one is the page's usual choice.
inline constexpr auto kExporters = std::to_array<ExporterRow>({
    {"svg", "svg", "image/svg+xml", ExportGroup::kPictures, PageText("Poses, SVG"),
     PageText("For print: sharp at any size, and its parts can be edited"),
     [](const Document& document, const Motion& motion, const ExportOptions& options) {
       return FilmStripSvg(document, motion, options.strip);
     },
     nullptr, true},
    {"gltf", "gltf", "model/gltf+json", ExportGroup::kPrograms, PageText("Animation, glTF"),
     PageText("For Blender, Godot and other 3D programs"),
     [](const Document& document, const Motion& motion, const ExportOptions&) {
       return SkeletonGltf(document, motion);
     }},
    {"csv", "csv", "text/csv", ExportGroup::kPrograms, PageText("Numbers, CSV"),
     PageText("For spreadsheets and scripts: every step of the motion"),
     [](const Document& document, const Motion& motion, const ExportOptions&) {
       return TrajectoryCsv(document, motion);
     },
     nullptr, true},
    {"controller", "json", "application/json", ExportGroup::kPrograms, PageText("Controller, JSON"),
     PageText("For games: their own engine moves the figure, the controller decides"),
     [](const Document& document, const Motion&, const ExportOptions&) { return ControllerJson(document); },
     [](const Document& document, const Motion&, const ExportOptions&) { return HasController(document); },
     true},
    {"animated-svg", "svg", "image/svg+xml", ExportGroup::kPictures, PageText("Moving picture, SVG"),
     PageText("For web pages: small, sharp, in light and dark"), AnimatedSvg},
    {"lottie", "json", "application/json", ExportGroup::kPictures, PageText("Moving picture, Lottie"),
     PageText("For apps and web pages that play Lottie. Its colours can be set"), LottieJson},
    {"apng", "png", "image/apng", ExportGroup::kPictures, PageText("Moving picture, PNG"),
     PageText("For pages and papers that take no SVG: sharper than a GIF"), AnimatedPng, nullptr, true},
    {"sprites", "zip", "application/zip", ExportGroup::kPrograms, PageText("Sprite sheet, PNG"),
     PageText("For games without skeletons: frames side by side, and where they are"), SpriteSheetZip,
     SpritesFit, true},
    {"dragonbones", "zip", "application/zip", ExportGroup::kPrograms, PageText("Skeleton, DragonBones"),
     PageText("For games and animators: bones, parts and their animation"), DragonBonesZip},
    {"godot", "tscn", "text/plain", ExportGroup::kPrograms, PageText("Scene, Godot 4"),
     PageText("For games: a skeleton and its animation"), GodotScene},
    {"godot3", "tscn", "text/plain", ExportGroup::kPrograms, PageText("Scene, Godot 3"),
     PageText("The same for version 3"), Godot3Scene},
    {"mjcf", "xml", "application/xml", ExportGroup::kPrograms, PageText("Model, MuJoCo"),
     PageText("For research: body, joints, servos, ground and poses"), MujocoModel},
});

}  // namespace gaitsmith::shell
