// SPDX-License-Identifier: MIT
// Functions with known optima to test searches, and small search spaces.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>

#include "core/search/search.h"

namespace gaitsmith::test {

inline SenseSpec Timer() {
  SenseSpec senses;
  senses.kind = SenseKind::kTimer;
  return senses;
}
/// Two rules of a five-rod figure with a timer: 14 genes.
inline const SearchSpace kSmall{BankShape(2, SenseKind::kTimer, 5), Timer()};
/// One rule of a two-rod figure with a timer: 4 genes.
inline const SearchSpace kTiny{BankShape(1, SenseKind::kTimer, 2), Timer()};

inline constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// Functions over the unit cube with maximum 0.

/// Puts the optimum away from corners and middle, at a point where the ends of intervals (the first genes of
/// seven) are in order.
inline double Off(std::size_t gene, Gene value) { return value / 65535.0 - (gene % 7 % 2 == 0 ? 0.3 : 0.62); }

inline float Sphere(std::span<const Gene> genome) {
  double sum = 0.0;
  for (std::size_t i = 0; i < genome.size(); ++i) sum += Off(i, genome[i]) * Off(i, genome[i]);
  return static_cast<float>(-sum);
}

/// An ellipsoid with valleys of different widths: condition 1e4.
inline float Ellipsoid(std::span<const Gene> genome) {
  double sum = 0.0;
  for (std::size_t i = 0; i < genome.size(); ++i) {
    const double scale = std::pow(1e4, static_cast<double>(i) / static_cast<double>(genome.size() - 1));
    sum += scale * Off(i, genome[i]) * Off(i, genome[i]);
  }
  return static_cast<float>(-sum);
}

inline float Rastrigin(std::span<const Gene> genome) {
  double sum = 0.0;
  for (std::size_t i = 0; i < genome.size(); ++i) {
    const double x = 10.24 * Off(i, genome[i]);
    sum += x * x + 10.0 * (1.0 - std::cos(6.283185307179586 * x));
  }
  return static_cast<float>(-sum);
}

/// A bent valley with its maximum where all Off are 0.
inline float Rosenbrock(std::span<const Gene> genome) {
  double sum = 0.0;
  const auto x = [&](std::size_t i) { return 1.0 + 5.0 * Off(i, genome[i]); };
  for (std::size_t i = 0; i + 1 < genome.size(); ++i) {
    sum += 100.0 * (x(i + 1) - x(i) * x(i)) * (x(i + 1) - x(i) * x(i)) + (1.0 - x(i)) * (1.0 - x(i));
  }
  return static_cast<float>(-sum);
}

/// Similar to onemax: counts genes in the upper half of their range.
inline float CountHigh(std::span<const Gene> genome) {
  return static_cast<float>(std::ranges::count_if(genome, [](Gene gene) { return gene > kGeneMax / 2; }));
}

inline SearchSettings Settings(Algorithm algorithm, int evaluations, std::uint32_t seed = 42) {
  SearchSettings settings;
  settings.algorithm = algorithm;
  settings.evaluations = evaluations;
  settings.seed = seed;
  settings.genetic.population = 20;
  settings.torus = {.side = 5, .walk_steps = 4};
  settings.elites.initial = 20;
  settings.two_stage = {.random = 60, .kept = 3};
  settings.difference.population = 20;
  settings.elites.emitters = 2;
  return settings;
}

inline constexpr auto kAll = AlgorithmColumn(&AlgorithmRow::algorithm);

inline std::string Name(Algorithm algorithm) {
  return std::string(kAlgorithmNames[static_cast<std::size_t>(algorithm)]);
}

}  // namespace gaitsmith::test
