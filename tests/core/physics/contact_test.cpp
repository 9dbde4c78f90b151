// SPDX-License-Identifier: MIT
// Checks the contact solver against the conditions it must satisfy, at random instants: any stance, height,
// inertia, friction, velocities and drifts.
#include <catch_amalgamated.hpp>
#include <cmath>

#include "core/numeric/random.h"
#include "core/physics/contact_sweeps.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

using L = Lane<1>;

struct Instant {
  World world;
  Body<1> body;
  std::array<Contact<1>, 3> contact;
};

Instant RandomInstant(std::uint64_t seed) {
  RandomStream random(seed, 0, 0);
  const auto between = [&](double low, double high) {
    return static_cast<float>(low + (high - low) * random.Uniform());
  };
  Environment environment;
  environment.friction = random.Uniform() < 0.2 ? 0.0f : between(0.0, 3.0);
  Instant instant{World(Skeleton(ShippedFigure("mr-star-man")), environment, kStep), {}, {}};
  Body<1>& body = instant.body;
  body.velocity_x = L::Splat(between(-3.0, 3.0));
  body.velocity_y = L::Splat(between(-3.0, 1.0));
  body.spin = L::Splat(between(-6.0, 6.0));
  body.height = L::Splat(between(0.05, 2.0));
  body.inertia = L::Splat(between(0.3, 8.0));
  body.inverse_inertia = 1.0f / body.inertia;
  for (Contact<1>& c : instant.contact) {
    c.arm = L::Splat(between(-1.5, 1.5));
    c.drift_t = L::Splat(between(-2.0, 2.0));
    c.drift_n = L::Splat(between(-1.0, 1.0));
    c.force = {L::F{}, L::F{}};
  }
  return instant;
}

/// The largest violation of any condition, as a velocity [m/s].
double OffenceOf(const Instant& instant, int contacts) {
  Body<1> after = instant.body;
  for (int i = 0; i < contacts; ++i) {
    const Contact<1>& c = instant.contact[static_cast<std::size_t>(i)];
    after.Push(instant.world, c.arm, c.force);
  }
  double worst = 0.0;
  // NaN is the largest violation.
  const auto offends = [&](double by) { worst = std::isnan(by) ? 1e9 : std::max(worst, by); };
  for (int i = 0; i < contacts; ++i) {
    const Contact<1>& c = instant.contact[static_cast<std::size_t>(i)];
    const double mobility = static_cast<double>(instant.world.inverse_mass);
    const double normal = mobility * static_cast<double>(c.force.normal[0]);
    const double tangent = mobility * static_cast<double>(c.force.tangent[0]);
    const double approach = static_cast<double>(c.Approach(after)[0]);
    const double slide = static_cast<double>(c.Slide(after)[0]);
    const double most = static_cast<double>(instant.world.friction) * normal;
    offends(-normal);                     // it pushes
    offends(-approach);                   // it stays above the ground
    offends(std::min(normal, approach));  // one of them is 0
    offends(std::abs(tangent) - most);    // it is in the friction cone
    // Inside the cone it sticks. On an edge it slides the other way.
    offends(std::min(std::max(slide, 0.0), tangent + most));
    offends(std::min(std::max(-slide, 0.0), most - tangent));
  }
  return worst;
}

}  // namespace

TEST_CASE("contact: one endpoint is solved exactly", "[physics][contact]") {
  for (std::uint64_t seed = 0; seed < 20000; ++seed) {
    Instant instant = RandomInstant(seed);
    SolveSingle<1>(instant.world, instant.body, instant.contact[0]);
    CAPTURE(seed);
    REQUIRE(OffenceOf(instant, 1) < 2e-4);
  }
}

TEST_CASE("contact: two endpoints are solved exactly", "[physics][contact]") {
  int solved = 0;
  constexpr int kInstants = 20000;
  for (std::uint64_t seed = 0; seed < kInstants; ++seed) {
    Instant instant = RandomInstant(seed);
    SolvePair<1>(instant.world, instant.body, instant.contact[0], instant.contact[1], ~L::I{});
    solved += OffenceOf(instant, 2) < 1e-3 ? 1 : 0;
  }
  REQUIRE(solved == kInstants);
}

TEST_CASE("contact: sweeps come close with three endpoints", "[physics][contact]") {
  int solved = 0;
  constexpr int kInstants = 5000;
  const std::array<L::I, 3> present = {L::I{} - 1, L::I{} - 1, L::I{} - 1};
  for (std::uint64_t seed = 0; seed < kInstants; ++seed) {
    Instant instant = RandomInstant(seed);
    SolveMany<1>(instant.world, instant.body, instant.contact, present);
    solved += OffenceOf(instant, 3) < 1e-2 ? 1 : 0;
  }
  CAPTURE(solved);
  REQUIRE(solved >= kInstants * 4 / 5);
}

}  // namespace gaitsmith::test
