// SPDX-License-Identifier: MIT
// Springs without ground: momentum, closed forms, order of convergence, energy.
#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>

#include "core/numeric/random.h"
#include "tests/spring_scene.h"

using namespace gaitsmith;
using Catch::Approx;

namespace {

/// Every node kicked its own way.
template <int W>
void Shake(const Lattice& body, SpringPlant<W>& plant, std::uint64_t seed, float most_ns) {
  RandomStream random(seed, 0, 0);
  const auto impulse = [&] { return most_ns * static_cast<float>(2.0 * random.Uniform() - 1.0); };
  for (int k = 0; k < static_cast<int>(body.nodes); ++k) {
    const float x = impulse(), y = impulse();
    plant.Give({0, k, x, y});
  }
}

/// Length of the pair's spring, pulled by an impulse, after a time.
double LengthAfter(const Figure& figure, float impulse_ns, double seconds, int finer) {
  const Lattice body(figure);
  const float step_s = kStep / static_cast<float>(finer);
  SpringPlant<1> plant(body, Space(), Afloat(), step_s);
  plant.Give({0, 1, impulse_ns, 0.0f});
  plant.Give({0, 0, -impulse_ns, 0.0f});
  const int steps = static_cast<int>(std::lround(seconds / static_cast<double>(kStep))) * finer;
  for (int step = 0; step < steps; ++step) plant.Step(step, AllAt(1.0f));
  return static_cast<double>(plant.Save().x[1][0]) - static_cast<double>(plant.Save().x[0][0]);
}

/// Six nodes on a line or in a square metre with springs between them. Their masses differ by ten thousand,
/// stiffness and damping by more. The fastest vibration is close to the fastest that a document may hold.
Figure AnySprings(bool line, RandomStream& random) {
  const auto magnitude = [&](double least, double most) {
    return static_cast<float>(least * std::pow(most / least, random.Uniform()));
  };
  Figure figure;
  for (int i = 0; i < 6; ++i) {
    const float x = line ? static_cast<float>(i) : magnitude(0.01, 1.0),
                y = line ? 0.0f : magnitude(0.01, 1.0);
    figure.nodes.push_back({x, y, magnitude(0.01, 100.0)});
  }
  for (int from = 0; from < 6; ++from) {
    for (int to = from + 1; to < 6; ++to) {
      if (to > from + 1 && random.Chance(0.5)) continue;
      Spring spring{.from = from, .to = to};
      spring.stiffness_npm = magnitude(1.0, 1e4);
      spring.damping_nspm = magnitude(0.01, 1e6);
      figure.springs.push_back(spring);
    }
  }
  const float scale = 0.9f * kStiffest / FastestVibration(figure);
  for (Spring& spring : figure.springs)
    spring.stiffness_npm = std::clamp(spring.stiffness_npm * scale, 1e-3f, 1e6f);
  REQUIRE(Validate(figure));
  return figure;
}

}  // namespace

TEST_CASE("springs: momentum and angular momentum stay in flight", "[core][springs]") {
  const float damping = GENERATE(0.0f, 5.0f, 1e6f);
  const Lattice body(Box(3000.0f, damping));
  SpringPlant<1> plant(body, Space(), {.drop_height_m = 5.0f, .velocity_x_mps = 1.0f, .spin_radps = 3.0f},
                       kStep);
  Shake(body, plant, 7, 0.3f);
  const SpringTotals before = TotalsOf(body, plant.Save());
  const double angular = static_cast<double>(plant.Observe(0).angular_momentum);
  for (int step = 0; step < 300; ++step) plant.Step(step, AllAt(step % 60 < 30 ? 0.7f : 1.3f));
  const SpringTotals after = TotalsOf(body, plant.Save());
  CHECK(after.momentum_x == Approx(before.momentum_x).margin(2e-5));
  CHECK(after.momentum_y == Approx(before.momentum_y).margin(2e-5));
  CHECK(after.angular_momentum == Approx(before.angular_momentum).margin(2e-5));
  CHECK(static_cast<double>(plant.Observe(0).angular_momentum) == Approx(angular).margin(2e-4));
  CHECK(!plant.TermsOf(0).broke_physics);
}

