// SPDX-License-Identifier: MIT
// What pictures and scenes that move are made of: keys and shapes. tests/web follows the rods in the files
// themselves.
#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>
#include <regex>

#include "core/document/json.h"
#include "core/numeric/random.h"
#include "shell/body/body_parts.h"
#include "shell/export/bone_shapes.h"
#include "shell/export/exporters.h"
#include "shell/export/moving_bones.h"
#include "shell/export/moving_picture.h"
#include "tests/scene.h"

namespace gaitsmith::shell::test {
namespace {

using Values = std::vector<std::array<double, 2>>;

/// How far a track is from the values at most.
double ErrorOf(const Track& track, const Values& values) {
  double worst = 0.0;
  for (std::size_t i = 0; i + 1 < track.frames.size(); ++i) {
    const int first = track.frames[i], last = track.frames[i + 1];
    for (int frame = first; frame <= last; ++frame) {
      const double share = static_cast<double>(frame - first) / (last - first);
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const double at = track.values[i][axis] + share * (track.values[i + 1][axis] - track.values[i][axis]);
        worst = std::max(worst, std::abs(at - values[static_cast<std::size_t>(frame)][axis]));
      }
    }
  }
  return worst;
}

TEST_CASE("moving pictures: keys are as exact as they are asked to be, and no more than needed") {
  RandomStream random(7, 0, 1);
  for (int trial = 0; trial < 200; ++trial) {
    const int frames = 1 + static_cast<int>(random.Below(300));
    Values values;
    std::array<double, 2> at{};
    for (int frame = 0; frame < frames; ++frame) {
      for (double& value : at) value += 0.01 * (static_cast<double>(random.Below(2001)) - 1000.0);
      values.push_back(at);
    }
    for (const double tolerance : {0.0, 0.5, 20.0, 1e9}) {
      const Track track = KeysOf(values, tolerance);
      REQUIRE(track.frames.size() == track.values.size());
      CHECK(track.frames.front() == 0);
      CHECK(track.frames.back() == frames - 1);
      CHECK(ErrorOf(track, values) <= tolerance + 1e-9);
      if (tolerance > 1e6) CHECK(track.frames.size() == std::min<std::size_t>(2, values.size()));
      if (tolerance == 0.0) CHECK(track.frames.size() <= values.size());
    }
    CHECK(KeysOf(values, 20.0).frames.size() <= KeysOf(values, 0.5).frames.size());
  }
  // A line has two keys, a corner one more.
  Values bent;
  for (int frame = 0; frame <= 100; ++frame) bent.push_back({std::abs(frame - 40.0), 3.0 * frame});
  CHECK(KeysOf(bent, 1e-6).frames == std::vector{0, 40, 100});
}

TEST_CASE("moving pictures: a figure's shapes are convex, and cover the rods that they move with") {
  for (std::uint64_t seed = 0; seed <= 30; ++seed) {
    const Figure figure =
        seed == 0 ? DecodeJson(gaitsmith::test::ReadFile("examples/beryl-wind-up.json")).value().figure
                  : gaitsmith::test::RandomFigure(seed);
    const Skeleton bones(figure);
    const auto shapes = BoneShapesOf(figure);
    std::vector<bool> covered(static_cast<std::size_t>(bones.rods), false);
    for (const BoneShape& shape : shapes) {
      const auto& line = shape.outline_m;
      REQUIRE(line.size() >= 3);
      double area = 0.0, most = -1e9;
      for (std::size_t i = 0; i < line.size(); ++i) {
        const auto &a = line[i], &b = line[(i + 1) % line.size()], &c = line[(i + 2) % line.size()];
        CHECK((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0.0);
        area += 0.5 * (a[0] * b[1] - b[0] * a[1]);
        most = std::max(most, a[0]);
      }
      CHECK(area > 0.0);
      const auto bone = static_cast<std::size_t>(shape.bone);
      if (most >= static_cast<double>(bones.limbs[bone].length_m)) covered[bone] = true;
    }
    CHECK(std::ranges::count(covered, false) == 0);
    // In the order of drawing of the stage.
    const FigureLook look = LookOf(figure);
    const auto parts = BodyPartsOf(look, DrawnEndpoints(bones, {}));
    const std::size_t eyes = look.head_rod >= 0 ? 1 : 0;
    REQUIRE(shapes.size() == parts.size() + eyes);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      CHECK(shapes[i].bone == parts[i].rod);
      CHECK((shapes[i].colour == &kFarColour) == parts[i].far);
    }
  }
}

TEST_CASE("moving pictures: the view of a loop moves evenly, and its marks fit into its way") {
  const Document document = DecodeJson(gaitsmith::test::ReadFile("examples/star-man-shuffle.json")).value();
  const Motion motion = Simulate(document);
  const MovingPicture whole(document, motion, false), loop(document, motion, true);
  CHECK(loop.GroundKeys().frames.size() == 2);
  CHECK(whole.GroundKeys().frames.size() > 2);
  const auto marks = loop.Marks();
  REQUIRE(marks.size() > 3);
  const double tick = marks[1].x - marks[0].x;
  const Track ground = loop.GroundKeys();
  const double ticks = (ground.values.front()[0] - ground.values.back()[0]) / tick;
  CHECK(ticks == Catch::Approx(std::round(ticks)).margin(1e-6));
  CHECK(marks[0].text.empty());
  CHECK(
      std::ranges::any_of(whole.Marks(), [](const MovingPicture::Mark& mark) { return mark.text == "2 m"; }));
}

TEST_CASE("moving pictures: the shortest motion is one that stands still") {
  Document document = DecodeJson(gaitsmith::test::ReadFile("examples/star-man-shuffle.json")).value();
  document.duration_steps = 1;
  const Motion motion = Simulate(document);
  for (const ExporterRow& row : kExporters) {
    CAPTURE(row.id);
    for (const bool loops : {false, true}) {
      const std::string file = MakeFile(row, document, motion, {.loops = loops}).value();
      CHECK_FALSE(std::regex_search(file, std::regex("[-: ,>(\"ML]-?(nan|inf)(?![a-z])|(nan|inf)(px|deg)")));
    }
  }
}

}  // namespace
}  // namespace gaitsmith::shell::test
