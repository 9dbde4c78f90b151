// SPDX-License-Identifier: MIT
// Figures of springs: what is valid, and what faults are called.
#include <catch_amalgamated.hpp>
#include <functional>
#include <limits>

#include "tests/spring_scene.h"

using namespace gaitsmith;

TEST_CASE("figures of springs: each fault is named with its place", "[core][springs]") {
  struct Fault {
    const char* where;
    std::function<void(Figure&)> make;
  };
  const auto fault = GENERATE(values<Fault>({
      {"nodes", [](Figure& f) { f.rods.push_back({}); }},
      {"nodes", [](Figure& f) { f.nodes.resize(kMaxPoints + 1); }},
      {"nodes", [](Figure& f) { f.nodes.clear(); }},
      {"nodes[1].x_m", [](Figure& f) { f.nodes[1].x_m = 1001.0f; }},
      {"nodes[2].y_m", [](Figure& f) { f.nodes[2].y_m = std::numeric_limits<float>::quiet_NaN(); }},
      {"nodes[3].mass_kg", [](Figure& f) { f.nodes[3].mass_kg = 0.0f; }},
      {"nodes[4]", [](Figure& f) { f.nodes.push_back({2.0f, 2.0f, 1.0f}); }},
      {"springs", [](Figure& f) { f.springs.resize(kMaxSprings + 1, f.springs[0]); }},
      {"springs[0].from", [](Figure& f) { f.springs[0].from = -1; }},
      {"springs[0].to", [](Figure& f) { f.springs[0].to = 4; }},
      {"springs[0].to", [](Figure& f) { f.springs[0].to = f.springs[0].from; }},
      {"springs[5].to", [](Figure& f) { f.springs[5].from = 2, f.springs[5].to = 0; }},
      {"springs[0].to", [](Figure& f) { f.nodes[1] = f.nodes[0]; }},
      {"springs[2].stiffness_npm", [](Figure& f) { f.springs[2].stiffness_npm = -1.0f; }},
      {"springs[2].damping_nspm", [](Figure& f) { f.springs[2].damping_nspm = 2e6f; }},
      {"springs[1].rest", [](Figure& f) { f.springs[1].rest = 0.1f; }},
      {"springs[1].min_rest", [](Figure& f) { f.springs[1].min_rest = 1.1f; }},
      {"springs[1].max_rest", [](Figure& f) { f.springs[1].max_rest = 0.9f; }},
      {"nodes[0].mass_kg", [](Figure& f) { f.nodes[0].mass_kg = 1e-4f; }},
  }));
  Figure figure = Box();
  REQUIRE(Validate(figure));
  fault.make(figure);
  const Result<void> result = Validate(figure);
  REQUIRE(!result);
  INFO(result.error().what);
  CHECK(result.error().where == fault.where);
}

TEST_CASE("figures of springs: too many muscles are refused", "[core][springs]") {
  Figure figure;
  for (int i = 0; i < 17; ++i) figure.nodes.push_back({static_cast<float>(i), 0.0f, 1.0f});
  for (int i = 0; i < 16; ++i) figure.springs.push_back({.from = i, .to = i + 1, .min_rest = 0.9f});
  CHECK(Validate(figure).error().what == "at most 15 muscles, there are 16");
  figure.springs[3].min_rest = 1.0f;
  CHECK(Validate(figure));
  CHECK(figure.Muscles() == kMaxMuscles);
}

TEST_CASE("figures of springs: substeps follow the fastest vibration", "[core][springs]") {
  const auto [stiffness, substeps] =
      GENERATE(table<float, int>({{1.0f, 1}, {5000.0f, 1}, {5100.0f, 2}, {1e6f, 16}}));
  CHECK(Lattice(Pair(stiffness, 0.0f)).substeps == substeps);
}

TEST_CASE("figures of springs: the same springs are the same tree, whatever their numbers",
          "[core][springs]") {
  Figure other = Box(9.0f, 9.0f);
  other.nodes[2].mass_kg = 7.0f;
  CHECK(SameTree(Box(), other));
  other.springs[0].min_rest = other.springs[0].max_rest = 1.0f;  // no muscle any more
  CHECK(!SameTree(Box(), other));
}