TEST_CASE("springs: free fall is exact, and the centre of mass flies as a point does", "[core][springs]") {
  const Lattice body(Box());
  const StartState start{
      .drop_height_m = 40.0f, .velocity_x_mps = 2.0f, .velocity_y_mps = 3.0f, .spin_radps = 4.0f};
  SpringPlant<1> plant(body, {}, start, kStep);
  const double height = static_cast<double>(plant.Observe(0).y_m);
  for (int step = 0; step < 200; ++step) plant.Step(step, AllAt(0.8f));
  const Snapshot now = plant.Observe(0);
  CHECK(now.x_m == Approx(4.0).margin(1e-4));
  CHECK(static_cast<double>(now.y_m) == Approx(height + 3.0 * 2.0 - 0.5 * 9.8 * 4.0).margin(1e-3));
  CHECK(static_cast<double>(now.velocity_x_mps) == Approx(2.0).margin(1e-5));
  CHECK(static_cast<double>(now.velocity_y_mps) == Approx(3.0 - 9.8 * 2.0).margin(1e-4));
}

TEST_CASE("springs: a pair swings as its closed form", "[core][springs]") {
  // Reduced mass 0.75 kg.
  const Figure figure = Pair(120.0f, 0.0f, 1.0f, 3.0f);
  const double omega = std::sqrt(120.0 / 0.75);
  const double speed = 0.3 / 1.0 + 0.3 / 3.0;
  for (const double seconds : {0.1, 0.37, 2.0}) {
    CHECK(LengthAfter(figure, 0.3f, seconds, 64) ==
          Approx(1.0 + speed / omega * std::sin(omega * seconds)).margin(2e-5));
  }
}

TEST_CASE("springs: a damped pair decays as its closed form", "[core][springs]") {
  const Figure figure = Pair(120.0f, 3.0f, 1.0f, 3.0f);
  const double mass = 0.75, gamma = 3.0 / (2.0 * mass), omega = std::sqrt(120.0 / mass - gamma * gamma);
  const double speed = 0.3 / 1.0 + 0.3 / 3.0;
  for (const double seconds : {0.1, 0.37, 1.0}) {
    CHECK(LengthAfter(figure, 0.3f, seconds, 64) ==
          Approx(1.0 + speed / omega * std::exp(-gamma * seconds) * std::sin(omega * seconds)).margin(2e-5));
  }
}

TEST_CASE("springs: without damping errors fall with the square of the step, with it in proportion",
          "[core][springs]") {
  const bool damped = GENERATE(false, true);
  const Figure figure = Pair(300.0f, damped ? 2.0f : 0.0f);
  const double mass = 0.5, gamma = (damped ? 2.0 : 0.0) / (2.0 * mass);
  const double omega = std::sqrt(300.0 / mass - gamma * gamma);
  const auto worst = [&](int finer) {
    double most = 0.0;
    for (const double seconds : {0.1, 0.17, 0.24, 0.31, 0.38}) {
      const double exact = 1.0 + 1.0 / omega * std::exp(-gamma * seconds) * std::sin(omega * seconds);
      most = std::max(most, std::abs(LengthAfter(figure, 0.5f, seconds, finer) - exact));
    }
    return most;
  };
  const double order = std::log2(worst(1) / worst(8)) / 3.0;
  CHECK(order == Approx(damped ? 1.0 : 2.0).margin(0.25));
}

TEST_CASE("springs: a chain swings in its normal modes", "[core][springs]") {
  // n equal masses and n - 1 equal springs, free ends: omega_q = 2 sqrt(k / m) sin(pi q / 2n), and mass i
  // moves with cos(pi q (i + 1/2) / n).
  constexpr int kMasses = 6;
  const int mode = GENERATE(1, 3, 5);
  Figure figure;
  for (int i = 0; i < kMasses; ++i) figure.nodes.push_back({0.5f * static_cast<float>(i), 0.0f, 0.2f});
  for (int i = 0; i + 1 < kMasses; ++i)
    figure.springs.push_back({.from = i, .to = i + 1, .stiffness_npm = 100.0f, .damping_nspm = 0.0f});
  const Lattice body(figure);
  SpringPlant<1> plant(body, Space(), Afloat(), kStep / 16.0f);
  const auto shape = [&](int i) { return std::cos(kPi * mode * (i + 0.5) / kMasses); };
  for (int i = 0; i < kMasses; ++i) plant.Give({0, i, static_cast<float>(0.02 * shape(i)), 0.0f});
  const double omega = 2.0 * std::sqrt(100.0 / 0.2) * std::sin(kPi * mode / (2.0 * kMasses));
  for (int step = 0; step < 16 * 40; ++step) plant.Step(step, AllAt(1.0f));
  for (int i = 0; i < kMasses; ++i) {
    const double moved = static_cast<double>(plant.Save().x[static_cast<std::size_t>(i)][0]) -
                         static_cast<double>(body.drawn_x[static_cast<std::size_t>(i)]);
    CHECK(moved == Approx(0.1 / omega * shape(i) * std::sin(omega * 0.4)).margin(2e-5));
  }
}

