// SPDX-License-Identifier: MIT
// The palette's values and Dear ImGui's style.
#include "shell/widgets/theme.h"

#include <cmath>

#include "core/rollout/task.h"
#include "shell/export/picture_colours.h"

namespace gaitsmith::shell {
namespace {

constexpr ImU32 Rgb(unsigned hex) {
  return IM_COL32((hex >> 16) & 0xffu, (hex >> 8) & 0xffu, hex & 0xffu, 0xffu);
}

constexpr Palette kLight = {.paper = Rgb(0xfbfaf6),
                            .panel = Rgb(0xffffff),
                            .ink = Rgb(0x1d2733),
                            .second_ink = Rgb(0x5b6672),
                            .line = Rgb(0xe3dfd6),
                            .soft = Rgb(0xf2efe8),
                            .accent = Rgb(0x2f5fd0),
                            .accent_ink = Rgb(0xffffff),
                            .good = Rgb(0x23764c),
                            .bad = Rgb(0xb23a3a),
                            .strain = Rgb(0xd4500c),
                            .ground = IM_COL32(0xd9, 0xd2, 0xc3, 89)};

constexpr Palette kDark = {.paper = Rgb(0x14181d),
                           .panel = Rgb(0x1b2128),
                           .ink = Rgb(0xe8e6e1),
                           .second_ink = Rgb(0x98a2ad),
                           .line = Rgb(0x2b333c),
                           .soft = Rgb(0x232a32),
                           .accent = Rgb(0x7ea2ff),
                           .accent_ink = Rgb(0x0d1420),
                           .good = Rgb(0x63c796),
                           .bad = Rgb(0xf08a80),
                           .strain = Rgb(0xe85d10),
                           .ground = IM_COL32(0x33, 0x3c, 0x46, 89),
                           .dark = true,
                           .rules = 0.24f};

constexpr Palette kStrongLight = {.paper = Rgb(0xffffff),
                                  .panel = Rgb(0xffffff),
                                  .ink = Rgb(0x000000),
                                  .second_ink = Rgb(0x2b2b2b),
                                  .line = Rgb(0x767676),
                                  .soft = Rgb(0xe6e6e6),
                                  .accent = Rgb(0x0039b3),
                                  .accent_ink = Rgb(0xffffff),
                                  .good = Rgb(0x005c2e),
                                  .bad = Rgb(0x9b0000),
                                  .strain = Rgb(0xc25400),
                                  .ground = IM_COL32(0x00, 0x00, 0x00, 36),
                                  .rules = -0.2f};

constexpr Palette kStrongDark = {.paper = Rgb(0x000000),
                                 .panel = Rgb(0x000000),
                                 .ink = Rgb(0xffffff),
                                 .second_ink = Rgb(0xdcdcdc),
                                 .line = Rgb(0x8c8c8c),
                                 .soft = Rgb(0x2a2a2a),
                                 .accent = Rgb(0xffd83d),
                                 .accent_ink = Rgb(0x000000),
                                 .good = Rgb(0x6dff9f),
                                 .bad = Rgb(0xff9d92),
                                 .strain = Rgb(0xe06000),
                                 .ground = IM_COL32(0xff, 0xff, 0xff, 48),
                                 .dark = true,
                                 .rules = 0.24f};

ImVec4 Float(ImU32 colour) { return ImGui::ColorConvertU32ToFloat4(colour); }

}  // namespace

const Palette& PaletteOf(PaletteName name) {
  switch (name) {
    case PaletteName::kDark:
      return kDark;
    case PaletteName::kStrongLight:
      return kStrongLight;
    case PaletteName::kStrongDark:
      return kStrongDark;
    default:
      return kLight;
  }
}

ImU32 Palette::ScoreInk(float score) const { return score <= kVoidScore ? bad : score < 0.0f ? ink : good; }

ImU32 RuleColour(int rule, const Palette& p) {
  const ImU32 colour = Rgb(RuleColourHex(rule));
  if (p.rules == 0.0f) return colour;
  return Mix(colour, p.rules > 0.0f ? IM_COL32_WHITE : IM_COL32_BLACK, std::abs(p.rules));
}

ImU32 Mix(ImU32 from, ImU32 to, float share) {
  const ImVec4 a = Float(from);
  const ImVec4 b = Float(to);
  return ImGui::ColorConvertFloat4ToU32(
      {a.x + (b.x - a.x) * share, a.y + (b.y - a.y) * share, a.z + (b.z - a.z) * share, 1.0f});
}

ImU32 Fade(ImU32 colour, float opacity) {
  ImVec4 c = Float(colour);
  c.w *= opacity;
  return ImGui::ColorConvertFloat4ToU32(c);
}

float Theme::Snap(float points) const { return std::round(points * density) / density; }

void ApplyStyle(const Theme& theme) {
  const Palette& p = theme.palette;
  ImGuiStyle style;
  style.WindowPadding = {0.0f, 0.0f};
  style.WindowBorderSize = 0.0f;
  style.WindowRounding = 0.0f;
  style.ChildBorderSize = 0.0f;
  style.PopupRounding = 9.0f;
  style.PopupBorderSize = 1.0f;
  style.FramePadding = {9.0f, 6.0f};
  style.FrameRounding = kCornerRadius;
  style.ItemSpacing = {0.0f, 0.0f};
  style.ScrollbarSize = 10.0f;
  style.ScrollbarRounding = 5.0f;
  style.DisabledAlpha = 0.45f;
  // Finer than the default, since rods and rings are large smooth shapes.
  style.CircleTessellationMaxError = 0.12f / theme.density;
  style.CurveTessellationTol = 0.5f / theme.density;

  auto& colours = style.Colors;
  colours[ImGuiCol_Text] = Float(p.ink);
  colours[ImGuiCol_TextDisabled] = Float(p.second_ink);
  colours[ImGuiCol_WindowBg] = Float(p.panel);
  colours[ImGuiCol_ChildBg] = {0.0f, 0.0f, 0.0f, 0.0f};
  colours[ImGuiCol_PopupBg] = Float(p.panel);
  colours[ImGuiCol_Border] = Float(p.line);
  colours[ImGuiCol_FrameBg] = Float(p.panel);
  colours[ImGuiCol_ScrollbarBg] = {0.0f, 0.0f, 0.0f, 0.0f};
  colours[ImGuiCol_ScrollbarGrab] = Float(p.line);
  colours[ImGuiCol_ScrollbarGrabHovered] = Float(Mix(p.line, p.second_ink, 0.4f));
  colours[ImGuiCol_ScrollbarGrabActive] = Float(Mix(p.line, p.second_ink, 0.6f));
  colours[ImGuiCol_TextSelectedBg] = Float(Fade(p.accent, 0.3f));
  colours[ImGuiCol_NavHighlight] = {0.0f, 0.0f, 0.0f, 0.0f};  // our widgets draw their own focus ring
  ImGui::GetStyle() = style;
}

}  // namespace gaitsmith::shell
