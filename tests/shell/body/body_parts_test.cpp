// SPDX-License-Identifier: MIT
// The outlines of the shipped figures.
#include "shell/body/body_parts.h"

#include <catch_amalgamated.hpp>
#include <cmath>
#include <filesystem>

#include "tests/scene.h"

namespace gaitsmith::shell {

TEST_CASE("body: every rod is covered, and the number of parts does not depend on the pose",
          "[shell][body]") {
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(GAITSMITH_SOURCE_DIR) + "/examples/figures")) {
    const Figure figure = gaitsmith::test::ShippedFigure(entry.path().stem().string());
    CAPTURE(figure.name);
    const Skeleton bones(figure);
    const FigureLook look = LookOf(figure.name, bones);
    const std::vector<BodyPoint> rest = DrawnEndpoints(bones, {});
    const std::vector<BodyPart> parts = BodyPartsOf(bones, look, rest);
    for (const BodyPoint& point : rest) {
      bool covered = false;
      for (const BodyPart& part : parts) {
        covered |= std::hypot(point.x - part.from.x, point.y - part.from.y) < part.from_m + 0.06f ||
                   std::hypot(point.x - part.to.x, point.y - part.to.y) < part.to_m + 0.06f;
      }
      CHECK(covered);
    }
    const std::vector<float> bent(static_cast<std::size_t>(bones.rods - 1), 0.3f);
    CHECK(BodyPartsOf(bones, look, DrawnEndpoints(bones, bent)).size() == parts.size());
    CHECK(EyeOf(bones, look, rest).has_value() == (look.head_rod >= 0));
  }
}

TEST_CASE("body: far limbs come first, and an eye lies in the head", "[shell][body]") {
  const Figure figure = gaitsmith::test::ShippedFigure("ostrich");
  const Skeleton bones(figure);
  const FigureLook look = LookOf(figure.name, bones);
  const std::vector<BodyPoint> rest = DrawnEndpoints(bones, {});
  const std::vector<BodyPart> parts = BodyPartsOf(bones, look, rest);
  REQUIRE(parts.size() > 4);
  CHECK(parts[0].far);
  CHECK_FALSE(parts.back().far);
  const auto eye = EyeOf(bones, look, rest);
  REQUIRE(eye.has_value());
  CHECK(std::hypot(eye->at.x - rest[5].x, eye->at.y - rest[5].y) < 0.3f);
}

}  // namespace gaitsmith::shell
