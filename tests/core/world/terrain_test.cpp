// SPDX-License-Identifier: MIT
#include "core/world/terrain.h"

#include <catch_amalgamated.hpp>
#include <cmath>

using namespace gaitsmith;

namespace {

const std::vector<Corner> kHurdle = {{1.0f, 0.0f}, {1.0f, 0.3f}, {1.05f, 0.3f}, {1.05f, 0.0f}};

bool Near(double one, double other) { return std::abs(one - other) < 1e-6; }

std::string FaultOf(const std::vector<Corner>& ground) {
  const Result<void> checked = Validate(std::span(ground));
  return checked ? "" : checked.error().Sentence();
}

}  // namespace

TEST_CASE("ground without corners is level everywhere", "[physics][ground]") {
  const Terrain level{std::span<const Corner>()};
  REQUIRE(level.Level());
  REQUIRE(level.Edges().empty());
  for (const double x : {-1e6, 0.0, 3.5}) REQUIRE(level.HeightAt(x) == 0.0);
}

TEST_CASE("the height of drawn ground is that of the line through its corners", "[physics][ground]") {
  const Terrain hurdle{std::span(kHurdle)};
  REQUIRE(hurdle.HeightAt(0.9) == 0.0);
  REQUIRE(Near(hurdle.HeightAt(1.0), 0.3));
  REQUIRE(Near(hurdle.HeightAt(1.02), 0.3));
  REQUIRE(hurdle.HeightAt(1.06) == 0.0);
  const std::vector<Corner> ramp = {{0.0f, 0.0f}, {2.0f, 1.0f}};
  REQUIRE(Near(Terrain{std::span(ramp)}.HeightAt(0.5), 0.25));
  REQUIRE(Near(Terrain{std::span(ramp)}.HeightAt(90.0), 1.0));
}

TEST_CASE("the next corner is the nearest one to that side", "[physics][ground]") {
  const Terrain hurdle{std::span(kHurdle)};
  REQUIRE(Near(hurdle.NextCorner(0.0, 1), 1.0));
  REQUIRE(Near(hurdle.NextCorner(1.02, 1), static_cast<double>(1.05f) - 1.02));
  REQUIRE(Near(hurdle.NextCorner(1.02, -1), 0.02));
  REQUIRE(std::isinf(hurdle.NextCorner(1.2, 1)));
  REQUIRE(std::isinf(hurdle.NextCorner(0.0, -1)));
  // From a corner on, it is the one after it.
  REQUIRE(Near(hurdle.NextCorner(1.0, 1), static_cast<double>(1.05f) - 1.0));
  REQUIRE(std::isinf(Terrain{std::span<const Corner>()}.NextCorner(0.0, 1)));
}

TEST_CASE("edges are the corners that stick out, and know the side of the ground", "[physics][ground]") {
  const Terrain hurdle{std::span(kHurdle)};
  REQUIRE(hurdle.Edges().size() == 2);
  for (const Terrain::Edge& edge : hurdle.Edges()) REQUIRE(edge.SideOfGround(1.0, 0.0) == -1);
  REQUIRE(hurdle.Edges()[0].SideOfGround(0.0, 1.0) == -1);  // a rod that stands before the hurdle
  REQUIRE(hurdle.Edges()[1].SideOfGround(0.0, 1.0) == 1);
  REQUIRE(hurdle.Edges()[0].SideOfGround(0.6, 0.8) == -1);
  REQUIRE(hurdle.Edges()[0].SideOfGround(0.8, -0.6) == 0);  // points into it
  for (const Terrain::Face& face : hurdle.Faces())
    REQUIRE(face.Above(1.02, 0.1) < (face.uy < 0.0 || face.uy > 0.0 ? 0.0 : 0.2));
  REQUIRE(hurdle.EdgesBetween(0.0, 1.02).size() == 1);
  REQUIRE(hurdle.FacesBetween(1.01, 1.02).size() == 1);
}

TEST_CASE("wrong ground is refused with its place", "[physics][ground]") {
  REQUIRE(FaultOf(kHurdle).empty());
  REQUIRE(FaultOf({{2.0f, 0.0f}, {1.0f, 0.0f}}) == "ground[1].x_m: corners go from left to right");
  REQUIRE(FaultOf({{0.0f, 0.0f}, {0.001f, 0.0f}}) ==
          "ground[1].x_m: must be at least 0.01 m from the corner before, or the same");
  REQUIRE(FaultOf({{0.0f, 0.0f}, {0.0f, 0.0f}}) == "ground[1].y_m: a vertical face is at least 0.01 m high");
  REQUIRE(FaultOf({{0.0f, 0.0f}, {0.0f, 1.0f}, {0.0f, 2.0f}}) ==
          "ground[2].x_m: at most two corners may be above each other");
  REQUIRE(FaultOf({{300.0f, 0.0f}}) == "ground[0].x_m: must be from -200 to 200");
  REQUIRE(FaultOf({{0.0f, -30.0f}}) == "ground[0].y_m: must be from -20 to 20");
  REQUIRE(FaultOf(std::vector<Corner>(65)) == "ground: at most 64 corners, there are 65");
}
