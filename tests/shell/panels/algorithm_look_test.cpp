// SPDX-License-Identifier: MIT
// The Lab draws no two algorithms alike, also for people who see fewer colours.
#include "shell/panels/lab/algorithm_look.h"

#include <algorithm>
#include <array>
#include <catch_amalgamated.hpp>
#include <cmath>
#include <limits>

#include "shell/export/picture_colours.h"
#include "shell/widgets/theme.h"

namespace gaitsmith::shell {
namespace {

using Triple = std::array<double, 3>;
using Sight = std::array<Triple, 3>;

/// What people see of linear RGB: all of it, and without one kind of cone [Machado 2009].
constexpr std::array<Sight, 4> kSights = {{
    {{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}},
    {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}},
    {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}},
    {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}},
}};

Triple Times(const Sight& matrix, const Triple& vector) {
  Triple product{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) product[i] += matrix[i][j] * vector[j];
  }
  return product;
}

/// CIE Lab of a colour in one kind of sight.
Triple LabOf(ImU32 colour, const Sight& sight) {
  Triple linear{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double c = static_cast<double>((colour >> (IM_COL32_R_SHIFT + 8 * i)) & 0xffu) / 255.0;
    linear[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }
  linear = Times(sight, linear);
  for (double& one : linear) one = std::clamp(one, 0.0, 1.0);
  constexpr Sight kXyz = {{{0.4124564, 0.3575761, 0.1804375},
                           {0.2126729, 0.7151522, 0.0721750},
                           {0.0193339, 0.1191920, 0.9503041}}};
  constexpr Triple kWhite = {0.95047, 1.0, 1.08883};
  Triple xyz = Times(kXyz, linear);
  for (std::size_t i = 0; i < 3; ++i) {
    const double share = xyz[i] / kWhite[i];
    xyz[i] = share > 216.0 / 24389.0 ? std::cbrt(share) : (24389.0 / 27.0 * share + 16.0) / 116.0;
  }
  return {116.0 * xyz[1] - 16.0, 500.0 * (xyz[0] - xyz[1]), 200.0 * (xyz[1] - xyz[2])};
}

/// The least distance in CIE Lab, over all kinds of sight, between two algorithms that are both solid or both
/// dashed.
double LeastDistance(PaletteName name) {
  const Palette& palette = PaletteOf(name);
  double least = std::numeric_limits<double>::infinity();
  for (const Sight& sight : kSights) {
    for (std::size_t i = 0; i < kAlgorithmLooks.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const AlgorithmLook &a = kAlgorithmLooks[i], &b = kAlgorithmLooks[j];
        if (a.dashed != b.dashed) continue;
        const Triple one = LabOf(RuleColour(a.hue, palette), sight);
        const Triple other = LabOf(RuleColour(b.hue, palette), sight);
        least = std::min(least, std::hypot(one[0] - other[0], one[1] - other[1], one[2] - other[2]));
      }
    }
  }
  return least;
}

}  // namespace

TEST_CASE("algorithm look: each has its own, and the first ten are solid", "[shell][lab]") {
  CHECK(kAlgorithmHues == static_cast<int>(kRuleColours.size()));
  for (std::size_t i = 0; i < kAlgorithmLooks.size(); ++i) {
    const AlgorithmLook& look = kAlgorithmLooks[i];
    CHECK(look == LookOf(static_cast<Algorithm>(i)));
    CHECK(std::ranges::count(kAlgorithmLooks, look) == 1);
    CHECK(look.dashed == (i >= kRuleColours.size()));
  }
}

TEST_CASE("algorithm look: hues differ also for people who see fewer colours", "[shell][lab]") {
  CHECK(LeastDistance(PaletteName::kLight) >= 22.0);
  CHECK(LeastDistance(PaletteName::kStrongLight) >= 18.0);
  for (const PaletteName dark : {PaletteName::kDark, PaletteName::kStrongDark})
    CHECK(LeastDistance(dark) >= 14.0);
}

}  // namespace gaitsmith::shell
