// SPDX-License-Identifier: MIT
#include "shell/session/gait_finder.h"

#include <catch_amalgamated.hpp>

#include "shell/session/session.h"
#include "tests/scene.h"
#include "tests/shell/session/quiet_host.h"

namespace gaitsmith::shell::test {

using namespace gaitsmith::test;

namespace {

void Rest(Session& session) {
  for (int frame = 0; frame < 60; ++frame) (void)session.Advance(0.02);
}

}  // namespace

TEST_CASE("gait: the cycle of a motion is known once it rests, and forgotten with the next one",
          "[session]") {
  QuietHost host;
  Session session(host);
  REQUIRE(session.Open(ReadFile("examples/gallery/star-man-cartwheel.json")));
  CHECK_FALSE(session.Gait().Cycle());
  Rest(session);
  REQUIRE(session.Gait().Cycle());
  const GaitCycle& cycle = *session.Gait().Cycle();
  CHECK(cycle.likeness >= kLeastLikeness);
  CHECK(cycle.first + cycle.frames < session.Player().Shown().Frames());
  CHECK(std::abs(session.Gait().DistanceM()) > 0.1);
  // While a person changes the motion there is none.
  session.BeginGesture();
  REQUIRE(session.Change([](Document& d) { d.environment.gravity_mps2 = 3.0f; }));
  (void)session.Advance(0.02);
  CHECK_FALSE(session.Gait().Cycle());
}

}  // namespace gaitsmith::shell::test
