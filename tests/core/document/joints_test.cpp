// SPDX-License-Identifier: MIT
// What documents say of their joints, and when two of them say the same.
#include "core/document/joints.h"

#include <catch_amalgamated.hpp>

#include "core/document/json.h"
#include "core/document/link.h"
#include "tests/scene.h"

namespace gaitsmith::test {

TEST_CASE("joints: the same if both are strong, or limited alike", "[document]") {
  Document a;
  a.figure = ShippedFigure("hopper");
  Document b = a;
  SetJointStrength(5.0f, b);
  CHECK(JointStrength(b) == 5.0f);
  CHECK(SameJoints(a, b));  // a strength that nothing uses
  LimitJoints(a);
  CHECK_FALSE(SameJoints(a, b));
  CHECK_FALSE(SameJoints(b, a));
  LimitJoints(b);
  CHECK_FALSE(SameJoints(a, b));
  CHECK(SameRods(a, b));
  SetJointStrength(5.0f, a);
  CHECK(SameJoints(a, b));
  a.figure.rods[1].stiffness = 77.0f;
  CHECK_FALSE(SameJoints(a, b));
  FreeJoints(a);
  FreeJoints(b);
  CHECK(SameJoints(a, b));
  b.figure.rods[1].length_m += 0.1f;
  CHECK(SameJoints(a, b));
  CHECK_FALSE(SameRods(a, b));
  b.figure.rods.pop_back();
  CHECK_FALSE(SameRods(a, b));
}

TEST_CASE("joints: a search that changes the body starts with the strength that was set", "[document]") {
  Document d;
  d.figure = ShippedFigure("hopper");
  d.drawn = d.figure.rods;
  d.figure.rods[1].length_m *= 1.2f;
  d.search.body = BodyFreedom::kLot;
  LimitJoints(d);
  SetJointStrength(7.0f, d);
  REQUIRE(Validate(d));
  const Problem problem = ProblemOf(d);
  REQUIRE(problem.bodies);
  const Genome genome(problem.Shape().Genes(), 20000);
  for (const Rod& rod : problem.WithBodyOf(genome).figure.rods) {
    if (rod.parent != kNoParent) CHECK(rod.strength == 7.0f);
  }
}

TEST_CASE("joints: files and links keep them, and the motion", "[document][determinism]") {
  for (const std::string& name : GoldenLimitedMotions()) {
    CAPTURE(name);
    auto d = DecodeJson(ReadFile(name));
    REQUIRE(d);
    d->figure.rods.back().strength = 0.1f;
    d->figure.rods.back().stiffness = 333.0f;
    d->hash = Simulate(*d).Hash();
    const auto linked = DecodeLink(EncodeLink(*d));
    REQUIRE(linked);
    CHECK(SameJoints(*linked, *d));
    CHECK(EncodeJson(*linked) == EncodeJson(*d));
    CHECK(Simulate(*linked).Hash() == *d->hash);
  }
}

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

}  // namespace gaitsmith::test
