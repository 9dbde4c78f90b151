// SPDX-License-Identifier: MIT
#include "core/search/search.h"

#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>
#include <limits>

#include "core/rollout/evaluator.h"
#include "tests/scene.h"
#include "tests/search_run.h"

namespace gaitsmith::test {

namespace {

const SearchSpace kSpace{BankShape(3, SenseKind::kTimer, 4), [] {
                           SenseSpec senses;
                           senses.kind = SenseKind::kTimer;
                           return senses;
                         }()};

/// A smooth function with its maximum at one genome, so that searches can be tested without physics.
float Hill(std::span<const Gene> genome) {
  double distance = 0.0;
  for (std::size_t i = 0; i < genome.size(); ++i) {
    const double off = (genome[i] - (13107.0 * static_cast<double>(1 + i % 4))) / 65535.0;
    distance += off * off;
  }
  return static_cast<float>(-distance);
}

SearchSettings BriefSettings(Algorithm algorithm, int evaluations) {
  SearchSettings settings;
  settings.algorithm = algorithm;
  settings.evaluations = evaluations;
  settings.seed = 42;
  settings.reseed_interval = 20;
  return settings;
}

/// Figure 5 of the paper, transcribed literally: one genome at a time, without look-ahead.
Outcome SerialSphc(const SearchSettings& settings) {
  struct Individual {
    Genome genome;
    float fitness;
  };
  std::vector<Individual> population;
  Outcome outcome;
  outcome.fitness = -std::numeric_limits<float>::infinity();
  int evaluations = 0;
  const auto note = [&](float fitness) {
    ++evaluations;
    if (outcome.curve.empty() || fitness > outcome.fitness) {
      outcome.curve.push_back({evaluations, fitness});
      outcome.fitness = fitness;
    }
  };
  const auto size = static_cast<std::size_t>(settings.population);
  for (std::size_t i = 0; i < size; ++i) {
    RandomStream random(settings.seed, i, 0);
    Genome genome = RandomGenome(kSpace.shape, kSpace.senses, settings.variation, random);
    const float fitness = Hill(genome);
    population.push_back({std::move(genome), fitness});
    note(fitness);
  }
  for (std::uint64_t generation = 1; evaluations < settings.evaluations; ++generation) {
    for (std::size_t i = 0; i < size && evaluations < settings.evaluations; ++i) {
      RandomStream random(settings.seed, i, generation);
      Genome child = Perturb(population[i].genome, kSpace.shape, kSpace.senses, settings.variation, random);
      const float fitness = Hill(child);
      if (fitness > population[i].fitness) population[i] = {std::move(child), fitness};
      note(fitness);
    }
    if (generation % static_cast<std::uint64_t>(settings.reseed_interval) == 0 &&
        evaluations < settings.evaluations) {
      std::vector<std::size_t> rank(population.size());
      for (std::size_t i = 0; i < rank.size(); ++i) rank[i] = i;
      std::ranges::sort(rank, [&](auto a, auto b) {
        return population[a].fitness != population[b].fitness ? population[a].fitness > population[b].fitness
                                                              : a < b;
      });
      for (std::size_t i = 0; i < rank.size() / 2; ++i)
        population[rank[rank.size() / 2 + i]] = population[rank[i]];
    }
  }
  outcome.best = std::ranges::max_element(population, {}, &Individual::fitness)->genome;
  return outcome;
}

}  // namespace

TEST_CASE("SPHC: looking ahead gives exactly the serial result", "[search]") {
  for (const int budget : {10, 13, 500, 1234, 4000}) {
    const SearchSettings settings = BriefSettings(Algorithm::kSphc, budget);
    const Outcome serial = SerialSphc(settings);
    for (const int wanted : {1, 10, 37, 160, 5000}) {
      CAPTURE(budget, wanted);
      const auto search = MakeSearch(settings, kSpace);
      const Outcome ahead = Run(*search, wanted, Hill);
      REQUIRE(Same(ahead, serial));
      REQUIRE(search->Evaluations() == budget);
    }
  }
}

TEST_CASE("SPHC: asks that do not wait for one another lead to the same end", "[search]") {
  for (const int budget : {7, 333, 4001}) {
    const SearchSettings settings = BriefSettings(Algorithm::kSphc, budget);
    const auto one_by_one = MakeSearch(settings, kSpace);
    const Outcome serial = Run(*one_by_one, 1, Hill);
    for (const std::size_t under_way : {2U, 3U, 7U}) {
      CAPTURE(budget, under_way);
      const auto search = MakeSearch(settings, kSpace);
      REQUIRE(search->AsksAhead());
      std::vector<std::vector<Genome>> asks;  // oldest first
      RandomStream random(11, 0, under_way);
      while (!search->Done()) {
        while (asks.size() < under_way) {
          auto genomes = search->Ask(1 + static_cast<int>(30.0 * random.Uniform()));
          if (genomes.empty()) break;
          asks.push_back(std::move(genomes));
        }
        REQUIRE(!asks.empty());
        std::vector<float> fitness;
        fitness.reserve(asks.front().size());
        for (const Genome& genome : asks.front()) fitness.push_back(Hill(genome));
        asks.erase(asks.begin());
        search->Tell(fitness);
      }
      REQUIRE(search->BestGenome() == serial.best);
      REQUIRE(search->BestFitness() == serial.fitness);
      REQUIRE(search->Evaluations() == budget);
    }
  }
}

TEST_CASE("SPHC: looking ahead one step wastes nothing", "[search]") {
  const auto search = MakeSearch(BriefSettings(Algorithm::kSphc, 1000), kSpace);
  REQUIRE(Run(*search, 10, Hill).scored == 1000);
}

TEST_CASE("SPHC: it looks as far ahead as it is asked to", "[search]") {
  const auto search = MakeSearch(BriefSettings(Algorithm::kSphc, 4000), kSpace);
  search->Tell(std::vector<float>(search->Ask(10).size()));  // the ten starts
  for (const std::size_t wanted : {10u, 40u, 80u}) {
    const std::size_t asked = search->Ask(static_cast<int>(wanted)).size();
    REQUIRE(asked == wanted);
    search->Tell(std::vector<float>(asked));
  }
}

TEST_CASE("RG&T: the best of so many random genomes, however many are asked at a time", "[search]") {
  const SearchSettings settings = BriefSettings(Algorithm::kRandomSearch, 777);
  const auto one = MakeSearch(settings, kSpace);
  const Outcome serial = Run(*one, 1, Hill);
  for (const int wanted : {5, 100, 10000}) {
    const auto many = MakeSearch(settings, kSpace);
    REQUIRE(Same(Run(*many, wanted, Hill), serial));
  }
  REQUIRE(serial.scored == 777);
}

TEST_CASE("search: saved and loaded, it goes on as if nothing had happened", "[search]") {
  for (const Algorithm algorithm : {Algorithm::kRandomSearch, Algorithm::kSphc}) {
    const SearchSettings settings = BriefSettings(algorithm, 900);
    const auto whole = MakeSearch(settings, kSpace);
    const Outcome uninterrupted = Run(*whole, 50, Hill);
    auto search = MakeSearch(settings, kSpace);
    while (!search->Done()) {
      const auto genomes = search->Ask(50);
      std::vector<float> fitness;
      fitness.reserve(genomes.size());
      for (const Genome& genome : genomes) fitness.push_back(Hill(genome));
      search->Tell(fitness);
      BitWriter saved;
      search->Save(saved);
      search = MakeSearch(settings, kSpace);
      BitReader reader(saved.Bytes());
      REQUIRE(search->Load(reader));
    }
    REQUIRE(Same({search->BestGenome(), search->BestFitness(), search->Curve()}, uninterrupted));
  }
}

TEST_CASE("search: a damaged state is refused", "[search]") {
  for (const Algorithm algorithm : {Algorithm::kRandomSearch, Algorithm::kSphc}) {
    const auto search = MakeSearch(BriefSettings(algorithm, 900), kSpace);
    search->Tell(std::vector<float>(search->Ask(10).size(), 1.0f));
    BitWriter saved;
    search->Save(saved);
    auto bytes = saved.Bytes();
    bytes.resize(bytes.size() / 2);
    BitReader cut(bytes);
    const auto loaded = search->Load(cut);
    REQUIRE(!loaded);
    REQUIRE(loaded.error().code == ErrorCode::kTruncated);
    auto longer = saved.Bytes();
    longer.push_back(1);
    BitReader trailing(longer);
    REQUIRE(!search->Load(trailing));
    // The first number counts reseedings or evaluations. Neither can be this large.
    auto impossible = saved.Bytes();
    impossible[3] = 0x7f;
    BitReader beyond(impossible);
    REQUIRE(!search->Load(beyond));
    // A refused state changes nothing: the search continues as before.
    BitWriter after;
    search->Save(after);
    REQUIRE(after.Bytes() == saved.Bytes());
  }
}

TEST_CASE("SPHC: a state that has reseeded more often than its budget lets it is refused", "[search]") {
  const SearchSettings settings = BriefSettings(Algorithm::kSphc, 900);  // 90 generations: 4 reseedings
  const auto search = MakeSearch(settings, kSpace);
  Run(*search, 50, Hill);
  BitWriter saved;
  search->Save(saved);
  for (const int reseedings : {4, 5, 100}) {
    CAPTURE(reseedings);
    auto bytes = saved.Bytes();
    bytes[0] = static_cast<std::uint8_t>(reseedings);
    BitReader reader(bytes);
    CHECK(search->Load(reader).has_value() == (reseedings == 4));
  }
}

TEST_CASE("search: NaN loses to everything", "[search]") {
  for (const Algorithm algorithm : {Algorithm::kRandomSearch, Algorithm::kSphc}) {
    int asked = 0;
    const auto search = MakeSearch(BriefSettings(algorithm, 300), kSpace);
    const Outcome outcome = Run(*search, 30, [&](const Genome& genome) {
      return ++asked % 3 == 1 ? std::numeric_limits<float>::quiet_NaN() : Hill(genome);
    });
    REQUIRE(std::isfinite(outcome.fitness));
    REQUIRE(outcome.fitness == Hill(outcome.best));
  }
}

TEST_CASE("search: the curve rises and ends at the best", "[search]") {
  const auto search = MakeSearch(BriefSettings(Algorithm::kSphc, 2000), kSpace);
  const Outcome outcome = Run(*search, 80, Hill);
  REQUIRE(outcome.curve.front().evaluation == 1);
  for (std::size_t i = 1; i < outcome.curve.size(); ++i) {
    REQUIRE(outcome.curve[i].evaluation > outcome.curve[i - 1].evaluation);
    REQUIRE(outcome.curve[i].best > outcome.curve[i - 1].best);
  }
  REQUIRE(outcome.curve.back().best == outcome.fitness);
}

}  // namespace gaitsmith::test
