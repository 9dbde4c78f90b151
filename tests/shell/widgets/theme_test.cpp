// SPDX-License-Identifier: MIT
// Themes have the documented contrast, as defined by WCAG 2.1.
#include "shell/widgets/theme.h"

#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>

#include "core/rollout/task.h"

namespace gaitsmith::shell {
namespace {

double Luminance(ImU32 colour) {
  const auto linear = [](ImU32 byte) {
    const double c = static_cast<double>(byte & 0xffu) / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(colour >> IM_COL32_R_SHIFT) + 0.7152 * linear(colour >> IM_COL32_G_SHIFT) +
         0.0722 * linear(colour >> IM_COL32_B_SHIFT);
}

double Contrast(ImU32 a, ImU32 b) {
  const auto [darker, lighter] = std::minmax({Luminance(a), Luminance(b)});
  return (lighter + 0.05) / (darker + 0.05);
}

double LeastOfText(const Palette& p) {
  double least = Contrast(p.accent_ink, p.accent);
  for (const ImU32 behind : {p.paper, p.panel, p.soft}) {
    for (const ImU32 text : {p.ink, p.second_ink}) least = std::min(least, Contrast(text, behind));
  }
  for (const ImU32 text : {p.accent, p.good, p.bad}) least = std::min(least, Contrast(text, p.panel));
  return least;
}

}  // namespace

TEST_CASE("Black on white has a contrast of 21 to 1") {
  REQUIRE(std::abs(Contrast(IM_COL32_BLACK, IM_COL32_WHITE) - 21.0) < 1e-9);
}

TEST_CASE("Text is readable in every theme, with stronger contrast in the strong themes") {
  REQUIRE(LeastOfText(PaletteOf(PaletteName::kLight)) >= 4.0);
  REQUIRE(LeastOfText(PaletteOf(PaletteName::kDark)) >= 4.5);
  for (const PaletteName name : {PaletteName::kStrongLight, PaletteName::kStrongDark}) {
    const Palette& p = PaletteOf(name);
    REQUIRE(LeastOfText(p) >= 7.0);
    for (const ImU32 behind : {p.paper, p.panel}) REQUIRE(Contrast(p.line, behind) >= 4.5);
    REQUIRE(Contrast(p.line, p.soft) >= 3.0);
  }
}

TEST_CASE("theme: a limb at its limit stands out from the stage and from other limbs") {
  for (const PaletteName name :
       {PaletteName::kLight, PaletteName::kDark, PaletteName::kStrongLight, PaletteName::kStrongDark}) {
    const Palette& p = PaletteOf(name);
    CHECK(Contrast(p.strain, p.paper) >= 3.0);
    CHECK(Contrast(p.strain, p.ink) >= 2.0);
  }
}

TEST_CASE("theme: lines in the colours of rules can be seen, best in the strong themes") {
  const auto least = [](PaletteName name) {
    const Palette& p = PaletteOf(name);
    double contrast = 21.0;
    for (int rule = 0; rule < 10; ++rule)
      contrast = std::min(contrast, Contrast(RuleColour(rule, p), p.panel));
    return contrast;
  };
  CHECK(least(PaletteName::kLight) >= 2.2);
  for (const PaletteName name : {PaletteName::kDark, PaletteName::kStrongLight, PaletteName::kStrongDark})
    CHECK(least(name) >= 3.0);
}

TEST_CASE("theme: only good scores are green") {
  const Palette& p = PaletteOf(PaletteName::kLight);
  CHECK(p.ScoreInk(0.0f) == p.good);
  CHECK(p.ScoreInk(-0.01f) == p.ink);
  CHECK(p.ScoreInk(kVoidScore) == p.bad);
}

}  // namespace gaitsmith::shell
