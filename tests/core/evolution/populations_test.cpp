// SPDX-License-Identifier: MIT
// What the searches that keep a population promise beyond what every search does.
#include "core/evolution/cma_mae.h"
#include "core/evolution/generational_ga.h"
#include "core/evolution/map_elites.h"
#include "core/evolution/nsga.h"
#include "tests/known_functions.h"
#include "tests/search_run.h"

namespace gaitsmith::test {

namespace {

double Share(const Genome& genome, std::size_t gene) { return genome[gene] / 65535.0; }

/// Mean distance of all genes from a value, as a share of their range.
double From(const Genome& genome, double value) {
  double sum = 0.0;
  for (std::size_t i = 0; i < genome.size(); ++i) sum += std::abs(Share(genome, i) - value);
  return sum / static_cast<double>(genome.size());
}

/// Two peaks of the same height, far from each other.
float TwoPeaks(const Genome& genome) {
  return static_cast<float>(1.0 - 4.0 * std::min(From(genome, 0.2), From(genome, 0.8)));
}

/// A style that covers the bins, from genes that are no ends of intervals.
Score Styled(const Genome& genome, float fitness) {
  const auto share = [&](std::size_t gene) { return static_cast<float>(Share(genome, gene)); };
  return {fitness, {4.5f * share(2), 11.0f * share(3), 4.5f * share(4)}, {}};
}

template <class OneScore>
void RunScored(Search& search, OneScore score) {
  while (!search.Done()) {
    std::vector<Score> scores;
    for (const Genome& genome : search.Ask(64)) scores.push_back(score(genome));
    search.Tell(scores);
  }
}

}  // namespace

TEST_CASE("niching: counts are of those that are alike", "[search]") {
  const std::size_t genes = kSmall.shape.Genes();
  const std::vector<Individual> population = {
      {Genome(genes, 1000), 1.0f}, {Genome(genes, 1000), 1.0f}, {Genome(genes, 60000), 1.0f}};
  CHECK(NicheCounts(population) == std::vector<double>{2.0, 2.0, 1.0});
  // Shared, the pair has as good a chance as the one.
  const std::vector<double> wheel = RouletteWheel({{{}, 2.0f}, {{}, 2.0f}, {{}, 2.0f}, {{}, 0.0f}},
                                                  std::vector<double>{2.0, 2.0, 1.0, 1.0});
  CHECK(wheel == std::vector<double>{1.0, 2.0, 4.0, 4.0});
}

TEST_CASE("niching: two kinds live side by side where without it one takes over", "[search]") {
  for (const Algorithm algorithm : {Algorithm::kGga, Algorithm::kSsga}) {
    const auto both = [&](Niching niching) {
      int times = 0;
      for (std::uint32_t seed = 1; seed <= 10; ++seed) {
        SearchSettings settings = Settings(algorithm, 8000, seed);
        settings.genetic.population = 40;
        settings.genetic.niching = niching;
        settings.genetic.rates.mutation = 0.5f;  // one rule: hybrids are copies
        settings.variation.redraw = 0.0f;
        const auto search = MakeSearch(settings, kTiny);
        std::vector<Genome> last;  // of those that were tried
        while (!search->Done()) {
          std::vector<float> fitness;
          for (const Genome& genome : search->Ask(64)) {
            fitness.push_back(TwoPeaks(genome));
            if (search->Evaluations() > 7000) last.push_back(genome);
          }
          search->Tell(fitness);
        }
        const auto near = [&](double peak) {
          return std::ranges::count_if(last, [&](const Genome& g) { return From(g, peak) < 0.15; });
        };
        times += std::min(near(0.2), near(0.8)) * 10 >= std::ssize(last) ? 1 : 0;
      }
      return times;
    };
    CAPTURE(Name(algorithm));
    const int with = both(Niching::kKept), without = both(Niching::kNone);
    CAPTURE(with, without);
    CHECK(with >= 8);
    CHECK(without <= 3);
  }
}

TEST_CASE("differential evolution: without weight and mixing, rivals are members", "[search]") {
  SearchSettings settings = Settings(Algorithm::kDifferentialEvolution, 200);
  settings.difference = {.population = 20, .weight = 0.0f, .crossover = 1.0f};
  const auto search = MakeSearch(settings, kSmall);
  const std::vector<Genome> first = search->Ask(100);
  REQUIRE(first.size() == 20);
  std::vector<float> fitness;
  fitness.reserve(first.size());
  for (const Genome& genome : first) fitness.push_back(Sphere(genome));
  search->Tell(fitness);
  const std::vector<Genome> rivals = search->Ask(100);
  REQUIRE(rivals.size() == 20);
  for (std::size_t i = 0; i < rivals.size(); ++i) {
    const auto of = std::ranges::find(first, rivals[i]);
    REQUIRE(of != first.end());
    CHECK(of - first.begin() != static_cast<std::ptrdiff_t>(i));  // another member's
  }
}

TEST_CASE("differential evolution: a sense that all members ignore stays ignored", "[search]") {
  const SearchSpace space{BankShape(3, SenseKind::kPhysical, 3), SenseSpec{}};
  SearchSettings settings = Settings(Algorithm::kDifferentialEvolution, 300);
  settings.variation.dont_care = 1.0f;
  const BankShape& bank = space.shape.Bank();
  Run(*MakeSearch(settings, space), 50, [&](const Genome& genome) {
    for (int rule = 0; rule < bank.rules; ++rule) {
      for (int sense = 0; sense < bank.senses; ++sense) REQUIRE(!bank.Cares(genome, rule, sense));
    }
    return CountHigh(genome);
  });
}

TEST_CASE("BIPOP: runs of large and of small populations spend as much", "[search]") {
  SearchSettings settings = Settings(Algorithm::kCmaEs, 30000);
  settings.cma.restarts = Restarts::kBipop;
  settings.cma.draws = 1;
  const auto search = MakeSearch(settings, kSmall);
  const int usual = CmaDistribution::UsualPopulation(kSmall.shape.Genes());
  std::vector<int> runs;  // their populations
  int large = 0, small = 0, largest = usual;
  bool begins = false;
  while (!search->Done()) {
    const auto size = static_cast<int>(search->Ask(100000).size());
    search->Tell(
        std::vector<float>(static_cast<std::size_t>(size), 1.0f));  // never better, so every run stalls
    if (size == 1) {
      begins = true;
      continue;
    }
    if (std::exchange(begins, false)) runs.push_back(size);
    const bool is_large = runs.back() >= largest;
    largest = std::max(largest, runs.back());
    (is_large ? large : small) += size;
  }
  REQUIRE(runs.size() > 6);
  CHECK(runs[0] == usual);
  CHECK(runs[1] == 2 * usual);
  for (const int run : runs) CHECK(run >= usual);
  CHECK(std::ranges::count_if(runs, [&](int run) { return run < largest; }) > 3);
  // The kind that has spent less goes next, so they differ by one large run at most.
  CHECK(std::abs(large - small) < 60 * largest);
  // Growing runs only grow.
  settings.cma.restarts = Restarts::kGrowing;
  CHECK(MakeSearch(settings, kSmall)->Ask(100000).size() == 1);
}

TEST_CASE("MAP-Elites: children have whole rules of two elites where they are mixed", "[search]") {
  const SearchSpace space{BankShape(10, SenseKind::kTimer, 3), Timer()};
  const auto size = static_cast<std::size_t>(space.shape.Bank().GenesPerRule());
  const auto mixed = [&](float crossover) {
    SearchSettings settings = Settings(Algorithm::kMapElites, 200);
    settings.elites.crossover = crossover;
    settings.variation.gene_chance = 0.001f;
    settings.variation.redraw = 0.0f;
    const auto search = MakeSearch(settings, space);
    const std::vector<Genome> parents = search->Ask(1000);
    std::vector<Score> scores;
    scores.reserve(parents.size());
    for (const Genome& genome : parents) scores.push_back(Styled(genome, 1.0f));
    search->Tell(scores);
    int hybrids = 0;
    for (const Genome& child : search->Ask(1000)) {
      std::vector<std::size_t> of;  // the parents with a rule of the child
      for (std::size_t i = 0; i < parents.size(); ++i) {
        for (std::size_t at = 0; at < child.size(); at += size) {
          if (!std::ranges::equal(std::span(child).subspan(at, size),
                                  std::span(parents[i]).subspan(at, size)))
            continue;
          of.push_back(i);
          break;
        }
      }
      hybrids += of.size() > 1 ? 1 : 0;
    }
    return hybrids;
  };
  CHECK(mixed(0.0f) == 0);
  CHECK(mixed(1.0f) > 24);  // of 32; a parent can be drawn twice
}

TEST_CASE("CMA-MAE: fills the grid, and with alpha 0 it climbs", "[search]") {
  const auto run = [&](Algorithm algorithm, float learning) {
    SearchSettings settings = Settings(algorithm, 6000, 3);
    settings.elites.learning = learning;
    const auto search = MakeSearch(settings, kSmall);
    RunScored(*search, [](const Genome& genome) { return Styled(genome, Sphere(genome)); });
    return std::pair(search->PopulationFitness().size(), search->BestFitness());
  };
  const auto [climbed_cells, climbed] = run(Algorithm::kCmaMae, 0.0f);
  const auto [spread_cells, spread] = run(Algorithm::kCmaMae, 0.1f);
  CAPTURE(climbed_cells, climbed, spread_cells, spread);
  CHECK(climbed > -1e-4f);
  CHECK(spread_cells > climbed_cells);
  CHECK(spread_cells > 200);
}

TEST_CASE("elites: a saved CMA-MAE shows its grid", "[search]") {
  const SearchSettings settings = Settings(Algorithm::kCmaMae, 900);
  const auto search = MakeSearch(settings, kSmall);
  RunScored(*search, [](const Genome& genome) { return Styled(genome, Sphere(genome)); });
  BitWriter saved;
  search->Save(saved);
  const auto elites = ElitesOf(settings, kSmall.shape.Genes(), saved.Bytes());
  REQUIRE(elites);
  CHECK(elites->Fitness() == search->PopulationFitness());
}

TEST_CASE("NSGA-II: finds a known front from end to end", "[search][front]") {
  // Score = sqrt(x) - g, cost = x: the front is where g, how far the other genes are from the middle, is 0.
  for (const Crossing crossing : {Crossing::kWhole, Crossing::kBlended}) {
    SearchSettings settings = Settings(Algorithm::kNsga, 10000, 5);
    settings.genetic.population = 100;
    settings.genetic.rates = {.mutation = crossing == Crossing::kWhole ? 0.9f : 0.07f, .crossover = 0.9f};
    settings.genetic.rates.crossing = crossing;
    const auto search = MakeSearch(settings, kSmall);
    RunScored(*search, [](const Genome& genome) {
      double g = 0.0;
      for (std::size_t i = 0; i < genome.size(); ++i) {
        if (i != 2) g += (Share(genome, i) - 0.5) * (Share(genome, i) - 0.5);
      }
      Score score{.fitness = static_cast<float>(std::sqrt(Share(genome, 2)) - g)};
      score.traits[static_cast<std::size_t>(Trait::kEffort)] = static_cast<float>(Share(genome, 2));
      return score;
    });
    BitWriter saved;
    search->Save(saved);
    const auto front = FrontOf(settings, kSmall.shape.Genes(), saved.Bytes());
    REQUIRE(front);
    CAPTURE(static_cast<int>(crossing), front->size());
    REQUIRE(front->size() > 30);
    for (std::size_t i = 1; i < front->size(); ++i) {
      REQUIRE((*front)[i].aims.score > (*front)[i - 1].aims.score);
      REQUIRE((*front)[i].aims.thrift < (*front)[i - 1].aims.thrift);
    }
    double worst = 0.0;
    for (const Compromise& one : *front) {
      worst = std::max(worst, std::sqrt(static_cast<double>(0.0f - one.aims.thrift)) -
                                  static_cast<double>(one.aims.score));
    }
    CHECK(worst < 0.1);
    CHECK(0.0f - front->front().aims.thrift < 0.02f);
    CHECK(0.0f - front->back().aims.thrift > 0.9f);
    CHECK(search->BestFitness() == front->back().aims.score);
  }
}

TEST_CASE("NSGA-II: void motions are behind all others, and no front", "[search][front]") {
  const SearchSettings settings = Settings(Algorithm::kNsga, 400);
  const auto search = MakeSearch(settings, kSmall);
  int asked = 0;
  RunScored(*search, [&](const Genome& genome) {
    Score score{.fitness = Sphere(genome)};
    if (++asked % 2 == 0) score.fitness = -1e9f;
    if (asked % 7 == 0) score.traits.fill(kNan);
    return score;
  });
  BitWriter saved;
  search->Save(saved);
  const auto front = FrontOf(settings, kSmall.shape.Genes(), saved.Bytes());
  REQUIRE(front);
  for (const Compromise& one : *front) CHECK(one.aims.score > -100.0f);
  auto longer = saved.Bytes();
  longer.push_back(1);
  CHECK(!FrontOf(settings, kSmall.shape.Genes(), longer));
}

}  // namespace gaitsmith::test
