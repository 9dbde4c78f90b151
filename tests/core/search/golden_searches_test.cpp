// SPDX-License-Identifier: MIT
// Pins: what every search finds, on the way and at its end, with the settings of tests and with others, for
// banks of rules and a network. A document contains its search, so the same seed must find the same motion
// for ever. The functions only add and multiply, so their bits are the same everywhere. To bless again (only
// by a numbered decision in docs/design.md):
//   tests/golden/bless build/release/shell/gaitsmith build/dev/tests/gaitsmith_tests
#include <catch_amalgamated.hpp>
#include <cstdio>
#include <sstream>

#include "core/physics/trajectory_hash.h"
#include "tests/known_functions.h"
#include "tests/scene.h"
#include "tests/search_run.h"

namespace gaitsmith::test {

namespace {

/// Every number and every choice differs from those of known_functions.h.
SearchSettings OtherSettings(Algorithm algorithm) {
  SearchSettings settings;
  settings.algorithm = algorithm;
  settings.seed = 7;
  settings.evaluations = 1500;
  settings.population = 4;
  settings.reseed_interval = 30;
  settings.genetic = {.population = 31,
                      .rates = {.mutation = 0.02f, .crossover = 0.8f, .reading = RateReading::kPerComponent},
                      .rank_bias = 1.8f};
  settings.torus = {.side = 6, .walk_steps = 7};
  settings.refine.step = 0.03f;
  settings.cma = {.genes = CmaGenes::kAll,
                  .covariance = Covariance::kSeparable,
                  .population = 9,
                  .step = 0.2f,
                  .growth = 1.5f,
                  .draws = 3};
  settings.elites = {.initial = 40, .batch = 7, .bins = 5, .most = {1.0f, 2.0f, 3.0f}};
  settings.two_stage = {.random = 200, .kept = 2};
  settings.difference = {.population = 15, .weight = 0.8f, .crossover = 0.3f};
  return settings;
}

/// Fitness, and a style that covers the bins.
std::vector<Score> ScoresOf(const std::vector<Genome>& genomes, float (*function)(std::span<const Gene>)) {
  std::vector<Score> scores;
  for (const Genome& genome : genomes) {
    const auto share = [&](std::size_t gene) { return static_cast<float>(genome[gene]) / 65536.0f; };
    scores.push_back({function(genome), {4.5f * share(0), 11.0f * share(1), 4.5f * share(2)}});
  }
  return scores;
}

std::string EndOf(const SearchSettings& settings, const SearchSpace& space,
                  float (*function)(std::span<const Gene>)) {
  const auto search = MakeSearch(settings, space);
  const Outcome outcome = RunInBatches(
      *search, 16, [&](const std::vector<Genome>& genomes) { return ScoresOf(genomes, function); });
  TrajectoryHash hash;
  for (const Gene gene : outcome.best) hash.Add(static_cast<double>(gene));
  for (const auto& [evaluation, best] : outcome.curve) {
    hash.Add(static_cast<double>(evaluation));
    hash.Add(best);
  }
  for (const float fitness : search->PopulationFitness()) hash.Add(fitness);
  return HashText(hash.Value());
}

std::string AllEnds() {
  SearchSpace begun = kSmall;
  RandomStream random(5, 0, 0);
  begun.start = RandomGenome(kSmall.shape, kSmall.senses, {}, random);
  const SearchSpace bank{BankShape(3, SenseKind::kPhysical, 3), {}};
  const SearchSpace network{ControllerShape(ControllerKind::kNetwork, 2, SenseKind::kPhysical, 3), {}};
  std::ostringstream ends;
  for (const Algorithm algorithm : kAll) {
    const auto end = [&](const char* what, const SearchSettings& settings, const SearchSpace& space,
                         float (*function)(std::span<const Gene>)) {
      ends << Name(algorithm) << ' ' << what << ' ' << EndOf(settings, space, function) << '\n';
    };
    end("sphere", Settings(algorithm, 2000), kSmall, Sphere);
    end("valley", Settings(algorithm, 2000, 3), kSmall, Rosenbrock);
    end("begun", Settings(algorithm, 600, 4), begun, Rosenbrock);
    end("bank", Settings(algorithm, 1000, 5), bank, Sphere);
    end("network", Settings(algorithm, 1000, 6), network, Sphere);
    end("other", OtherSettings(algorithm), bank, Sphere);
    SearchSettings full = OtherSettings(algorithm);
    full.cma.covariance = Covariance::kFull;
    full.cma.genes = CmaGenes::kCared;
    full.genetic.rates.reading = RateReading::kPerChild;
    end("full", full, bank, Rosenbrock);
  }
  return ends.str();
}

}  // namespace

TEST_CASE("golden: every search ends where it always ended", "[search][determinism]") {
  std::istringstream pinned(ReadFile("tests/golden/search_ends.txt")), found(AllEnds());
  int ends = 0;
  for (std::string was, is; std::getline(found, is); ++ends) {
    REQUIRE(std::getline(pinned, was));
    CHECK(is == was);
  }
  CHECK(ends == 105);
}

TEST_CASE("bless the ends of searches", "[.bless]") { std::fputs(AllEnds().c_str(), stdout); }

}  // namespace gaitsmith::test
