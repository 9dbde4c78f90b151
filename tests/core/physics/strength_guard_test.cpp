// SPDX-License-Identifier: MIT
// What model 2 cannot simulate is void, and all its numbers are finite. The finds are what the adversary and
// random documents found (tests/adversary).
#include <catch_amalgamated.hpp>
#include <cmath>
#include <string>

#include "core/document/json.h"
#include "core/numeric/random.h"
#include "core/rollout/evaluator.h"
#include "tests/adversary/genes_as_document.h"
#include "tests/physics_laws.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

bool IsFinite(const Motion& motion, int frame) {
  const Motion::Frame& f = motion.At(frame);
  double sum = f.x_m + f.turn_rad + static_cast<double>(f.y_m + f.velocity_x_mps + f.velocity_y_mps) +
               static_cast<double>(f.angular_momentum);
  for (int j = 0; j < motion.Bones().joints; ++j)
    sum += static_cast<double>(motion.AngleRad(frame, j) + motion.RateRadps(frame, j));
  for (int k = 0; k < motion.Bones().endpoints; ++k) {
    const Motion::Point place = motion.Endpoint(frame, k), force = motion.Force(frame, k);
    sum += static_cast<double>(place.x + place.y + force.x + force.y);
  }
  const Terms& terms = motion.TermsAt(frame);
  for (int term = 0; term < kStyleTerms; ++term)
    sum += static_cast<double>(terms.Style(static_cast<StyleTerm>(term)));
  return std::isfinite(sum + static_cast<double>(terms.travel_m));
}

/// Simulates a find, which keeps the laws until it is void, and stays finite.
Motion RequireVoid(const std::string& name) {
  const auto find = DecodeJson(ReadFile("tests/adversary/finds/" + name + ".json"));
  REQUIRE(find);
  REQUIRE(find->model == 2);
  Motion motion = Simulate(*find);
  const Offences offences = Judge(*find, motion);
  CHECK(offences.Sentence().empty());
  CHECK(offences.judged < motion.Frames());
  for (int frame = 0; frame < motion.Frames(); ++frame) REQUIRE(IsFinite(motion, frame));
  return motion;
}

}  // namespace

TEST_CASE("find: a stick that a shove would turn by eight radians in a step is void",
          "[physics][strength][find]") {
  // The directions at mid-step grew to many times 1, the inertia with them, and the stick seemed not to turn.
  // A step later nothing was a number.
  const Motion motion = RequireVoid("shoved-stick");
  CHECK_FALSE(motion.TermsAt(66).broke_physics);
  CHECK(motion.TermsAt(67).broke_physics);
}

TEST_CASE("find: a pole that stands still in its own spin is void", "[physics][strength][find]") {
  // As the stick, but for six steps in the air nothing was wrong with its positions. Then an end seemed to
  // touch the ground, 4.9 km below, and the ground gave it an angular momentum without a force.
  const Motion motion = RequireVoid("pole-stands-still");
  CHECK_FALSE(motion.TermsAt(126).broke_physics);
  CHECK(motion.TermsAt(127).broke_physics);
}

TEST_CASE("find: limbs that turn through a stop are void", "[physics][strength][find]") {
  // A gram of root between a kilogram and a thousand tonnes: the stop is firm for the limb as it was drawn,
  // where it weighs next to nothing. The joint went 4.9 rad beyond its limit.
  RequireVoid("turns-through-its-stop");
}

TEST_CASE("find: a short rod before a long one that the ground pulls is void", "[physics][strength][find]") {
  // A centimetre and 42 m: which way a blow to the short one's end moves it is decided by rounding errors. Of
  // the two sides to which it may slip neither fitted, and the ground pulled by 0.04 m/s.
  const Motion motion = RequireVoid("short-rod-before-a-long-one");
  CHECK(motion.TermsAt(2).broke_physics);
}

TEST_CASE("finds of model 2 that remain: stops give way and rounds run out, within what is promised",
          "[physics][strength][find]") {
  struct Find {
    const char* name;
    Law law;
    double about;  // measured, in the law's unit
  };
  // A knee of a limp horse, and a limb of 5 kg between others of 0.2 kg, pass their limits. A horse lands in
  // a step whose rounds run out, so its limbs turn otherwise than its angular momentum says.
  for (const Find& find : {Find{"limp-horse-past-a-stop", Law::kJointLimits, 0.05},
                           {"heavy-limb-past-a-stop", Law::kJointLimits, 0.19},
                           {"horse-out-of-rounds", Law::kTurning, 0.05}}) {
    CAPTURE(find.name);
    const auto document = DecodeJson(ReadFile("tests/adversary/finds/" + std::string(find.name) + ".json"));
    REQUIRE(document);
    const Motion motion = Simulate(*document);
    const Offences offences = Judge(*document, motion);
    CHECK(offences.Sentence().empty());
    // Less is welcome.
    CHECK(offences.Against(find.law).by < 1.1 * find.about);
    if (!document->controllers.empty()) CHECK(DifferingBits(*document, motion) == 0);
  }
}

TEST_CASE("strength: every document gives finite numbers, and void motions score as such",
          "[physics][strength]") {
  int voids = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    RandomStream random(seed, 7, 2);
    std::vector<Gene> genes(kDocumentGenes);
    for (Gene& gene : genes) gene = static_cast<Gene>(random.Below(65536));
    const Document document = DocumentOf(Scope::kAny, 2, seed % 4 == 0, genes);
    const Motion motion = Simulate(document);
    CAPTURE(seed);
    for (int frame = 0; frame < motion.Frames(); ++frame) REQUIRE(IsFinite(motion, frame));
    const bool is_void = motion.TermsAt(motion.Frames() - 1).broke_physics;
    voids += is_void ? 1 : 0;
    if (document.controllers.empty()) continue;
    const Controller& controller = document.controllers.front();
    for (const int lanes : {1, 8}) {
      const auto found = Evaluator(ReplayProblem(document, controller), lanes, true)
                             .Evaluate(std::vector<Genome>(3, controller.genes));
      REQUIRE((found[2].fitness == kVoidScore) == is_void);
      REQUIRE(std::isfinite(found[2].fitness));
      REQUIRE(found[2].trajectory_hash == motion.Hash());
    }
  }
  CAPTURE(voids);
  CHECK(voids > 100);
}

}  // namespace gaitsmith::test
