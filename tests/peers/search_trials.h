// SPDX-License-Identifier: MIT
// Trials of our searches on known functions, for the comparison with another library's (search_judge.cpp) and
// for the test that keeps its rows (tests/core/evolution/search_rows_test.cpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/evolution/nsga.h"
#include "core/search/search.h"

namespace gaitsmith::test {

/// Functions of the unit cube, to be minimised; the least value is 0.
struct KnownFunction {
  std::string_view name;
  double (*value)(std::span<const double>);
};

inline double Moved(double x, std::size_t i) { return x - (i % 2 == 0 ? 0.3 : 0.62); }
inline double SphereOf(std::span<const double> x) {
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += Moved(x[i], i) * Moved(x[i], i);
  return sum;
}
inline double EllipsoidOf(std::span<const double> x) {
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i)
    sum += std::pow(1e4, static_cast<double>(i) / static_cast<double>(x.size() - 1)) * Moved(x[i], i) *
           Moved(x[i], i);
  return sum;
}
inline double RosenbrockOf(std::span<const double> x) {
  double sum = 0.0;
  const auto at = [&](std::size_t i) { return 1.0 + 5.0 * Moved(x[i], i); };
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    const double bend = at(i + 1) - at(i) * at(i);
    sum += 100.0 * bend * bend + (1.0 - at(i)) * (1.0 - at(i));
  }
  return sum;
}
inline double RastriginOf(std::span<const double> x) {
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double y = 10.24 * Moved(x[i], i);
    sum += y * y + 10.0 * (1.0 - std::cos(6.283185307179586 * y));
  }
  return sum;
}
inline constexpr KnownFunction kKnownFunctions[] = {{"sphere", SphereOf},
                                                    {"ellipsoid", EllipsoidOf},
                                                    {"rosenbrock", RosenbrockOf},
                                                    {"rastrigin", RastriginOf}};

/// Two aims to be minimised on the unit cube [Zitzler Deb Thiele 2000]: ZDT1 with a convex front
/// f2 = 1 - sqrt(f1), ZDT2 with one that is not, f2 = 1 - f1^2.
struct TwoAims {
  std::string_view name;
  double (*front)(double f1);
};
inline double ConvexFront(double f1) { return 1.0 - std::sqrt(f1); }
inline double HollowFront(double f1) { return 1.0 - f1 * f1; }
inline constexpr TwoAims kTwoAims[] = {{"zdt1", ConvexFront}, {"zdt2", HollowFront}};
/// f1 and f2.
inline std::array<double, 2> ValuesOf(const TwoAims& aims, std::span<const double> x) {
  double sum = 0.0;
  for (std::size_t i = 1; i < x.size(); ++i) sum += x[i];
  const double g = 1.0 + 9.0 * sum / static_cast<double>(x.size() - 1);
  return {x[0], g * aims.front(x[0] / g)};
}

/// What a set of points leaves of the square [0, 1.1]^2, by area: 0 if it covers all, and less is better.
inline double Uncovered(std::vector<std::array<double, 2>> points) {
  constexpr double kEnd = 1.1;
  std::ranges::sort(points);
  double covered = 0.0, least = kEnd;
  for (const auto& [first, second] : points) {
    if (first >= kEnd || second >= least) continue;
    covered += (kEnd - first) * (least - second);
    least = second;
  }
  return kEnd * kEnd - covered;
}

/// Genes without meaning, and without intervals, whose ends would be kept in order.
inline SearchSpace SpaceOfNumbers(int count) {
  SenseSpec timer;
  timer.kind = SenseKind::kTimer;
  return {ControllerShape(ControllerKind::kTrajectory, count / 2, SenseKind::kTimer, 3), timer};
}

/// The least value that a search finds.
inline double LeastValue(const SearchSettings& settings, int numbers, const KnownFunction& function) {
  const SearchSpace space = SpaceOfNumbers(numbers);
  const auto search = MakeSearch(settings, space);
  double least = HUGE_VAL;
  while (!search->Done()) {
    std::vector<float> fitness;
    for (const Genome& genome : search->Ask(1000)) {
      const double value = function.value(PointOf(genome));
      least = std::min(least, value);
      fitness.push_back(static_cast<float>(-value));
    }
    search->Tell(fitness);
  }
  return least;
}

/// What the front that NSGA-II finds leaves uncovered.
inline double FrontLeaves(const SearchSettings& settings, int numbers, const TwoAims& aims) {
  const SearchSpace space = SpaceOfNumbers(numbers);
  const auto search = MakeSearch(settings, space);
  while (!search->Done()) {
    std::vector<Score> scores;
    for (const Genome& genome : search->Ask(1000)) {
      const auto [first, second] = ValuesOf(aims, PointOf(genome));
      Score score{.fitness = static_cast<float>(-second)};
      score.traits[static_cast<std::size_t>(Trait::kEffort)] = static_cast<float>(first);
      scores.push_back(score);
    }
    search->Tell(scores);
  }
  BitWriter saved;
  search->Save(saved);
  std::vector<std::array<double, 2>> points;
  for (const Compromise& one :
       FrontOf(settings, space.shape.Genes(), saved.Bytes()).value_or(std::vector<Compromise>{}))
    points.push_back({0.0 - static_cast<double>(one.aims.thrift), 0.0 - static_cast<double>(one.aims.score)});
  return Uncovered(std::move(points));
}

/// A row of the comparison.
struct SearchRow {
  std::string_view search, function;
  int numbers, generations, population;

  [[nodiscard]] SearchSettings Settings(std::uint32_t seed) const {
    SearchSettings settings;
    settings.seed = seed;
    settings.evaluations = (generations + 1) * population;
    if (search == "de") {
      settings.algorithm = Algorithm::kDifferentialEvolution;
      settings.difference.population = population;
    } else if (search == "nsga-ii") {
      settings.algorithm = Algorithm::kNsga;
      settings.genetic.population = population;
      settings.genetic.rates = {.mutation = 1.0f / static_cast<float>(numbers), .crossover = 0.95f};
      settings.genetic.rates.crossing = Crossing::kBlended;
    } else {
      settings.algorithm = Algorithm::kCmaEs;
      settings.cma = {.covariance = Covariance::kFull, .population = population, .draws = population};
    }
    return settings;
  }
  /// What our search reaches with a seed.
  [[nodiscard]] double Reached(std::uint32_t seed) const {
    for (const KnownFunction& known : kKnownFunctions)
      if (known.name == function) return LeastValue(Settings(seed), numbers, known);
    for (const TwoAims& aims : kTwoAims)
      if (aims.name == function) return FrontLeaves(Settings(seed), numbers, aims);
    return HUGE_VAL;
  }
};

/// Budgets that end before either side reaches the 16-bit grid of genes.
inline constexpr SearchRow kSearchRows[] = {
    {"de", "sphere", 10, 60, 50},          {"de", "ellipsoid", 10, 120, 50},
    {"de", "rosenbrock", 10, 200, 50},     {"de", "rastrigin", 10, 300, 50},
    {"cma-es", "sphere", 10, 60, 10},      {"cma-es", "ellipsoid", 10, 120, 10},
    {"cma-es", "rosenbrock", 10, 150, 10}, {"nsga-ii", "zdt1", 30, 100, 100},
    {"nsga-ii", "zdt2", 30, 100, 100},
};
inline constexpr int kSearchTrials = 51;

}  // namespace gaitsmith::test
