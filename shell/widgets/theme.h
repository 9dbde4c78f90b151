// SPDX-License-Identifier: MIT
// Appearance: colours of the themes, the ten rule colours, sizes, and a matching style for Dear ImGui.
#pragma once

#include <imgui.h>

#include <array>
#include <string_view>

#include "shell/widgets/fonts.h"

namespace gaitsmith::shell {

struct Palette {
  ImU32 paper;       // the stage
  ImU32 panel;       // everything that is not the stage
  ImU32 ink;         // text, figures
  ImU32 second_ink;  // captions, ruler
  ImU32 line;        // one-pixel borders
  ImU32 soft;        // fills of tracks and wells
  ImU32 accent;
  ImU32 accent_ink;  // text on the accent
  ImU32 good;
  ImU32 bad;
  ImU32 strain;  // of a limb whose joint gives all that it can
  ImU32 ground;  // overlay on the paper below the ground line
  bool dark = false;
  float rules = 0.0f;  // all rule colours are mixed with so much white or, if negative, black

  /// For a score as text: only good scores are green, not negative or void ones.
  [[nodiscard]] ImU32 ScoreInk(float score) const;
};

/// The strong palettes, for projectors and low vision, have a contrast of at least 7 : 1 for text and 4.5 : 1
/// for lines against their background.
enum class PaletteName { kLight, kDark, kStrongLight, kStrongDark };
inline constexpr std::array<std::string_view, 4> kPaletteNames = {"light", "dark", "strong-light",
                                                                  "strong-dark"};
[[nodiscard]] const Palette& PaletteOf(PaletteName);

/// Colour of a rule or controller, counted from 0. Repeats after ten. Any two differ by at least 22 in CIE
/// Lab for protanopes, deuteranopes and tritanopes [Machado 2009] in the light theme, and by at least 14 in
/// any.
[[nodiscard]] ImU32 RuleColour(int rule, const Palette&);

/// Blends `from` and `to` linearly, share of `to` in [0, 1]; opaque.
[[nodiscard]] ImU32 Mix(ImU32 from, ImU32 to, float share);
/// The same colour, at this opacity in [0, 1].
[[nodiscard]] ImU32 Fade(ImU32 colour, float opacity);

/// The appearance of all widgets. One per window, updated in place.
struct Theme {
  Palette palette = PaletteOf(PaletteName::kLight);
  Fonts fonts;
  bool touch = false;    // touch screen: most targets are 44 px high
  float density = 1.0f;  // device pixels per point

  [[nodiscard]] ImU32 Rule(int rule) const { return RuleColour(rule, palette); }
  /// Height of buttons, fields and sliders' hit areas [points].
  [[nodiscard]] float ControlHeight() const { return touch ? 44.0f : 30.0f; }
  /// Height of the buttons that start something [points].
  [[nodiscard]] float MainHeight() const { return touch ? 46.0f : 38.0f; }
  /// Rounds a coordinate to a device pixel, so that one-pixel lines stay one pixel wide.
  [[nodiscard]] float Snap(float points) const;
};

inline constexpr float kTransportHeight = 46.0f, kTouchTransportHeight = 50.0f;
inline constexpr float kTimelineHeight = 118.0f;
inline constexpr float kPanelWidth = 348.0f;
inline constexpr float kTabHeight = 39.0f, kTouchTabHeight = 46.0f;
inline constexpr float kPanelPadding = 14.0f;
inline constexpr float kPhoneWidth = 700.0f;  // narrower canvases get the phone's layout
inline constexpr float kWideCanvas = 1000.0f;
inline constexpr float kTallHeight = 490.0f;  // with room for stage, playback and dock
inline constexpr float kLowHeight = 440.0f;   // lower canvases have no room for the timeline below the stage
inline constexpr float kCornerRadius = 7.0f;
inline constexpr float kKnobRadius = 7.0f;  // of sliders

/// Sets colours and sizes of the few parts that Dear ImGui draws itself (scroll bars, pop-ups, text fields).
void ApplyStyle(const Theme&);

}  // namespace gaitsmith::shell
