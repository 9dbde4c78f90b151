// SPDX-License-Identifier: MIT
// The outlines of the shipped figures.
#include "shell/body/body_parts.h"

#include <catch_amalgamated.hpp>
#include <cmath>
#include <filesystem>

#include "tests/scene.h"
#include "tests/spring_scene.h"

namespace gaitsmith::shell {

TEST_CASE("body: every rod is covered, and the number of parts does not depend on the pose",
          "[shell][body]") {
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(GAITSMITH_SOURCE_DIR) + "/examples/figures")) {
    const Figure figure = gaitsmith::test::ShippedFigure(entry.path().stem().string());
    CAPTURE(figure.name);
    const Skeleton bones(figure);
    const FigureLook look = LookOf(figure);
    const std::vector<BodyPoint> rest = DrawnEndpoints(figure);
    const std::vector<BodyPart> parts = BodyPartsOf(look, rest);
    for (const BodyPoint& point : rest) {
      bool covered = false;
      for (const BodyPart& part : parts) {
        covered |= std::hypot(point.x - part.from.x, point.y - part.from.y) < part.from_m + 0.06f ||
                   std::hypot(point.x - part.to.x, point.y - part.to.y) < part.to_m + 0.06f;
      }
      CHECK(covered);
    }
    CHECK(EyeOf(look, rest).has_value() == (look.head_rod >= 0));
    if (figure.HasSprings()) continue;
    const std::vector<float> bent(static_cast<std::size_t>(bones.rods - 1), 0.3f);
    CHECK(BodyPartsOf(look, DrawnEndpoints(bones, bent)).size() == parts.size());
  }
}

TEST_CASE("body: far limbs come first, and an eye lies in the head", "[shell][body]") {
  const Figure figure = gaitsmith::test::ShippedFigure("ostrich");
  const Skeleton bones(figure);
  const FigureLook look = LookOf(figure);
  const std::vector<BodyPoint> rest = DrawnEndpoints(bones, {});
  const std::vector<BodyPart> parts = BodyPartsOf(look, rest);
  REQUIRE(parts.size() > 4);
  CHECK(parts[0].far);
  CHECK_FALSE(parts.back().far);
  const auto eye = EyeOf(look, rest);
  REQUIRE(eye.has_value());
  CHECK(std::hypot(eye->at.x - rest[5].x, eye->at.y - rest[5].y) < 0.3f);
}

TEST_CASE("body: muscles swell as they shorten, above springs and below nodes", "[shell][body][springs]") {
  const Figure figure = Box();
  const FigureLook look = LookOf(figure);
  std::vector<BodyPoint> nodes = DrawnEndpoints(figure);
  const auto parts = BodyPartsOf(look, nodes);
  REQUIRE(parts.size() == figure.springs.size() + figure.nodes.size());
  // Four springs, paler, two muscles, four nodes.
  for (std::size_t i = 0; i < parts.size(); ++i) {
    CHECK(parts[i].far == (i < 4));
    CHECK((parts[i].belly_m > 0.0f) == (i == 4 || i == 5));
  }
  const float drawn_belly = parts[4].belly_m;
  for (BodyPoint& node : nodes) node = {0.5f * node.x, node.y};
  const auto squeezed = BodyPartsOf(look, nodes);
  CHECK(squeezed[4].belly_m == Catch::Approx(2.0f * drawn_belly));
  CHECK(squeezed[0].from_m == parts[0].from_m);
  // However short a muscle becomes, it does not cover the picture.
  for (BodyPoint& node : nodes) node = {};
  CHECK(BodyPartsOf(look, nodes)[4].belly_m <= 3.0f * drawn_belly + 1e-6f);
  CHECK_FALSE(EyeOf(look, nodes));
  CHECK(look.sole_m > 0.0f);
}

}  // namespace gaitsmith::shell