TEST_CASE("springs: energy stays without muscles and damping, at the stiffest a document may hold",
          "[core][springs]") {
  // Leapfrog keeps a quantity close to the energy: it wavers, and does not grow.
  const std::uint64_t seed = GENERATE(range(std::uint64_t{1}, std::uint64_t{13}));
  Figure figure = Box(1000.0f, 0.0f);
  RandomStream random(seed, 0, 0);
  for (Node& node : figure.nodes) node.mass_kg = static_cast<float>(0.01 + 2.0 * random.Uniform());
  for (Spring& spring : figure.springs)
    spring.stiffness_npm = static_cast<float>(10.0 + 1000.0 * random.Uniform());
  const float scale = GENERATE(0.999f, 0.1f, 0.001f) * kStiffest / FastestVibration(figure);
  for (Spring& spring : figure.springs) spring.stiffness_npm = std::min(spring.stiffness_npm * scale, 1e6f);
  REQUIRE(Validate(figure));
  const Lattice body(figure);
  SpringPlant<1> plant(body, Space(), Afloat(), kStep);
  Shake(body, plant, seed, 0.1f);
  const auto energy = [&] { return TotalsOf(body, plant.Save()).Energy(); };
  const auto mean = [&](int from) {
    double sum = 0.0;
    for (int step = 0; step < 500; ++step) {
      plant.Step(from + step, AllAt(1.0f));
      sum += energy();
    }
    return sum / 500.0;
  };
  const double early = mean(0);
  for (int step = 500; step < 3000; ++step) plant.Step(step, AllAt(1.0f));
  const double late = mean(3000);
  // Single precision adds a little noise to the stiffest springs: less than a thousandth of what lifting
  // takes.
  const double lifting = static_cast<double>(body.total_kg * 9.8f * body.longest_m);
  CHECK(late == Approx(early).epsilon(0.03).margin(1e-3 * lifting));
  CHECK(!plant.TermsOf(0).broke_physics);
}

TEST_CASE("springs: energy comes from the muscles alone, and their work is accounted for",
          "[core][springs]") {
  const int finer = GENERATE(1, 32);  // than the standard step
  const float step_s = kStep / static_cast<float>(finer);
  const Lattice body(Box(2000.0f, 0.0f));
  SpringPlant<1> plant(body, Space(), Afloat(), step_s);
  double work = 0.0, worst = 0.0, most = 0.0;
  for (int step = 0; step < finer * 100; ++step) {
    plant.Step(step, AllAt(step / (25 * finer) % 2 == 0 ? 0.75f : 1.25f, 0.1f, step_s));
    for (std::size_t j = 0; j < body.muscles; ++j) work += static_cast<double>(plant.Save().work_j[j][0]);
    const double energy =
        TotalsOf(body, plant.Save(), 0.0, 0, static_cast<double>(step_s) / body.substeps).Energy();
    worst = std::max(worst, std::abs(energy - work));
    most = std::max(most, work);
  }
  CHECK(most > 1.0);
  CHECK(worst < (finer == 1 ? 0.002 : 1e-5) * most);
}

TEST_CASE("springs: damping takes energy, however strong, and gives none", "[core][springs]") {
  const float damping = GENERATE(0.5f, 50.0f, 1e6f);
  const Lattice body(Box(2000.0f, damping));
  SpringPlant<1> plant(body, Space(), Afloat(), kStep);
  Shake(body, plant, 3, 0.1f);
  const auto energy = [&] { return TotalsOf(body, plant.Save()).Energy(); };
  plant.Step(0, AllAt(1.0f));
  double before = energy();
  for (int second = 0; second < 5; ++second) {
    for (int step = 0; step < 100; ++step) plant.Step(step, AllAt(1.0f));
    const double now = energy();
    CHECK(now <= before * 1.0001);
    before = now;
  }
  CHECK(std::isfinite(before));
}

