// SPDX-License-Identifier: MIT
#include "core/physics/figure.h"

#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>
#include <limits>
#include <set>

#include "core/physics/skeleton.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {
std::string Fault(const Figure& figure) {
  const auto valid = Validate(figure);
  return valid ? "valid" : valid.error().Sentence();
}
}  // namespace

TEST_CASE("figure: every fault is named with its place", "[figure]") {
  const Figure good = ShippedFigure("mr-star-man");
  REQUIRE(Fault(good) == "valid");
  Figure bad = good;

  bad.rods.clear();
  CHECK(Fault(bad) == "rods: a figure needs at least one rod");
  bad = good;
  bad.rods.resize(17, good.rods[1]);
  CHECK(Fault(bad) == "rods: at most 16 rods, there are 17");
  bad = good;
  bad.rods[2].length_m = 0.0f;
  CHECK(Fault(bad) == "rods[2].length_m: must be from 0.001 to 1000, is 0");
  bad = good;
  bad.rods[2].length_m = -1.0f;
  CHECK(Fault(bad) == "rods[2].length_m: must be from 0.001 to 1000, is -1");
  bad = good;
  bad.rods[3].mass_kg = std::numeric_limits<float>::quiet_NaN();
  CHECK(Fault(bad) == "rods[3].mass_kg: must be a finite number");
  bad = good;
  bad.rods[4].parent = 9;
  CHECK(Fault(bad) == "rods[4].parent: there is no rod 9, the figure has rods 0 to 4");
  bad = good;
  bad.rods[1].parent = 2;
  bad.rods[2].parent = 1;
  CHECK(Fault(bad) == "rods[1].parent: its parents form a cycle");
  bad = good;
  bad.rods[1].parent = 1;
  CHECK(Fault(bad) == "rods[1].parent: a rod cannot be its own parent");
  bad = good;
  bad.rods[2].parent = kNoParent;
  CHECK(Fault(bad) == "rods[2].parent: a second root: rod 0 has no parent either");
  bad = good;
  bad.rods[2].max_rad = -0.5f;
  CHECK(Fault(bad) == "rods[2].max_rad: must be from 0 to 3.141593, is -0.5");
}

TEST_CASE("figure: the order in which rods are listed does not matter to the walk", "[figure]") {
  Figure figure = ShippedFigure("beryl-biped");
  Figure turned;
  turned.name = figure.name;
  // The root comes last, children before their parents.
  for (int i = figure.Rods() - 1; i >= 0; --i) {
    Rod rod = figure.rods[static_cast<std::size_t>(i)];
    if (rod.parent != kNoParent) rod.parent = figure.Rods() - 1 - rod.parent;
    turned.rods.push_back(rod);
  }
  REQUIRE(Fault(turned) == "valid");
  const Skeleton a(figure), b(turned);
  REQUIRE(a.rods == b.rods);
  REQUIRE(a.mass_kg == Catch::Approx(b.mass_kg));
  REQUIRE(b.limbs[0].drawn == 4);
  for (int i = 1; i < b.rods; ++i) REQUIRE(b.limbs[static_cast<std::size_t>(i)].parent < i);
}

TEST_CASE("figure: every shipped figure is valid and stands on the ground", "[figure]") {
  const std::vector<std::string> files = ShippedFigureFiles();
  CHECK(files.size() >= 15);
  std::set<std::string> names;
  for (const std::string& file : files) {
    CAPTURE(file);
    const Figure figure = ShippedFigure(file);
    CHECK(Fault(figure) == "valid");
    CHECK(names.insert(figure.name).second);
    const Motion motion = MotionOf(figure, Environment{}, StartState{}, {}, {}, {}, 0);
    float lowest = 1e9f;
    for (int k = 0; k < motion.Bones().endpoints; ++k) {
      lowest = std::min(lowest, motion.At(0).y_m + motion.Endpoint(0, k).y);
    }
    REQUIRE(lowest == Catch::Approx(0.0f).margin(1e-6f));
  }
}

TEST_CASE("figure: every shipped figure can move itself: of 30 random wind-ups one travels a rod's length",
          "[figure]") {
  for (const std::string& file : ShippedFigureFiles()) {
    CAPTURE(file);
    Document document;
    document.figure = ShippedFigure(file);
    document.senses.kind = SenseKind::kTimer;
    document.duration_steps = 1000;
    document.timeline = {{0, 0}};
    float farthest = 0.0f;
    int broken = 0;
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
      document.controllers = {RandomController(document.figure, document.senses, seed)};
      const Motion motion = Simulate(document);
      const Terms& terms = motion.TermsAt(motion.Frames() - 1);
      broken += terms.broke_physics ? 1 : 0;
      if (!terms.broke_physics) farthest = std::max(farthest, std::abs(terms.travel_m));
    }
    CHECK(farthest > Skeleton(document.figure).longest_rod_m);
    CHECK(broken <= 3);
  }
}

TEST_CASE("figure: controllers fit where the same rods hang on the same ends", "[figure]") {
  const Figure biped = ShippedFigure("beryl-biped");
  Figure other = biped;
  CHECK(SameTree(biped, other));
  CHECK(biped.rods == other.rods);
  other.rods[1].length_m *= 2.0f;
  other.rods[0].mass_kg *= 2.0f;
  CHECK(SameTree(biped, other));
  CHECK(biped.rods != other.rods);
  other.rods[1].parent_end = other.rods[1].parent_end == RodEnd::kEnd ? RodEnd::kStart : RodEnd::kEnd;
  CHECK_FALSE(SameTree(biped, other));
  other = biped;
  other.rods.back().parent = other.rods.back().parent == 0 ? 1 : 0;
  CHECK_FALSE(SameTree(biped, other));
  other = biped;
  other.rods.pop_back();
  CHECK_FALSE(SameTree(biped, other));
}

}  // namespace gaitsmith::test
