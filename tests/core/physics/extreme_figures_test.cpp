// SPDX-License-Identifier: MIT
// Figures at the limits of documents, in worlds at their limits. Every law holds, and the bits are the same
// in two runs and for every number of lanes. Such a motion may be void, but must be correct otherwise.
#include <catch_amalgamated.hpp>
#include <string>

#include "tests/physics_laws.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

constexpr int kMotionSteps = 150;
constexpr float kPiRad = 3.1415927f;

/// A chain of rods.
Figure Chain(const char* name, int rods, float rest_rad) {
  Figure figure{name, {}};
  for (int i = 0; i < rods; ++i) {
    figure.rods.push_back(
        {.parent = i - 1, .rest_rad = i == 0 ? 0.4f : rest_rad, .min_rad = -kPiRad, .max_rad = kPiRad});
  }
  return figure;
}

std::vector<Figure> Extremes() {
  Figure lengths = Chain("lengths 1 to 1000", 6, 0.7f);
  for (std::size_t i = 0; i < lengths.rods.size(); i += 2) lengths.rods[i].length_m = 0.001f;
  Figure longest = Chain("lengths 1 m to 1 km", 4, 0.7f);
  for (std::size_t i = 0; i < longest.rods.size(); i += 2) longest.rods[i].length_m = 1000.0f;
  Figure masses = Chain("masses 1 to a million", 5, 0.7f);
  for (std::size_t i = 0; i < masses.rods.size(); i += 2) masses.rods[i].mass_kg = 1e-6f;
  Figure heavy = Chain("a ton among grams", 5, -0.5f);
  for (std::size_t i = 0; i < heavy.rods.size(); ++i) heavy.rods[i].mass_kg = i == 2 ? 1e6f : 1.0f;
  Figure star = Chain("sixteen rods at one point", kMaxRods, 0.0f);
  for (std::size_t i = 1; i < star.rods.size(); ++i) {
    star.rods[i].parent = 0;
    star.rods[i].parent_end = RodEnd::kStart;
    star.rods[i].rest_rad = -kPiRad + 0.4f * static_cast<float>(i);
  }
  Figure bundle = star;
  bundle.name = "sixteen rods on one another";
  for (Rod& rod : bundle.rods) rod.rest_rad = 0.0f;
  Figure dust = Chain("a millimetre of a milligram", 3, 0.7f);
  for (Rod& rod : dust.rods) {
    rod.length_m = 0.001f;
    rod.mass_kg = 1e-6f;
  }
  return {lengths,
          longest,
          masses,
          heavy,
          star,
          bundle,
          dust,
          Chain("folded", 8, kPiRad),
          Chain("sixteen in a row", kMaxRods, 0.3f)};
}

struct ExtremeStart {
  const char* name;
  StartState start;
  std::vector<Push> pushes;
};

const std::vector<ExtremeStart>& ExtremeStarts() {
  static const std::vector<ExtremeStart> kStarts = {
      {"stands", {}, {}},
      {"thrown at the ground", {0.0f, 100.0f, -100.0f, 40.0f}, {}},
      {"thrown away", {100.0f, -100.0f, 100.0f, -40.0f}, {}},
      {"struck", {}, {{2, 0, 1e6f, -1e6f}, {20, kCentreOfMass, -1e6f, -1e6f}}},
  };
  return kStarts;
}

/// The fastest rules that a document can contain.
Controller Hasty(const Figure& figure, SenseKind kind) {
  SenseSpec senses;
  senses.kind = kind;
  senses.period_steps = 7;
  senses.tau_min_s = 0.02f;
  senses.tau_max_s = 0.02f;
  return RandomController(figure, senses, 3);
}

/// @return number of frames before a guard trips
int Try(const Document& document) {
  REQUIRE(Validate(document));
  const Motion motion = Simulate(document);
  const Offences offences = Judge(document, motion);
  if (offences.FirstBroken() < kLaws) FAIL_CHECK(offences.Sentence());
  if (document.controllers.empty()) {
    CHECK(HashText(Simulate(document).Hash()) == HashText(motion.Hash()));
  } else {
    CHECK(DifferingBits(document, motion) == 0);
  }
  return offences.judged;
}

}  // namespace

TEST_CASE("extremes: figures keep the laws and their bits, whatever world they are thrown into",
          "[physics][extremes]") {
  int motions = 0, sound = 0;
  for (const Figure& figure : Extremes()) {
    for (const float gravity : {0.0f, 9.8f, 100.0f}) {
      for (const float friction : {0.0f, 0.8f, 10.0f}) {
        for (const ExtremeStart& beginning : ExtremeStarts()) {
          CAPTURE(figure.name, gravity, friction, beginning.name);
          Document document;
          document.figure = figure;
          document.environment.gravity_mps2 = gravity;
          document.environment.friction = friction;
          document.start = beginning.start;
          document.pushes = beginning.pushes;
          document.task.duration_steps = document.duration_steps = kMotionSteps;
          const auto attempt = [&] {
            ++motions;
            sound += Try(document) > kMotionSteps ? 1 : 0;
          };
          attempt();
          document.timeline = {{.controller = 0, .start_step = 0}};
          for (const SenseKind kind : {SenseKind::kTimer, SenseKind::kPhysical}) {
            document.controllers = {Hasty(figure, kind)};
            attempt();
          }
        }
      }
    }
  }
  // Enough motions must be valid, or the laws would judge nothing.
  CAPTURE(motions);
  CHECK(sound > motions / 3);
}

TEST_CASE("extremes: figures with limited joints keep the laws of model 2, or are void",
          "[physics][extremes][strength][exhaustive]") {
  int motions = 0, sound = 0;
  for (const Figure& figure : Extremes()) {
    for (const float strength : {0.0f, 0.1f, 2.0f, 1000.0f}) {
      for (const float stiffness : {1.0f, 1e4f, 1e6f}) {
        if (strength == 0.0f && stiffness != 1.0f) continue;  // limp joints are never firm
        for (const ExtremeStart& beginning : ExtremeStarts()) {
          CAPTURE(figure.name, strength, stiffness, beginning.name);
          Document document;
          document.model = 2;
          document.figure = figure;
          for (Rod& rod : document.figure.rods) {
            rod.strength = strength;
            rod.stiffness = stiffness;
          }
          document.start = beginning.start;
          document.pushes = beginning.pushes;
          document.task.duration_steps = document.duration_steps = kMotionSteps;
          document.controllers = {Hasty(figure, SenseKind::kPhysical)};
          document.timeline = {{.controller = 0, .start_step = 0}};
          ++motions;
          sound += Try(document) > kMotionSteps ? 1 : 0;
        }
      }
    }
  }
  CAPTURE(motions, sound);
  CHECK(sound > motions / 8);
}

TEST_CASE("extremes: on the steepest ground that rocks as fast as it may", "[physics][extremes]") {
  for (const Figure& figure : Extremes()) {
    CAPTURE(figure.name);
    Document document;
    document.figure = figure;
    document.environment = {.gravity_mps2 = 100.0f,
                            .friction = 10.0f,
                            .slope_rad = -0.6f,
                            .sway_rad = 0.6f,
                            .sway_period_s = 0.5f};
    document.task.duration_steps = document.duration_steps = 2 * kMotionSteps;
    Try(document);
    document.controllers = {Hasty(figure, SenseKind::kPhysical)};
    document.timeline = {{.controller = 0, .start_step = 0}};
    Try(document);
  }
}

}  // namespace gaitsmith::test
