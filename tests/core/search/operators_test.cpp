// SPDX-License-Identifier: MIT
// The parts of searches: wheels, ranks, operators, line searches, cells.
#include "core/evolution/generational_ga.h"
#include "core/evolution/map_elites.h"
#include "core/evolution/steady_state_ga.h"
#include "core/search/powell.h"
#include "tests/known_functions.h"
#include "tests/search_run.h"

namespace gaitsmith::test {

TEST_CASE("roulette wheel: chances in proportion to fitness above the least", "[search]") {
  const std::vector<Individual> population = {
      {{}, -3.0f}, {{}, -1.0f}, {{}, 5.0f}, {{}, kNoMotion}, {{}, -3.0f}};
  const std::vector<double> wheel = RouletteWheel(population);
  std::array<int, 5> chosen{};
  for (int i = 0; i < 1000; ++i) ++chosen[SpinWheel(wheel, (i + 0.5) / 1000.0)];
  CHECK(chosen == std::array<int, 5>{0, 200, 800, 0, 0});
  const std::vector<double> flat = RouletteWheel({{{}, 2.0f}, {{}, 2.0f}});
  CHECK(SpinWheel(flat, 0.49) == 0);
  CHECK(SpinWheel(flat, 0.51) == 1);
}

TEST_CASE("linear rank: the best has `bias` times the chance of the median", "[search]") {
  for (const double bias : {1.0, 1.25, 1.5, 2.0}) {
    constexpr std::size_t kPopulation = 101;
    constexpr int kDraws = 1'010'000;
    std::vector<double> share(kPopulation);
    for (int i = 0; i < kDraws; ++i) share[LinearRank(kPopulation, bias, (i + 0.5) / kDraws)] += 1.0 / kDraws;
    CAPTURE(bias);
    CHECK_THAT(share[0] / share[50], Catch::Matchers::WithinAbs(bias, 0.02));
    CHECK_THAT(share[100] / share[50], Catch::Matchers::WithinAbs(2.0 - bias, 0.02));
  }
  CHECK(LinearRank(200, 2.0, std::nextafter(1.0, 0.0)) == 199);
}

TEST_CASE("operators: rates mean what they say, in both readings", "[search]") {
  // Physical senses and ten rules: 290 genes.
  const SearchSpace space{BankShape(10, SenseKind::kPhysical, 5), SenseSpec{}};
  const auto size = static_cast<std::size_t>(space.shape.Bank().GenesPerRule());
  RandomStream random(1, 2, 3);
  const Genome a = RandomGenome(space.shape, space.senses, Variation{}, random);
  const Genome b = RandomGenome(space.shape, space.senses, Variation{}, random);
  constexpr int kTimes = 4000;
  for (const RateReading reading : {RateReading::kPerChild, RateReading::kPerComponent}) {
    const Rates rates{.mutation = 0.1f, .crossover = 0.6f, .reading = reading};
    int changed = 0, rules_of_a = 0, hybrids = 0;
    for (int i = 0; i < kTimes; ++i) {
      const Genome child = Cross(a, b, space.shape, rates, random);
      if (child != b) ++hybrids;
      for (std::size_t at = 0; at < child.size(); at += size) {
        const auto rule = std::span(child).subspan(at, size);
        const bool of_a = std::ranges::equal(rule, std::span(a).subspan(at, size));
        REQUIRE((of_a || std::ranges::equal(rule, std::span(b).subspan(at, size))));
        rules_of_a += of_a ? 1 : 0;
      }
      Genome mutant = a;
      Mutate(mutant, space, Variation{}, rates, random);
      changed += mutant != a ? 1 : 0;
    }
    CAPTURE(static_cast<int>(reading));
    const bool per_child = reading == RateReading::kPerChild;
    CHECK_THAT(hybrids / double{kTimes}, Catch::Matchers::WithinAbs(per_child ? 0.6 : 1.0, 0.03));
    CHECK_THAT(rules_of_a / (10.0 * kTimes), Catch::Matchers::WithinAbs(per_child ? 0.3 : 0.6, 0.03));
    CHECK_THAT(changed / double{kTimes}, Catch::Matchers::WithinAbs(per_child ? 0.1 : 1.0, 0.03));
    // Rates of 0 change nothing.
    const Rates none{.mutation = 0.0f, .crossover = 0.0f, .reading = reading};
    const Offspring children = Breed(a, b, space, Variation{}, none, random);
    CHECK(children.copy == a);
    CHECK(children.hybrid == b);
  }
}

TEST_CASE("operators: heedless rules are drawn and bred only where they are allowed", "[search]") {
  const ControllerShape shape = BankShape(10, SenseKind::kPhysical, 5);
  const BankShape& bank = shape.Bank();
  const auto heedless = [&](const Genome& genome) {
    int rules = 0;
    for (int rule = 0; rule < bank.rules; ++rule) {
      bool cares = false;
      for (int sense = 0; sense < bank.senses; ++sense) cares = cares || bank.Cares(genome, rule, sense);
      rules += cares ? 0 : 1;
    }
    return rules;
  };
  int with_one = 0;
  for (std::uint64_t i = 0; i < 400; ++i) {
    RandomStream allowed_stream(3, i, 0), stream(3, i, 0);
    const SenseSpec senses;
    Variation variation;
    with_one += heedless(RandomGenome(shape, senses, variation, allowed_stream)) > 0 ? 1 : 0;
    variation.heedless = Heedless::kForbidden;
    Genome genome = RandomGenome(shape, senses, variation, stream);
    REQUIRE(heedless(genome) == 0);
    // Every second gene changes, so that perturbation often drops the last sense of a rule.
    variation.gene_chance = 0.5f;
    for (int times = 0; times < 10; ++times) {
      genome = Perturb(genome, shape, senses, variation, stream);
      REQUIRE(heedless(genome) == 0);
    }
  }
  // 1 - (1 - 0.8^senses)^rules
  const double expected = 1.0 - std::pow(1.0 - std::pow(0.8, bank.senses), bank.rules);
  CHECK_THAT(with_one / 400.0, Catch::Matchers::WithinAbs(expected, 0.08));

  // A timer is always heeded.
  const ControllerShape timed = BankShape(10, SenseKind::kTimer, 5);
  const SenseSpec timer{.kind = SenseKind::kTimer};
  RandomStream one(4, 4, 4), other(4, 4, 4);
  CHECK(RandomGenome(timed, timer, Variation{}, one) ==
        RandomGenome(timed, timer, Variation{.heedless = Heedless::kForbidden}, other));
}

TEST_CASE("operators: a copy of a parent is perturbed where copies are not kept", "[search]") {
  const SearchSpace space{BankShape(10, SenseKind::kPhysical, 5), SenseSpec{}};
  RandomStream random(5, 5, 5);
  const Genome a = RandomGenome(space.shape, space.senses, Variation{}, random);
  const Genome b = RandomGenome(space.shape, space.senses, Variation{}, random);
  for (int times = 0; times < 200; ++times) {
    const Offspring children = Breed(a, b, space, Variation{}, {.copies = Copies::kPerturbed}, random);
    for (const Genome& child : {children.copy, children.hybrid}) {
      REQUIRE(child != a);
      REQUIRE(child != b);
    }
  }
}

TEST_CASE("operators: a genome is a point and back", "[search]") {
  RandomStream random(8, 8, 8);
  const SearchSpace space{BankShape(10, SenseKind::kPhysical, 5), SenseSpec{}};
  const Genome genome = RandomGenome(space.shape, space.senses, Variation{}, random);
  CHECK(GenomeAt(PointOf(genome), space.shape) == genome);
  std::vector<double> wild(kTiny.shape.Genes(), -3.0);
  wild[0] = 7.0;
  wild[2] = std::numeric_limits<double>::quiet_NaN();
  wild[3] = 0.5;
  CHECK(GenomeAt(wild, kTiny.shape) == Genome{0, 65535, 0, 32768});
}

TEST_CASE("Powell: a line search finds the top of a parabola at once, and stays on its line", "[search]") {
  for (const double top : {-0.4, -0.05, 0.0, 0.021, 0.3, 0.9}) {
    std::vector<Powell::Trial> tried = {{0.0, static_cast<float>(-top * top)}};
    while (const auto next = Powell::NextTrial(tried, 0.1, -0.45, 0.5)) {
      REQUIRE(*next >= -0.45);
      REQUIRE(*next <= 0.5);
      tried.push_back({*next, static_cast<float>(-(*next - top) * (*next - top))});
      REQUIRE(tried.size() < 20);
    }
    const auto best = *std::ranges::max_element(tried, {}, &Powell::Trial::fitness);
    CAPTURE(top, best.at);
    CHECK(std::abs(best.at - std::min(top, 0.5)) < 2e-3);
  }
}

TEST_CASE("MAP-Elites: every cell holds the fittest of its style", "[search]") {
  SearchSettings settings = Settings(Algorithm::kMapElites, 2000);  // the budget ends within a batch
  settings.elites.bins = 4;
  MapElites search(settings, kTiny);
  // Style: three genes, scaled to the ends of the grid and beyond.
  const auto score = [](const Genome& genome) {
    return Score{Sphere(genome),
                 {4.4f * genome[0] / 65535.0f, 10.0f * genome[1] / 65535.0f, 4.0f * genome[2] / 65535.0f}};
  };
  std::map<std::size_t, float> best;
  while (!search.Done()) {
    std::vector<Score> scores;
    for (const Genome& genome : search.Ask(50)) {
      scores.push_back(score(genome));
      std::size_t cell = 0;
      for (std::size_t term = 0; term < 3; ++term) {
        const float share = scores.back().style[term] / settings.elites.most[term];
        cell = cell * 4 + static_cast<std::size_t>(std::min(3, static_cast<int>(4.0f * share)));
      }
      const auto [place, fresh] = best.try_emplace(cell, scores.back().fitness);
      if (!fresh) place->second = std::max(place->second, scores.back().fitness);
    }
    search.Tell(scores);
  }
  REQUIRE(search.Cells().size() == 64);
  CHECK(best.size() >= 30);
  for (std::size_t cell = 0; cell < search.Cells().size(); ++cell) {
    const Elite& elite = search.Cells()[cell];
    REQUIRE(elite.genome.empty() == !best.contains(cell));
    if (!elite.genome.empty()) REQUIRE(elite.score.fitness == best[cell]);
  }
  // Motions without a style fall into no cell, but the best of them is still the best.
  MapElites without(settings, kTiny);
  while (!without.Done()) {
    std::vector<Score> scores;
    for (const Genome& genome : without.Ask(50)) scores.push_back({Sphere(genome), {kNan, 0.0f, 0.0f}});
    without.Tell(scores);
  }
  CHECK(std::ranges::all_of(without.Cells(), [](const auto& elite) { return elite.genome.empty(); }));
  CHECK(without.BestFitness() == Sphere(without.BestGenome()));
}

}  // namespace gaitsmith::test
