// SPDX-License-Identifier: MIT
// When a plan's figure flies, and how it lands.
#include "core/planning/plan_flight.h"

#include <catch_amalgamated.hpp>

#include "core/document/json.h"
#include "tests/scene.h"

namespace gaitsmith::test {

TEST_CASE("flights: a lamp lands on its base, an acrobat on feet, and who steps does not fly", "[planning]") {
  const auto flights_of = [](const std::string& name) {
    const auto document = DecodeJson(ReadFile("examples/plans/" + name + ".json"));
    REQUIRE(document);
    return FlightsOf(SceneOf(*document));
  };
  const auto lamp = flights_of("lamp-hurdle");
  REQUIRE(lamp.size() == 1);
  CHECK(lamp[0].start == 75);
  CHECK(lamp[0].middle == 100);
  CHECK(lamp[0].landing == 125);
  CHECK(lamp[0].lies);
  const auto acrobat = flights_of("acrobat-somersault");
  REQUIRE(acrobat.size() == 1);
  CHECK(acrobat[0].landing == 150);
  CHECK_FALSE(acrobat[0].lies);
  CHECK(flights_of("biped-step").empty());
}

}  // namespace gaitsmith::test
