// SPDX-License-Identifier: MIT
// Copying limbs and mirroring, on figures whose endpoints can be compared.
#include "shell/panels/figure/figure_edit.h"

#include <catch_amalgamated.hpp>
#include <cmath>

#include "core/document/json.h"
#include "shell/embedded/embedded.h"

namespace gaitsmith::shell {

namespace {

/// Endpoints as drawn [m], the root's start at the origin.
std::vector<ImVec2> Drawn(const Figure& figure) {
  const Skeleton bones(figure);
  std::vector<ImVec2> points(static_cast<std::size_t>(bones.endpoints));
  std::vector<float> direction(static_cast<std::size_t>(bones.rods));
  for (std::size_t i = 0; i < direction.size(); ++i) {
    const Skeleton::Limb& limb = bones.limbs[i];
    direction[i] = limb.parent < 0 ? bones.start_angle_rad
                                   : direction[static_cast<std::size_t>(limb.parent)] + limb.rest_rad;
    const ImVec2 start = points[static_cast<std::size_t>(limb.start)];
    points[i + 1] = {start.x + limb.length_m * std::cos(direction[i]),
                     start.y + limb.length_m * std::sin(direction[i])};
  }
  return points;
}

std::vector<Figure> Shipped() {
  std::vector<Figure> figures;
  for (const Example& example : ExampleFigures()) {
    Figure figure = *DecodeFigureJson(example.json);
    if (!figure.HasSprings()) figures.push_back(std::move(figure));
  }
  return figures;
}

}  // namespace

TEST_CASE("mirroring reflects every endpoint, and mirroring twice restores the figure", "[figure_edit]") {
  for (const Figure& figure : Shipped()) {
    CAPTURE(figure.name);
    const Figure mirrored = Mirrored(figure);
    REQUIRE(Validate(mirrored));
    const auto before = Drawn(figure);
    const auto after = Drawn(mirrored);
    for (std::size_t k = 0; k < before.size(); ++k) {
      REQUIRE(std::abs(after[k].x + before[k].x) < 1e-4f);
      REQUIRE(std::abs(after[k].y - before[k].y) < 1e-4f);
    }
    const Figure back = Mirrored(mirrored);
    for (std::size_t i = 0; i < figure.rods.size(); ++i) {
      REQUIRE(std::abs(std::remainder(back.rods[i].rest_rad - figure.rods[i].rest_rad, 6.2831853f)) < 1e-5f);
      REQUIRE(back.rods[i].min_rad == figure.rods[i].min_rad);
      REQUIRE(back.rods[i].max_rad == figure.rods[i].max_rad);
    }
  }
}

TEST_CASE("turning a rod also turns everything attached, and changes nothing else", "[figure_edit]") {
  for (const Figure& figure : Shipped()) {
    CAPTURE(figure.name);
    const Skeleton bones(figure);
    const auto before = Drawn(figure);
    const int limb = bones.rods - 1;
    const auto i = static_cast<std::size_t>(limb);
    const Figure turned = WithLimbTurned({.figure = figure, .skeleton = bones, .points = before}, limb, 0.5f);
    REQUIRE(Validate(turned));
    const auto after = Drawn(turned);
    const ImVec2 start = after[static_cast<std::size_t>(bones.limbs[i].start)];
    // Drawn angles are rounded to half a degree.
    REQUIRE(std::abs(std::atan2(after[i + 1].y - start.y, after[i + 1].x - start.x) - 0.5f) < 0.005f);
    for (std::size_t k = 0; k + 1 < before.size(); ++k) {
      REQUIRE(std::abs(after[k].x - before[k].x) < 1e-5f);
      REQUIRE(std::abs(after[k].y - before[k].y) < 1e-5f);
    }
    for (std::size_t k = 0; k < figure.rods.size(); ++k)
      REQUIRE(turned.rods[k].length_m == figure.rods[k].length_m);
  }
}

TEST_CASE("a snapped rod has multiples of 15 degrees and of 5 cm, at least 5 cm", "[figure_edit]") {
  const ImVec2 from{0.3f, -0.2f};
  for (int k = 0; k < 200; ++k) {
    const float x = 0.013f * static_cast<float>(k) - 1.3f;
    const ImVec2 to = Snapped(from, {from.x + x, from.y + 0.7f * x * x - 0.4f});
    const float length = std::hypot(to.x - from.x, to.y - from.y) / 0.05f;
    const float angle = std::atan2(to.y - from.y, to.x - from.x) / (3.14159265f / 12.0f);
    REQUIRE(length > 0.99f);
    REQUIRE(std::abs(length - std::round(length)) < 1e-3f);
    REQUIRE(std::abs(angle - std::round(angle)) < 1e-3f);
  }
}

TEST_CASE("a figure grows from one rod", "[figure_edit]") {
  Figure figure = SingleRod();
  REQUIRE(Validate(figure));
  for (int rods = 2; rods <= 4; ++rods) {
    const Skeleton bones(figure);
    const auto points = Drawn(figure);
    figure = WithRodFrom({.figure = figure, .skeleton = bones, .points = points}, 1,
                         {points[1].x + 0.3f * static_cast<float>(rods), points[1].y - 0.5f});
    REQUIRE(Validate(figure));
    REQUIRE(figure.Rods() == rods);
  }
}

TEST_CASE("a rod added by button ends where no other rod ends, and has the parent's length",
          "[figure_edit]") {
  for (const Figure& figure : Shipped()) {
    if (figure.Rods() == kMaxRods) continue;
    CAPTURE(figure.name);
    for (int rod = 0; rod < figure.Rods(); ++rod) {
      const Figure grown = WithRodGrown(figure, rod);
      REQUIRE(Validate(grown));
      REQUIRE(grown.Rods() == figure.Rods() + 1);
      REQUIRE(std::abs(grown.rods.back().length_m - figure.rods[static_cast<std::size_t>(rod)].length_m) <
              0.006f);
      const Skeleton bones(grown);
      const auto points = Drawn(grown);
      std::size_t tip = 0;
      while (bones.limbs[tip].drawn != figure.Rods()) ++tip;
      for (std::size_t k = 0; k < points.size(); ++k) {
        if (k == tip + 1) continue;
        REQUIRE(std::hypot(points[k].x - points[tip + 1].x, points[k].y - points[tip + 1].y) >
                0.15f * grown.rods.back().length_m);
      }
    }
  }
}

TEST_CASE("a copied limb has the same rods and lengths, in a free direction", "[figure_edit]") {
  for (const Figure& figure : Shipped()) {
    for (int rod = 0; rod < figure.Rods(); ++rod) {
      if (figure.rods[static_cast<std::size_t>(rod)].parent == kNoParent) continue;
      CAPTURE(figure.name, rod);
      const int limb = figure.Rods() - WithoutRod(figure, rod).Rods();
      const Figure grown = WithLimbCopied(figure, rod);
      REQUIRE(grown.Rods() == figure.Rods() + limb);
      if (grown.Rods() <= kMaxRods) REQUIRE(Validate(grown));
      // Removing the rod restores the figure.
      const Figure back = WithoutRod(grown, figure.Rods());
      REQUIRE(back.Rods() <= figure.Rods() + limb - 1);
      for (int i = 0; i < figure.Rods(); ++i) {
        REQUIRE(back.rods[static_cast<std::size_t>(i)].rest_rad ==
                figure.rods[static_cast<std::size_t>(i)].rest_rad);
      }
      float lengths = 0.0f;
      for (const Rod& one : figure.rods) lengths += one.length_m;
      float without = 0.0f;
      for (const Rod& one : WithoutRod(figure, rod).rods) without += one.length_m;
      float grown_lengths = 0.0f;
      for (const Rod& one : grown.rods) grown_lengths += one.length_m;
      REQUIRE(std::abs(grown_lengths - (2.0f * lengths - without)) < 1e-3f);
    }
  }
}

}  // namespace gaitsmith::shell
