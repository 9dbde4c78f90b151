// SPDX-License-Identifier: MIT
// Every search gets close to known optima within a budget.

#include "tests/known_functions.h"
#include "tests/search_run.h"

namespace gaitsmith::test {

TEST_CASE("searches find known optima within their budgets", "[search]") {
  struct Expectation {
    Algorithm algorithm;
    float (*function)(std::span<const Gene>);
    const SearchSpace* space;
    int evaluations;
    float at_least;  // least fitness for each of the seeds 1 to 3
  };
  // The bounds come from measurements with these seeds. They guard against decay and prove no rate of
  // convergence.
  const Expectation expectations[] = {
      {Algorithm::kCmaEs, Sphere, &kSmall, 2500, -1e-6f},
      {Algorithm::kCmaEs, Ellipsoid, &kSmall, 6000, -1e-4f},
      {Algorithm::kCmaEs, Rosenbrock, &kSmall, 20000, -1e-3f},
      {Algorithm::kCmaEs, Rastrigin, &kTiny, 20000, -1e-3f},
      {Algorithm::kNelderMead, Sphere, &kTiny, 600, -1e-6f},
      {Algorithm::kNelderMead, Rosenbrock, &kTiny, 3000, -1e-3f},
      {Algorithm::kPowell, Sphere, &kSmall, 600, -1e-6f},
      {Algorithm::kPowell, Ellipsoid, &kSmall, 600, -1e-4f},
      {Algorithm::kPowell, Rosenbrock, &kTiny, 4000, -1e-2f},
      {Algorithm::kPowell, Rastrigin, &kSmall, 4000, -60.0f},
      {Algorithm::kSphc, Sphere, &kSmall, 6000, -5e-3f},
      {Algorithm::kShc, Sphere, &kSmall, 6000, -5e-3f},
      {Algorithm::kSsga, Sphere, &kSmall, 6000, -1e-2f},
      {Algorithm::kGga, Sphere, &kSmall, 6000, -0.1f},
      {Algorithm::kMpga, Sphere, &kSmall, 6000, -3e-2f},
      {Algorithm::kMapElites, Sphere, &kSmall, 6000, -5e-3f},
      {Algorithm::kTwoStage, Sphere, &kSmall, 6000, -5e-3f},
      {Algorithm::kPoseCycle, Sphere, &kSmall, 6000, -5e-3f},
      {Algorithm::kDifferentialEvolution, Sphere, &kSmall, 6000, -2e-3f},
      {Algorithm::kDifferentialEvolution, Ellipsoid, &kSmall, 10000, -0.1f},
      {Algorithm::kDifferentialEvolution, Rastrigin, &kTiny, 6000, -1.1f},
      {Algorithm::kNsga, Sphere, &kSmall, 6000, -3e-2f},
      {Algorithm::kCmaMae, Sphere, &kSmall, 6000, -1e-3f},
      {Algorithm::kShc, CountHigh, &kSmall, 6000, 14.0f},
      {Algorithm::kSsga, CountHigh, &kSmall, 6000, 13.0f},
      {Algorithm::kGga, CountHigh, &kSmall, 6000, 12.0f},
      {Algorithm::kMpga, CountHigh, &kSmall, 6000, 13.0f},
  };
  for (const Expectation& e : expectations) {
    for (std::uint32_t seed = 1; seed <= 3; ++seed) {
      CAPTURE(Name(e.algorithm), e.evaluations, &e - expectations, seed);
      const auto search = MakeSearch(Settings(e.algorithm, e.evaluations, seed), *e.space);
      CHECK(Run(*search, 100, e.function).fitness >= e.at_least);
    }
  }
}

TEST_CASE("CMA-ES: separable where valleys lie along the genes, full where they do not", "[search]") {
  const auto best = [](Covariance covariance, auto function) {
    SearchSettings settings = Settings(Algorithm::kCmaEs, 4000);
    settings.cma.covariance = covariance;
    const auto search = MakeSearch(settings, kSmall);
    return Run(*search, 50, function).fitness;
  };
  CHECK(best(Covariance::kSeparable, Ellipsoid) > best(Covariance::kFull, Ellipsoid) - 1e-4f);
  CHECK(best(Covariance::kAutomatic, Rosenbrock) == best(Covariance::kFull, Rosenbrock));
}

}  // namespace gaitsmith::test
