// SPDX-License-Identifier: MIT
// Names of motions: those of shipped motions fit what one sees.
#include "shell/words/motion_name.h"

#include <catch_amalgamated.hpp>

#include "core/document/json.h"
#include "shell/words/language.h"
#include "tests/scene.h"

namespace gaitsmith::shell::test {
namespace {

Document ExampleOf(const std::string& name) {
  auto document = DecodeJson(gaitsmith::test::ReadFile("examples/" + name + ".json"));
  REQUIRE(document);
  return std::move(*document);
}

}  // namespace

TEST_CASE("motion name: says what the motion does and where it goes", "[shell][motion_name]") {
  const std::pair<const char*, const char*> names[] = {
      {"gallery/ostrich-run", "Run right"},        {"gallery/acrobat-walk", "Walk right"},
      {"gallery/frog-hop", "Hop right"},           {"gallery/caterpillar-crawl", "Crawl right"},
      {"gallery/star-man-cartwheel", "Roll left"}, {"lessons/4-no-style", "Move left"},
      {"gallery/frog-on-the-moon", "Somersault"},  {"lessons/5-population-hopper", "Jump"},
      {"lessons/2-stuck-horse", "Crawl right"},  // a horse that has fallen
      {"lessons/5-stuck-hopper", "Fall"},
  };
  for (const auto& [example, name] : names) {
    INFO(example);
    CHECK(MotionName(ExampleOf(example), 0) == name);
  }
}

TEST_CASE("motion name: a figure that keeps its pose stands", "[shell][motion_name]") {
  Document d = ExampleOf("gallery/seven-star-wheel");
  const Skeleton bones(d.figure);
  std::vector<float> drawn;
  drawn.reserve(static_cast<std::size_t>(bones.joints));
  for (int joint = 0; joint < bones.joints; ++joint)
    drawn.push_back(bones.limbs[static_cast<std::size_t>(joint) + 1].rest_rad);
  d.controllers = {gaitsmith::test::HoldPose(d.figure, drawn, 0.1f)};
  d.timeline = {{0, 0}};
  CHECK(MotionName(d, 0) == "Stand");
}

TEST_CASE("motion name: the distance tells apart what has the same name", "[shell][motion_name]") {
  const Document d = ExampleOf("gallery/ostrich-run");
  Controller other;
  other.name = "Run left";
  CHECK(MotionName(d, 0, {&other, 1}) == "Run right");
  other.name = "Run right";
  CHECK(MotionName(d, 0, {&other, 1}) == "Run right, 56 m");
}

TEST_CASE("motion name: every name has a German one", "[shell][motion_name][language]") {
  REQUIRE(SetLanguage(gaitsmith::test::ReadFile("shell/words/languages/de.json")));
  for (const char* way : {"Move", "Run", "Walk", "Hop", "Crawl", "Roll"}) {
    for (const char* side : {" left", " right"}) {
      const std::string name = std::string(way) + side;
      CHECK(TrTitle(name).ends_with(name.ends_with("left") ? "nach links" : "nach rechts"));
    }
  }
  for (const char* name : {"Jump", "Somersault", "Turn", "Fall"}) CHECK(TrTitle(name) != name);
  CHECK(TrTitle("Run right, 9.5 m, mirrored") == "Lauf nach rechts, 9,5 m, gespiegelt");
  REQUIRE(SetLanguage(""));
}

}  // namespace gaitsmith::shell::test
