// SPDX-License-Identifier: MIT
// Which documents deserve a warning about the masses of their rods.
#include "core/document/joints.h"

#include <catch_amalgamated.hpp>

namespace gaitsmith {

TEST_CASE("limited joints and rods more unequal than 1:100 are worth a warning, and valid", "[strength]") {
  Document document;
  document.figure = {"Anvil", {{.mass_kg = 0.05f}, {.mass_kg = 5.0f, .parent = 0}}};
  LimitJoints(document);
  REQUIRE(MassRatio(document.figure) == Catch::Approx(100.0));
  // A hundredth of 5 rounds to either side, so the limit itself is not asserted.
  document.figure.rods[1].mass_kg = 4.9f;
  CHECK_FALSE(HasUnequalRods(document));
  for (const float heavy : {5.1f, 50.0f}) {
    document.figure.rods[1].mass_kg = heavy;
    CHECK(HasUnequalRods(document));
    CHECK(Validate(document));
  }
  FreeJoints(document);
  CHECK_FALSE(HasUnequalRods(document));
  CHECK(MassRatio({"Rod", {{.mass_kg = 7.0f}}}) == 1.0f);
}

}  // namespace gaitsmith
