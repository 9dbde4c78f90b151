// SPDX-License-Identifier: MIT
// The shipped composite of the paper's Figure 12. Each part does what its name says, and its bits never
// change.
#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>
#include <string>

#include "core/document/json.h"
#include "core/numeric/scalar_math.h"
#include "tests/flight_time.h"
#include "tests/scene.h"

namespace gaitsmith {
namespace {

struct Passage {
  std::string name;
  double travel_m = 0.0, turns = 0.0;
  double rise_m = 0.0;     // rise of the centre of mass above its height at the takeover
  int longest_flight = 0;  // steps in a row without contact
};

Passage Measured(const Document& d, const Motion& motion, std::size_t clip) {
  const int begin = d.timeline[clip].start_step, end = EndOf(d, clip);
  const Motion::Frame& first = motion.At(begin);
  const Motion::Frame& last = motion.At(end);
  Passage part{.name = d.controllers[static_cast<std::size_t>(d.timeline[clip].controller)].name,
               .travel_m = last.x_m - first.x_m,
               .turns = (last.turn_rad - first.turn_rad) / (2.0 * kPi)};
  for (int frame = begin; frame <= end; ++frame)
    part.rise_m = std::max(part.rise_m, static_cast<double>(motion.At(frame).y_m - first.y_m));
  part.longest_flight = test::LongestFlight(motion, begin, end);
  return part;
}

TEST_CASE("figure 12: shuffles right, cartwheels left, jumps, shuffles") {
  const auto document = DecodeJson(test::ReadFile("examples/figure-12.json"));
  REQUIRE(document);
  REQUIRE(document->timeline.size() == 4);
  const Motion motion = Simulate(*document);
  CHECK(HashText(motion.Hash()) == "4bb52054eaec117b");
  CHECK(document->hash == motion.Hash());

  const Passage shuffle = Measured(*document, motion, 0);
  CHECK(shuffle.name == "Shuffle");
  CHECK(shuffle.travel_m > 1.0);
  CHECK(std::abs(shuffle.turns) < 0.1);
  const Passage cartwheel = Measured(*document, motion, 1);
  CHECK(cartwheel.name == "Cartwheel");
  CHECK(cartwheel.travel_m < -2.0);
  CHECK(cartwheel.turns > 0.9);  // a cartwheel to the left turns counterclockwise
  CHECK(cartwheel.turns < 1.1);
  const Passage jump = Measured(*document, motion, 2);
  CHECK(jump.name == "Jump");
  CHECK(jump.rise_m > 0.8);
  CHECK(jump.longest_flight > 50);
  CHECK(std::abs(jump.turns) < 0.2);
  const Passage again = Measured(*document, motion, 3);
  CHECK(again.name == "Shuffle");
  CHECK(again.travel_m > 1.0);
  CHECK(std::abs(again.turns) < 0.1);
}

}  // namespace
}  // namespace gaitsmith
