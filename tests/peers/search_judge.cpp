// SPDX-License-Identifier: MIT
// Our searches beside pagmo's on known functions, with the same populations, generations and parameters, in
// one run. Prints a table: medians and quartiles over the seeds, less is better.
//   search_judge >docs/studies/peers/searches.csv

#include <cstdio>
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/cmaes.hpp>
#include <pagmo/algorithms/de.hpp>
#include <pagmo/algorithms/nsga2.hpp>
#include <pagmo/algorithms/xnes.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>

#include "tests/peers/search_trials.h"

namespace {

using namespace gaitsmith::test;

/// A known function as pagmo's problem.
struct Known {
  std::string function = {};
  int numbers = 1;

  [[nodiscard]] pagmo::vector_double fitness(const pagmo::vector_double& x) const {
    for (const KnownFunction& known : kKnownFunctions)
      if (known.name == function) return {known.value(x)};
    for (const TwoAims& aims : kTwoAims)
      if (aims.name == function) {
        const auto [first, second] = ValuesOf(aims, x);
        return {first, second};
      }
    return {};
  }
  [[nodiscard]] std::size_t get_nobj() const { return function.starts_with("zdt") ? 2 : 1; }
  [[nodiscard]] std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
    const auto size = static_cast<std::size_t>(numbers);
    return {pagmo::vector_double(size, 0.0), pagmo::vector_double(size, 1.0)};
  }
};

/// What pagmo's search of this name reaches.
double Theirs(const SearchRow& row, std::string_view search, unsigned seed) {
  const auto generations = static_cast<unsigned>(row.generations);
  pagmo::algorithm algorithm = [&] {
    if (search == "de") return pagmo::algorithm(pagmo::de(generations, 0.5, 0.9, 7u, 0.0, 0.0, seed));
    if (search == "nsga-ii")
      return pagmo::algorithm(pagmo::nsga2(generations, 0.95, 10.0, 1.0 / row.numbers, 50.0, seed));
    if (search == "xnes")
      return pagmo::algorithm(pagmo::xnes(generations, -1, -1, -1, 0.3, 0.0, 0.0, false, true, seed));
    return pagmo::algorithm(pagmo::cmaes(generations, -1, -1, -1, -1, 0.3, 0.0, 0.0, false, true, seed));
  }();
  pagmo::population population(pagmo::problem(Known{std::string(row.function), row.numbers}),
                               static_cast<std::size_t>(row.population), seed);
  population = algorithm.evolve(population);
  if (population.get_problem().get_nobj() == 1) return population.champion_f()[0];
  std::vector<std::array<double, 2>> points;
  for (const pagmo::vector_double& values : population.get_f()) points.push_back({values[0], values[1]});
  return Uncovered(std::move(points));
}

double Quantile(std::vector<double>& values, double share) {
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

}  // namespace

int main() {
  std::puts(
      "search,function,numbers,population,evaluations,trials,ours,ours_q1,ours_q3,rival,theirs,theirs_q1,"
      "theirs_q3,within");
  for (const SearchRow& row : kSearchRows) {
    std::vector<double> ours;
    for (std::uint32_t seed = 1; seed <= kSearchTrials; ++seed) ours.push_back(row.Reached(seed));
    std::vector<std::string_view> rivals = {row.search};
    if (row.search == "cma-es") rivals.emplace_back("xnes");
    for (const std::string_view rival : rivals) {
      std::vector<double> theirs;
      for (unsigned seed = 1; seed <= kSearchTrials; ++seed) theirs.push_back(Theirs(row, rival, seed));
      const double median = Quantile(ours, 0.5), low = Quantile(theirs, 0.25), high = Quantile(theirs, 0.75);
      std::printf("%s,%s,%d,%d,%d,%d,%.9g,%.3g,%.3g,%s,%.3g,%.3g,%.3g,%s\n", row.search.data(),
                  row.function.data(), row.numbers, row.population, (row.generations + 1) * row.population,
                  kSearchTrials, median, Quantile(ours, 0.25), Quantile(ours, 0.75), rival.data(),
                  Quantile(theirs, 0.5), low, high,
                  median < low    ? "better"
                  : median > high ? "worse"
                                  : "yes");
    }
  }
}
