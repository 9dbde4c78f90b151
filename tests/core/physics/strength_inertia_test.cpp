// SPDX-License-Identifier: MIT
// The equations of motion of model 2 against an independent model in double precision.
#include <Eigen/Dense>
#include <catch_amalgamated.hpp>
#include <cmath>

#include "core/numeric/random.h"
#include "core/physics/limb_inertia.h"
#include "tests/limb_scene.h"
#include "tests/reference/free_limbs.h"

namespace gaitsmith::test {

namespace {

constexpr int kPosesPerTree = 8;

/// A tree in a random pose with random speeds.
struct PosedTree {
  PosedTree(std::uint64_t seed, int rods) : body(RandomTree(seed, rods, 2.0f)), judge(body) {
    RandomStream random(seed, 79, static_cast<std::uint64_t>(rods));
    place = FreeLimbs::Vector(rods);
    rate = FreeLimbs::Vector(rods);
    LimbNumbers<1> cosine{}, sine{};
    std::array<double, kMaxRods> direction{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(rods); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      place[row] = 3.0 * (2.0 * random.Uniform() - 1.0);
      rate[row] = 8.0 * (2.0 * random.Uniform() - 1.0);
      speed[i] = Lane<1>::Splat(static_cast<float>(rate[row]));
      direction[i] = place[row];
      if (i > 0)
        direction[i] += direction[static_cast<std::size_t>(body.limbs[i].parent)] +
                        static_cast<double>(body.limbs[i].rest_rad);
      cosine[i] = Lane<1>::Splat(static_cast<float>(std::cos(direction[i])));
      sine[i] = Lane<1>::Splat(static_cast<float>(std::sin(direction[i])));
    }
    MeasureMass<1>(body, cosine, sine, inertia);
    MeasureBias<1>(body, cosine, sine, TurningOf<1>(body, speed), inertia);
  }

  /// The core's mass matrix, as it rounds it.
  [[nodiscard]] FreeLimbs::Matrix Measured() const {
    FreeLimbs::Matrix all(body.rods, body.rods);
    for (Eigen::Index j = 0; j < body.rods; ++j) {
      for (Eigen::Index k = 0; k <= j; ++k)
        all(j, k) = all(k, j) =
            static_cast<double>(inertia.mass[static_cast<std::size_t>(j)][static_cast<std::size_t>(k)][0]);
    }
    return all;
  }

  Mechanism body;
  FreeLimbs judge;
  FreeLimbs::Vector place, rate;
  LimbNumbers<1> speed{};
  LimbInertia<1> inertia{};
};

FreeLimbs::Vector InDouble(const LimbNumbers<1>& numbers, int rods) {
  FreeLimbs::Vector all(rods);
  for (Eigen::Index i = 0; i < rods; ++i)
    all[i] = static_cast<double>(numbers[static_cast<std::size_t>(i)][0]);
  return all;
}

}  // namespace

TEST_CASE("strength: the mass matrix is what the limbs' own geometry says", "[physics][strength]") {
  for (int rods = 1; rods <= kMaxRods; ++rods) {
    for (std::uint64_t seed = 0; seed < kPosesPerTree; ++seed) {
      const PosedTree tree(seed, rods);
      const FreeLimbs::Matrix exact = tree.judge.Mass(tree.place);
      // Each entry is a sum of up to 256 terms, of which the largest is a diagonal one.
      const double scale = exact.diagonal().maxCoeff();
      const double error = (tree.Measured() - exact).cwiseAbs().maxCoeff() / scale;
      CAPTURE(rods, seed, error);
      REQUIRE(error < 5e-7);  // measured: 1.7e-7
    }
  }
}

TEST_CASE("strength: the momenta's own change is the slope of the kinetic energy", "[physics][strength]") {
  for (int rods = 1; rods <= kMaxRods; ++rods) {
    for (std::uint64_t seed = 0; seed < kPosesPerTree; ++seed) {
      const PosedTree tree(seed, rods);
      const FreeLimbs::Vector exact = tree.judge.Bias(tree.place, tree.rate);
      const double scale = tree.judge.KineticEnergy(tree.place, tree.rate);
      const double error = (InDouble(tree.inertia.bias, rods) - exact).cwiseAbs().maxCoeff() / scale;
      CAPTURE(rods, seed, error);
      REQUIRE(error < 7e-7);  // measured: 2.1e-7
      REQUIRE(tree.inertia.bias[0][0] == 0.0f);
    }
  }
}

TEST_CASE("strength: the factor solves as Eigen does, however firm the joints", "[physics][strength]") {
  const float firm = GENERATE(0.0f, 1.0f, 1e3f, 1e6f);
  for (int rods = 1; rods <= kMaxRods; ++rods) {
    for (std::uint64_t seed = 0; seed < kPosesPerTree; ++seed) {
      const PosedTree tree(seed, rods);
      const auto n = static_cast<std::size_t>(rods);
      RandomStream random(seed, 80, n);
      LimbNumbers<1> firmness{}, solved{};
      FreeLimbs::Matrix matrix = tree.Measured();
      FreeLimbs::Vector right(rods);
      for (std::size_t i = 0; i < n; ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        // Some joints are firm and some are limp.
        if (i > 0 && random.Chance(0.7))
          firmness[i] = Lane<1>::Splat(firm * static_cast<float>(matrix(row, row)));
        matrix(row, row) += static_cast<double>(firmness[i][0]);
        solved[i] = Lane<1>::Splat(static_cast<float>(2.0 * random.Uniform() - 1.0));
        right[row] = static_cast<double>(solved[i][0]);
      }
      LimbFactor<1>(n, tree.inertia, firmness).Solve(solved);
      const FreeLimbs::Vector exact = matrix.ldlt().solve(right);
      const FreeLimbs::Vector off = InDouble(solved, rods) - exact;
      // As a motion: the energy of the error, as a share of the energy of the solution. And number by number.
      const double energy = std::sqrt(off.dot(matrix * off) / exact.dot(matrix * exact));
      const double largest = off.cwiseAbs().maxCoeff() / exact.cwiseAbs().maxCoeff();
      CAPTURE(firm, rods, seed, energy, largest);
      REQUIRE(energy < 1e-4);   // measured: 2.3e-5, 4.3e-5, 3.4e-5, 7.7e-6
      REQUIRE(largest < 1e-4);  // measured: 3.8e-5, 4.7e-5, 3.2e-5, 7.8e-6
    }
  }
}

}  // namespace gaitsmith::test
