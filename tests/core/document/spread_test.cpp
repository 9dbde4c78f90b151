// SPDX-License-Identifier: MIT
// The spread of a population: its numbers, its members, and that reading it does not change a search.
#include "core/search/spread.h"

#include "core/evolution/map_elites.h"
#include "tests/known_functions.h"
#include "tests/search_run.h"

namespace gaitsmith::test {

TEST_CASE("spread: quantiles lie between members, whatever their order", "[spread]") {
  const auto spread = SpreadOf({4.0f, 1.0f, 2.0f, 8.0f});
  REQUIRE(spread);
  CHECK(spread->members == 4);
  CHECK(spread->least == 1.0f);
  CHECK(spread->lower_quartile == 1.75f);
  CHECK(spread->median == 3.0f);
  CHECK(spread->upper_quartile == 5.0f);
  CHECK(spread->best == 8.0f);
  CHECK(SpreadOf({3.0f, 3.0f})->lower_quartile == 3.0f);
}

TEST_CASE("spread: what has no motion does not count, and one alone has no spread", "[spread]") {
  const auto spread = SpreadOf({2.0f, -1e9f, kNan, 1.0f, -std::numeric_limits<float>::infinity()});
  REQUIRE(spread);
  CHECK(spread->members == 2);
  CHECK(spread->least == 1.0f);
  CHECK_FALSE(SpreadOf({}));
  CHECK_FALSE(SpreadOf({1.0f, -1e9f}));
}

TEST_CASE("every search: to look at its population changes nothing", "[search][spread]") {
  for (const Algorithm algorithm : kAll) {
    CAPTURE(Name(algorithm));
    const auto alone = MakeSearch(Settings(algorithm, 777), kSmall);
    const auto watched = MakeSearch(Settings(algorithm, 777), kSmall);
    const Outcome undisturbed = Run(*alone, 30, Rastrigin);
    const Outcome seen = Run(*watched, 30, [&](const Genome& genome) {
      static_cast<void>(watched->PopulationFitness());
      return Rastrigin(genome);
    });
    CHECK(Same(seen, undisturbed));
    BitWriter one, other;
    alone->Save(one);
    watched->Save(other);
    CHECK(one.Bytes() == other.Bytes());
  }
}

TEST_CASE("every search: its population is as large as it should be, and no better than the best",
          "[search][spread]") {
  const auto members = [](Algorithm algorithm, const SearchSettings& s) -> std::size_t {
    const std::size_t genes = kSmall.shape.Genes();
    switch (algorithm) {
      case Algorithm::kRandomSearch:
        return 0;
      case Algorithm::kShc:
      case Algorithm::kPowell:
      case Algorithm::kPoseCycle:
        return 1;
      case Algorithm::kSphc:
        return static_cast<std::size_t>(s.population);
      case Algorithm::kGga:
      case Algorithm::kSsga:
      case Algorithm::kNsga:
        return static_cast<std::size_t>(s.genetic.population);
      case Algorithm::kMpga:
        return static_cast<std::size_t>(s.torus.side) * static_cast<std::size_t>(s.torus.side);
      case Algorithm::kNelderMead:
        return genes + 1;
      case Algorithm::kDifferentialEvolution:
        return static_cast<std::size_t>(s.difference.population);
      case Algorithm::kTwoStage:
        return static_cast<std::size_t>(s.two_stage.kept);
      case Algorithm::kCmaEs:
      case Algorithm::kMapElites:
      case Algorithm::kCmaMae:
        return 0;  // grows
    }
    return 0;
  };
  for (const Algorithm algorithm : kAll) {
    CAPTURE(Name(algorithm));
    // A collapsed simplex starts again at one vertex.
    const SearchSettings settings = Settings(algorithm, algorithm == Algorithm::kNelderMead ? 100 : 2000);
    const auto search = MakeSearch(settings, kSmall);
    CHECK(search->PopulationFitness().empty());
    const Outcome outcome = Run(*search, 10, Sphere);
    const std::vector<float> fitness = search->PopulationFitness();
    const bool grows = algorithm == Algorithm::kCmaEs || algorithm == Algorithm::kMapElites ||
                       algorithm == Algorithm::kCmaMae;
    if (grows) {
      CHECK(fitness.size() >= (algorithm == Algorithm::kCmaEs ? 4u : 1u));
    } else {
      CHECK(fitness.size() == members(algorithm, settings));
    }
    for (const float value : fitness) CHECK(value <= outcome.fitness);
    // If the algorithm keeps the best, the best is a member.
    const bool keeps_best = algorithm != Algorithm::kRandomSearch && algorithm != Algorithm::kGga &&
                            algorithm != Algorithm::kMpga && algorithm != Algorithm::kCmaEs &&
                            algorithm != Algorithm::kPowell && algorithm != Algorithm::kNelderMead &&
                            algorithm != Algorithm::kPoseCycle;
    if (keeps_best) CHECK(std::ranges::max(fitness) == outcome.fitness);
  }
}

TEST_CASE("spread: of CMA-ES it is the last generation's, and comes back with the first one after a load",
          "[search][spread]") {
  const SearchSettings settings = Settings(Algorithm::kCmaEs, 600);
  auto search = MakeSearch(settings, kSmall);
  const auto batch = [&] {
    std::vector<float> fitness;
    for (const Genome& genome : search->Ask(100000)) fitness.push_back(Sphere(genome));
    search->Tell(fitness);
    return fitness;
  };
  batch();
  const std::vector<float> before = batch();
  CHECK(search->PopulationFitness() == before);
  BitWriter saved;
  search->Save(saved);
  search = MakeSearch(settings, kSmall);
  BitReader in(saved.Bytes());
  REQUIRE(search->Load(in));
  CHECK(search->PopulationFitness().empty());
  CHECK(search->PopulationFitness() != before);
  const std::vector<float> next = batch();
  CHECK(search->PopulationFitness() == next);
}

}  // namespace gaitsmith::test
