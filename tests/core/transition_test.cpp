// SPDX-License-Identifier: MIT
// How well one controller takes over from another.
#include "core/document/transition.h"

#include <catch_amalgamated.hpp>

#include "tests/scene.h"

namespace gaitsmith::test {
TEST_CASE("transition: a state of the usual motion is near it", "[timeline]") {
  const Document d = TwoClips();
  const Motion usual = UsualMotion(d, 1);
  const Nearness same = NearnessOf(usual, 123, usual);
  CHECK(same.distance == 0.0f);
  CHECK(same.frame == 123);
  const Motion composite = Simulate(d);
  const Nearness at_switch = NearnessOf(composite, 230, usual);
  CHECK(at_switch.distance > 0.05f);
  // Where along the ground does not matter, nor do whole turns.
  Document moved = d;
  moved.timeline = {{.controller = 1, .start_step = 0}};
  CHECK(NearnessOf(Simulate(moved), 77, usual).distance == 0.0f);
}

}  // namespace gaitsmith::test
