// SPDX-License-Identifier: MIT
// Text in Inter, rasterised for the device's pixel ratio. Baselines are aligned to device pixels, so that
// letters are sharp at any pixel ratio and browser zoom.
#pragma once

#include <imgui.h>

#include <array>
#include <string_view>

namespace gaitsmith::shell {

enum class Type {
  kSmall,    // 11 px: ruler, ticks
  kNote,     // 12 px: captions
  kBody,     // 13 px
  kStrong,   // 13 px semibold
  kHeading,  // 15 px semibold
  kLarge,    // 22 px semibold: the stage's button
  kTitle,    // 30 px semibold: the stage's headline and number
};
inline constexpr int kTypes = 7;

enum class Align { kLeft, kCentre, kRight };

class Fonts {
 public:
  /// Rasterises all sizes into Dear ImGui's atlas. The caller must then recreate the renderer's texture.
  /// @param density device pixels per point, > 0
  void Build(float density);

  /// Width of one line [points].
  [[nodiscard]] float Width(Type, std::string_view text) const;

  /// Draws one line with its capitals vertically centred on y.
  void Draw(ImDrawList*, Type, ImVec2 position, ImU32 colour, std::string_view text,
            Align = Align::kLeft) const;

  /// Draws one line, shortened with an ellipsis to this width.
  void DrawElided(ImDrawList*, Type, ImVec2 position, float width, ImU32 colour, std::string_view text) const;

  /// The number of bytes of `text` that fit into this width, broken between words; 0 only for empty text.
  [[nodiscard]] std::size_t FitLine(Type, std::string_view text, float width) const;

  /// Distance between the lines of a paragraph [points].
  [[nodiscard]] static float LineHeight(Type);

  [[nodiscard]] ImFont* Raw(Type type) const { return fonts_[static_cast<std::size_t>(type)]; }

 private:
  std::array<ImFont*, kTypes> fonts_{};
  float density_ = 1.0f;
};

}  // namespace gaitsmith::shell
