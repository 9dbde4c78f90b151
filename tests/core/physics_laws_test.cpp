// SPDX-License-Identifier: MIT
// The laws of physics_laws.h over the motions that are shipped and over random ones; what the adversary found
// (tests/adversary), one case each; and that the judge sees an offence where there is one.
#include "tests/physics_laws.h"

#include <catch_amalgamated.hpp>

#include "core/document/json.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

Document Read(const std::string& name) {
  const auto document = DecodeJson(ReadFile(name));
  INFO(name);
  REQUIRE(document);
  return *document;
}

void RequireLawful(const Document& document, const Motion& motion) {
  const Offences offences = Judge(document, motion);
  const int law = offences.FirstBroken();
  if (law == kLaws) return;
  const auto i = static_cast<std::size_t>(law);
  FAIL(kLawLimits[i].name << ": " << offences.of[i].by << " " << kLawLimits[i].unit << " in frame "
                          << offences.of[i].frame << " of " << document.title);
}

/// A find keeps its bits: it was made before it was understood, and links to it may exist.
Motion Replay(const Document& find) {
  Motion motion = Simulate(find);
  REQUIRE(find.hash);
  CHECK(HashText(motion.Hash()) == HashText(*find.hash));
  RequireLawful(find, motion);
  return motion;
}

}  // namespace

TEST_CASE("laws: every golden and every shipped motion keeps them, a hundred times better than it must",
          "[physics][laws]") {
  std::vector<std::string> names = GoldenMotions();
  for (std::string& name : ShippedDocuments()) names.push_back(std::move(name));
  for (const std::string& name : names) {
    CAPTURE(name);
    const Document document = Read(name);
    const Motion motion = Simulate(document);
    RequireLawful(document, motion);
    const Offences offences = Judge(document, motion);
    CHECK(offences.Against(Law::kGroundWork).by < 1e-3);
    CHECK(offences.Against(Law::kStillEnergy).by < 1e-3);
  }
}

TEST_CASE("laws: random figures with hasty rules keep them", "[physics][laws]") {
  SenseSpec hasty;
  hasty.tau_min_s = 0.02f;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Document document;
    document.figure = RandomFigure(seed + 900);
    document.duration_steps = 300;
    document.controllers = {RandomController(document.figure, hasty, seed)};
    document.timeline = {{.controller = 0, .start_step = 0}};
    CAPTURE(seed);
    RequireLawful(document, Simulate(document));
  }
}

TEST_CASE("laws: the judge sees what the ground did not do", "[physics][laws]") {
  Document document;
  document.figure = LyingRod();
  document.start.velocity_x_mps = 2.0f;
  document.duration_steps = 50;
  const Motion motion = Simulate(document);
  RequireLawful(document, motion);
  // The same motion, told of another world.
  Document ice = document;
  ice.environment.friction = 0.1f;
  CHECK(Judge(ice, motion).Against(Law::kCone).by > 0.5);
  Document moon = document;
  moon.environment.gravity_mps2 = 1.6f;
  CHECK(Judge(moon, motion).Against(Law::kMomentum).by > 1e-3);
  Document pushed = document;
  pushed.pushes = {{.step = 3, .impulse_x_ns = 1.0f}};
  CHECK(Judge(pushed, motion).Against(Law::kMomentum).by > 0.1);
  document.environment.slope_rad = -0.5f;
  CHECK(Judge(document, motion).FirstBroken() != kLaws);
}

TEST_CASE("find: a figure that spins apart has the same bits in every lane count", "[physics][laws][find]") {
  // Thrown beyond all measure, a lane with one contact was answered by the second that it does not have.
  const Document find = Read("tests/adversary/finds/spun-apart.json");
  const Motion motion = Replay(find);
  CHECK(motion.TermsAt(motion.Frames() - 1).broke_physics);
  CHECK(DifferingBits(find, motion) == 0);
}

TEST_CASE("find: a blow to one end of a lying rod that throws it sideways is void", "[physics][laws][find]") {
  // The blow foresees a turn of 3 rad in the step. The contact was solved on arms turned by half of that, by
  // a series that holds to 0.5: struck straight down, the rod went sideways at 87 m/s.
  const Document find = Read("tests/adversary/finds/blow-to-one-end.json");
  const Motion motion = Replay(find);
  CHECK_FALSE(motion.TermsAt(76).broke_physics);
  CHECK(motion.TermsAt(77).broke_physics);
}

TEST_CASE("find: a long rod that sweeps into the ground and is shot away by it is void",
          "[physics][laws][find]") {
  // Its end comes from 366 m above ground within one step. Friction acts at the ground, but its slide was
  // that of the end on its way: 349 M g l, which the contact solver took for none.
  const Document find = Read("tests/adversary/finds/long-rod-sweeps-in.json");
  const Motion motion = Replay(find);
  CHECK(motion.TermsAt(3).broke_physics);
}

TEST_CASE("find: light rods on a heavy ball that the ground throws are void", "[physics][laws][find]") {
  // Impulses that change little of the motion of a thousand tonnes move rods of grams by much: normal forces
  // gave what friction seemed to take, 2.5 M g l in one step.
  const Document find = Read("tests/adversary/finds/light-rods-on-a-heavy-ball.json");
  const Motion motion = Replay(find);
  CHECK(motion.TermsAt(1).broke_physics);
}

TEST_CASE("find: a figure of millimetres that friction turns while it falls further than it is long is void",
          "[physics][laws][find]") {
  // Friction's lever was foreseen where free fall would have taken the figure, 5 mm lower than it came to be:
  // 1.3 M g l.
  const Document find = Read("tests/adversary/finds/lever-of-a-long-fall.json");
  const Motion motion = Replay(find);
  CHECK(motion.TermsAt(3).broke_physics);
}

TEST_CASE("find: the ground does not pull at the end of a long rod on a small ball",
          "[physics][laws][find]") {
  // 39 t within 1.5 mm, and a rod of 49 m that weighs next to nothing: which way friction would have to push
  // to stop its end is noise, and with the edge of the cone chosen by it alone the ground pulled.
  Replay(Read("tests/adversary/finds/small-ball-on-a-long-rod.json"));
}

TEST_CASE("find: forces next to nothing keep the cone as well as their few digits can",
          "[physics][laws][find]") {
  // Where there is next to no gravity, impulses of 1e-41 N s, which floats tell apart in steps of 1e-45.
  Replay(Read("tests/adversary/finds/next-to-no-force.json"));
}

}  // namespace gaitsmith::test
