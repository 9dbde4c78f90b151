// SPDX-License-Identifier: MIT
// Edits of figures of springs, as the drawing board makes them.
#include "shell/panels/figure/spring_edit.h"

#include <catch_amalgamated.hpp>
#include <cmath>

#include "core/physics/symmetry.h"
#include "core/world/environment.h"

namespace gaitsmith::shell {

namespace {

int SpringsAt(const Figure& figure, int node) {
  return static_cast<int>(std::ranges::count_if(
      figure.springs, [node](const Spring& one) { return one.from == node || one.to == node; }));
}

/// An upright spring, and a node to the right of it.
Figure Triangle() { return WithNodeAt(SpringBetween({0.0f, 0.0f}, {0.0f, 0.5f}), {0.4f, 0.25f}, {}); }

}  // namespace

TEST_CASE("spring edit: a node is held by the two nearest, and what is drawn is always valid",
          "[springs][figure_edit]") {
  Figure figure = SpringBetween({0.0f, 0.0f}, {0.0f, 0.5f});
  REQUIRE(Validate(figure));
  figure = Triangle();
  REQUIRE(Validate(figure));
  CHECK(figure.nodes.size() == 3);
  CHECK(SpringsAt(figure, 2) == 2);
  figure = WithNodeAt(figure, {0.8f, 0.25f}, {});
  CHECK(SpringsAt(figure, 3) == 2);
  figure = WithNodeFrom(figure, 0, {0.1f, -0.4f}, {});
  CHECK(SpringsAt(figure, 4) == 2);
  figure = WithNodeGrown(figure, 3, {});
  REQUIRE(Validate(figure));
  CHECK(figure.nodes.size() == 6);
  for (std::size_t i = 0; i + 1 < figure.nodes.size(); ++i)
    CHECK(std::hypot(figure.nodes[i].x_m - figure.nodes[5].x_m, figure.nodes[i].y_m - figure.nodes[5].y_m) >
          0.1f);
  // A spring that is there is not drawn twice, and none leads back to its node.
  const std::size_t springs = figure.springs.size();
  CHECK(WithSpring(figure, 0, 1, {}).springs.size() == springs);
  CHECK(WithSpring(figure, 1, 0, {}).springs.size() == springs);
  CHECK(WithSpring(figure, 2, 2, {}).springs.size() == springs);
  CHECK(WithSpring(figure, 4, 3, {}).springs.size() == springs + 1);
}

TEST_CASE("spring edit: both sides stay each other's mirror image", "[springs][figure_edit]") {
  const Mirror mirror = 0.0f;
  Figure figure = SpringBetween({0.0f, 0.0f}, {0.0f, 0.5f});
  figure = WithNodeAt(figure, {0.4f, 0.25f}, mirror);
  CHECK(figure.nodes.size() == 4);
  figure = WithNodeFrom(figure, 0, {0.3f, -0.3f}, mirror);
  figure = WithNodeAt(figure, {0.02f, 0.8f}, mirror);  // near the mirror: on it
  CHECK(figure.nodes.back().x_m == 0.0f);
  const auto spring = static_cast<int>(figure.springs.size());
  figure = WithSpring(figure, 2, 6, mirror);
  figure = WithMuscleToggled(figure, spring, mirror);
  CHECK(figure.Muscles() == 2);
  figure = WithNodeMoved(figure, 2, {0.45f, 0.3f}, mirror);
  Node heavy = figure.nodes[2];
  heavy.mass_kg = 0.7f;
  figure = WithNode(figure, 2, heavy, mirror);
  Spring firm = figure.springs[static_cast<std::size_t>(spring)];
  firm.stiffness_npm = 1234.0f;
  figure = WithSpringAs(figure, spring, firm, mirror);
  REQUIRE(Validate(figure));
  const auto symmetry = SymmetryOf(figure);
  REQUIRE(symmetry);
  CHECK(symmetry->joint[0] == 1);
  CHECK(symmetry->endpoint[2] == 3);
  CHECK(ImageOfNode(figure, 2, 0.0f) == 3);
  CHECK(ImageOfSpring(figure, spring, 0.0f) >= 0);
  const Figure rest = Without(figure, {SpringPart::Kind::kNode, 2}, mirror);
  CHECK(SymmetryOf(rest));
  CHECK(rest.nodes.size() == figure.nodes.size() - 2);
  const Figure mirrored = MirroredSprings(figure);
  CHECK(MirroredSprings(mirrored).nodes == figure.nodes);
}

TEST_CASE("spring edit: what nothing holds goes with what is taken away", "[springs][figure_edit]") {
  Figure figure = Triangle();
  figure = WithNodeFrom(figure, 2, {0.9f, 0.25f}, {});
  figure = Without(figure, {SpringPart::Kind::kSpring, static_cast<int>(figure.springs.size()) - 1}, {});
  REQUIRE(Validate(figure));
  CHECK(SpringsAt(figure, 3) == 1);
  const Figure rest = Without(figure, {SpringPart::Kind::kNode, 2}, {});
  REQUIRE(Validate(rest));
  CHECK(rest.nodes.size() == 2);
  // The last spring leaves nothing that is a figure; the panel does not offer that.
  CHECK(Without(rest, {SpringPart::Kind::kSpring, 0}, {}).springs.empty());
  CHECK_FALSE(Validate(Without(rest, {SpringPart::Kind::kNode, 1}, {})));
}

TEST_CASE("spring edit: the larger part stays, and a mass moves nothing", "[springs][figure_edit]") {
  Figure chain = SpringBetween({0.0f, 0.0f}, {0.3f, 0.0f});
  for (int node = 2; node < 8; ++node) {
    chain.nodes.push_back({.x_m = 0.3f * static_cast<float>(node), .y_m = 0.0f, .mass_kg = 0.1f});
    chain.springs.push_back({.from = node - 1, .to = node});
  }
  REQUIRE(Validate(chain));
  CHECK(Without(chain, {SpringPart::Kind::kSpring, 1}, {}).nodes.size() == 6);
  CHECK(Without(chain, {SpringPart::Kind::kNode, 1}, {}).nodes.size() == 6);
  CHECK(Without(chain, {SpringPart::Kind::kSpring, 6}, {}).nodes.size() == 7);
  Figure fine = Triangle();
  fine.nodes[2].x_m = 0.4321f;
  Node heavy = fine.nodes[2];
  heavy.mass_kg = 2.0f;
  const Figure changed = WithNode(fine, 2, heavy, MiddleOf(fine));
  CHECK(changed.nodes[2].x_m == 0.4321f);
  CHECK(changed.nodes[2].mass_kg == 2.0f);
}

TEST_CASE("spring edit: stiffer stays valid however often, and fades as soon", "[springs][figure_edit]") {
  Figure figure = Triangle();
  const std::string before = StiffnessWords(figure);
  const Figure stiffer = WithStiffness(figure, 4.0f);
  CHECK(stiffer.springs[0].stiffness_npm == 4.0f * figure.springs[0].stiffness_npm);
  CHECK(stiffer.springs[0].damping_nspm == 2.0f * figure.springs[0].damping_nspm);
  for (int i = 0; i < 40; ++i) figure = WithStiffness(figure, 2.0f);
  REQUIRE(Validate(figure));
  CHECK(std::string(StiffnessWords(figure)) == "stiff");
  for (int i = 0; i < 80; ++i) figure = WithStiffness(figure, 0.5f);
  REQUIRE(Validate(figure));
  CHECK(std::string(StiffnessWords(figure)) == "soft");
  CHECK(before != "stiff");
}

}  // namespace gaitsmith::shell
