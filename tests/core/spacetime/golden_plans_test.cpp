// SPDX-License-Identifier: MIT
// Pins: the bits of the solved plans of examples/plans, so that every compiler and browser finds the same
// motion. Does not pin which motion: a better solver may bless them again, because a document keeps its own
// solution. To bless again: tests/golden/bless. Has caught: nothing yet.
#include <array>
#include <catch_amalgamated.hpp>
#include <cstdio>
#include <sstream>

#include "core/document/json.h"
#include "core/physics/trajectory_hash.h"
#include "core/planning/planning.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

/// "lamp-jump <hash of the coefficients>"
std::string SolvedLine(const std::string& name) {
  const Document document = DecodeJson(ReadFile("examples/plans/" + name + ".json")).value();
  const PlanAnswer answer = SolvePlan(SceneOf(document), {});
  TrajectoryHash hash;
  if (answer.motion) {
    for (const double unknown : answer.motion->Unknowns()) hash.Add(unknown);
  }
  return name + " " + HashText(hash.Value());
}

constexpr std::array<const char*, 3> kPinnedPlans = {"biped-step", "lamp-hurdle", "lamp-jump"};

}  // namespace

TEST_CASE("golden: solved plans have the same bits everywhere", "[golden][determinism][spacetime]") {
  std::istringstream pinned(ReadFile("tests/golden/plans.txt"));
  for (const char* name : kPinnedPlans) {
    std::string line;
    REQUIRE(std::getline(pinned, line));
    CHECK(SolvedLine(name) == line);
  }
}

TEST_CASE("bless the solved plans", "[.bless]") {
  for (const char* name : kPinnedPlans) std::printf("%s\n", SolvedLine(name).c_str());
}

}  // namespace gaitsmith::test
