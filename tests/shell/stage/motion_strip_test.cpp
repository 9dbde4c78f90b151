// SPDX-License-Identifier: MIT
#include "shell/stage/motion_strip.h"

#include <algorithm>
#include <catch_amalgamated.hpp>

#include "core/document/json.h"
#include "tests/scene.h"

namespace gaitsmith::shell {
namespace {

float HeightOf(const std::vector<ImVec2>& pose) {
  float sum = 0.0f;
  for (const ImVec2& point : pose) sum += point.y;
  return sum;
}

}  // namespace

TEST_CASE("motion strip: made once, one in a frame, with its highest pose") {
  MotionStrips strips;
  int made = 0;
  const auto frog = [&made] {
    ++made;
    return *DecodeJson(gaitsmith::test::ReadFile("examples/gallery/frog-hop.json"));
  };
  strips.BeginFrame();
  const MotionStrip* strip = strips.Of("frog", frog);
  REQUIRE(strip != nullptr);
  CHECK(strips.Of("frog", frog) == strip);
  CHECK(strips.Of("another", frog) == nullptr);
  CHECK(made == 1);
  CHECK(strips.Waiting());
  CHECK(strip->highest >= 6);  // not the drawn pose
  for (std::size_t i = 6; i < strip->poses.size(); ++i)
    CHECK(HeightOf(strip->poses[i]) <= HeightOf(strip->poses[strip->highest]));
}

}  // namespace gaitsmith::shell