TEST_CASE("springs: many damped springs take what they take with a finer step", "[core][springs]") {
  const Lattice body(Table(2000.0f, 4.0f));
  const auto left = [&](int finer) {
    const float step_s = kStep / static_cast<float>(finer);
    double sum = 0.0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      SpringPlant<1> plant(body, Space(), Afloat(), step_s);
      Shake(body, plant, seed, 0.1f);
      for (int step = 0; step < 10 * finer; ++step) plant.Step(step, AllAt(1.0f, 0.1f, step_s));
      sum += TotalsOf(body, plant.Save(), 0.0, 0, static_cast<double>(step_s) / body.substeps).Energy();
    }
    return sum;
  };
  CHECK(left(1) == Approx(left(64)).epsilon(0.02));
}

TEST_CASE("springs: no figure gains energy by its damping", "[core][springs]") {
  const auto first_seed = GENERATE(range(std::uint64_t{0}, std::uint64_t{10}));
  const double speed_mps = GENERATE(0.1, 2.0);
  const bool line = GENERATE(true, false);
  for (std::uint64_t seed = 20 * first_seed + 1; seed <= 20 * first_seed + 20; ++seed) {
    RandomStream random(seed, 2, 0);
    const Lattice body(AnySprings(line, random));
    SpringPlant<1> plant(body, Space(), Afloat(), kStep);
    const auto impulse = [&](std::size_t k) {
      return static_cast<float>(speed_mps * random.Normal()) * body.mass_kg[k];
    };
    for (std::size_t k = 0; k < body.nodes; ++k) {
      const float x = impulse(k), y = line ? 0.0f : impulse(k);
      plant.Give({0, static_cast<int>(k), x, y});
    }
    const auto energy = [&] { return TotalsOf(body, plant.Save()).Energy(); };
    const double given = energy();
    double most = 0.0;
    for (int step = 0; step < 200; ++step) {
      plant.Step(step, AllAt(1.0f));
      most = std::max(most, energy());
    }
    INFO("seed " << seed);
    CHECK(most < given);
  }
}

TEST_CASE("springs: a turning pair is stretched as far as its turning takes, with damping by half at least",
          "[core][springs]") {
  // Damping takes a part of the speed that a straight substep of turning nodes gives their spring, so that it
  // has to pull the less: (1 + d) / 2 of what turning takes is left, d the share that damping leaves.
  const float damping = GENERATE(1.0f, 10.0f, 50.0f, 1e6f), spin = 5.0f;
  const Figure figure = Pair(1000.0f, damping);
  const Lattice body(figure);
  SpringPlant<1> plant(body, Space(), {.drop_height_m = 50.0f, .spin_radps = spin}, kStep);
  for (int step = 0; step < 2000; ++step) plant.Step(step, AllAt(1.0f));
  const double length = static_cast<double>(
      std::hypot(plant.Save().x[1][0] - plant.Save().x[0][0], plant.Save().y[1][0] - plant.Save().y[0][0]));
  const double turning = 0.5 / (length * length);  // angular momentum stays: 2.5 = m l^2 w / 2
  const double needed = 25.0 * turning * turning * 4.0 * length * 0.5 / 1000.0;
  const double left = std::exp(-0.01 / body.substeps * static_cast<double>(damping) * 2.0);
  CHECK(length - 1.0 == Approx(0.5 * (1.0 + left) * needed).epsilon(0.05));
}

TEST_CASE("springs: a spinning figure counts its turns", "[core][springs]") {
  const Lattice body(Box(1e5f, 1.0f));
  const float spin = GENERATE(5.0f, -12.0f);
  SpringPlant<1> plant(body, Space(), {.drop_height_m = 5.0f, .spin_radps = spin}, kStep);
  for (int step = 0; step < 500; ++step) plant.Step(step, AllAt(1.0f));
  CHECK(plant.Observe(0).turn_rad == Approx(static_cast<double>(spin) * 5.0).epsilon(0.01));
  CHECK(static_cast<double>(plant.TermsOf(0).rotations) ==
        Approx(std::abs(static_cast<double>(spin)) * 5.0 / (2.0 * kPi)).epsilon(0.01));
  CHECK(static_cast<double>(plant.Upright()[0]) == Approx(std::cos(plant.Observe(0).turn_rad)).margin(1e-5));
}
