// SPDX-License-Identifier: MIT
// The moment that is shown.
#include "shell/workspace/playback.h"

#include <catch_amalgamated.hpp>
#include <cmath>

#include "core/document/json.h"
#include "tests/scene.h"

namespace gaitsmith::shell {

TEST_CASE("playback: seeking a frame shows the one whose time is displayed") {
  const auto document = DecodeJson(gaitsmith::test::ReadFile("examples/star-man-shuffle.json"));
  REQUIRE(document);
  Playback player;
  player.Load(*document, true);
  for (const double time_s : {0.0, 0.004, 2.596, 2.604, 6.899, 9.996, 11.0}) {
    player.SeekFrame(time_s);
    CAPTURE(time_s, player.TimeS());
    CHECK(player.Frame() == static_cast<int>(std::lround(player.TimeS() * 100.0)));
    CHECK(std::abs(player.TimeS() * 100.0 - std::round(player.TimeS() * 100.0)) < 1e-3);
    CHECK(std::abs(player.TimeS() - std::min(time_s, 10.0)) < 0.0051);
  }
}

}  // namespace gaitsmith::shell
