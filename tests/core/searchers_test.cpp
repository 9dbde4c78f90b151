// SPDX-License-Identifier: MIT
// Every search on functions with known optima, and the paper's loops word for word.
#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>
#include <limits>
#include <map>

#include "core/search/generational_ga.h"
#include "core/search/map_elites.h"
#include "core/search/powell.h"
#include "core/search/search.h"
#include "core/search/steady_state_ga.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

SenseSpec Timer() {
  SenseSpec senses;
  senses.kind = SenseKind::kTimer;
  return senses;
}
/// Two rules of a five-rod figure with a timer: 14 genes.
const SearchSpace kSmall{BankShape(2, SenseKind::kTimer, 5), Timer()};
/// One rule of a two-rod figure with a timer: 4 genes.
const SearchSpace kTiny{BankShape(1, SenseKind::kTimer, 2), Timer()};

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// Functions over the unit cube, highest value 0.

/// Places the optimum off the corners and the middle, where intervals (the first genes of seven) are in
/// order.
double Off(std::size_t gene, Gene value) { return value / 65535.0 - (gene % 7 % 2 == 0 ? 0.3 : 0.62); }

float Sphere(std::span<const Gene> genome) {
  double sum = 0.0;
  for (std::size_t i = 0; i < genome.size(); ++i) sum += Off(i, genome[i]) * Off(i, genome[i]);
  return static_cast<float>(-sum);
}

/// Sphere with valleys of different widths: condition 1e4.
float Ellipsoid(std::span<const Gene> genome) {
  double sum = 0.0;
  for (std::size_t i = 0; i < genome.size(); ++i) {
    const double scale = std::pow(1e4, static_cast<double>(i) / static_cast<double>(genome.size() - 1));
    sum += scale * Off(i, genome[i]) * Off(i, genome[i]);
  }
  return static_cast<float>(-sum);
}

float Rastrigin(std::span<const Gene> genome) {
  double sum = 0.0;
  for (std::size_t i = 0; i < genome.size(); ++i) {
    const double x = 10.24 * Off(i, genome[i]);
    sum += x * x + 10.0 * (1.0 - std::cos(6.283185307179586 * x));
  }
  return static_cast<float>(-sum);
}

/// A bent valley with its top where all of Off is 0.
float Rosenbrock(std::span<const Gene> genome) {
  double sum = 0.0;
  const auto x = [&](std::size_t i) { return 1.0 + 5.0 * Off(i, genome[i]); };
  for (std::size_t i = 0; i + 1 < genome.size(); ++i) {
    sum += 100.0 * (x(i + 1) - x(i) * x(i)) * (x(i + 1) - x(i) * x(i)) + (1.0 - x(i)) * (1.0 - x(i));
  }
  return static_cast<float>(-sum);
}

/// Like onemax: counts genes in the upper half of their range.
float CountHigh(std::span<const Gene> genome) {
  return static_cast<float>(std::ranges::count_if(genome, [](Gene gene) { return gene > kGeneMax / 2; }));
}

struct Outcome {
  Genome best;
  float fitness = 0.0f;
  std::vector<Search::CurvePoint> curve;
  int told = 0;
};

template <class Function>
Outcome Run(Search& search, int wanted, Function function) {
  Outcome outcome;
  while (!search.Done()) {
    const auto genomes = search.Ask(wanted);
    REQUIRE(!genomes.empty());
    std::vector<float> fitness;
    fitness.reserve(genomes.size());
    for (const Genome& genome : genomes) fitness.push_back(function(genome));
    search.Tell(fitness);
    outcome.told += static_cast<int>(genomes.size());
  }
  outcome.best = search.BestGenome();
  outcome.fitness = search.BestFitness();
  outcome.curve = search.Curve();
  return outcome;
}

bool Same(const Outcome& a, const Outcome& b) {
  return a.best == b.best && a.fitness == b.fitness &&
         std::ranges::equal(a.curve, b.curve, [](const auto& p, const auto& q) {
           return p.evaluation == q.evaluation && p.best == q.best;
         });
}

SearchSettings Settings(Algorithm algorithm, int evaluations, std::uint32_t seed = 42) {
  SearchSettings settings;
  settings.algorithm = algorithm;
  settings.evaluations = evaluations;
  settings.seed = seed;
  settings.genetic.population = 20;
  settings.torus = {.side = 5, .walk_steps = 4};
  settings.elites.initial = 20;
  settings.two_stage = {.random = 60, .kept = 3};
  return settings;
}

constexpr Algorithm kAll[] = {Algorithm::kRandomSearch, Algorithm::kSphc,    Algorithm::kGga,
                              Algorithm::kSsga,         Algorithm::kShc,     Algorithm::kMpga,
                              Algorithm::kNelderMead,   Algorithm::kPowell,  Algorithm::kCmaEs,
                              Algorithm::kMapElites,    Algorithm::kTwoStage};

std::string Name(Algorithm algorithm) {
  return std::string(kAlgorithmNames[static_cast<std::size_t>(algorithm)]);
}

/// Notes evaluations as the paper's loops make them, one after the other.
struct Log {
  Outcome outcome;
  int evaluations = 0;
  explicit Log() { outcome.fitness = -std::numeric_limits<float>::infinity(); }
  float Evaluate(const Genome& genome) {
    const float fitness = Sphere(genome);
    ++evaluations;
    if (outcome.curve.empty() || fitness > outcome.fitness) {
      outcome.curve.push_back({evaluations, fitness});
      outcome.fitness = fitness;
      outcome.best = genome;
    }
    return fitness;
  }
};

struct Member {
  Genome genome;
  float fitness;
};

Genome Random(const SearchSettings& settings, std::uint64_t individual) {
  RandomStream random(settings.seed, individual, 0);
  return RandomGenome(kSmall.shape, kSmall.senses, settings.variation, random);
}

/// Figure 2, word for word.
Outcome SerialGga(const SearchSettings& settings) {
  Log log;
  const auto size = static_cast<std::size_t>(settings.genetic.population);
  std::vector<Genome> population;
  population.reserve(size);
  for (std::size_t i = 0; i < size; ++i) population.push_back(Random(settings, i));
  for (std::uint64_t generation = 1;; ++generation) {
    std::vector<Member> parents;
    for (const Genome& genome : population) {
      parents.push_back({genome, log.Evaluate(genome)});
      if (log.evaluations == settings.evaluations) return log.outcome;
    }
    float least = parents[0].fitness;
    for (const Member& parent : parents) least = std::min(least, parent.fitness);
    double whole = 0.0;
    for (const Member& parent : parents)
      whole += static_cast<double>(parent.fitness) - static_cast<double>(least);
    const auto roulette = [&](RandomStream& random) -> const Genome& {
      const double ball = random.Uniform() * whole;
      double sum = 0.0;
      for (const Member& parent : parents) {
        sum += static_cast<double>(parent.fitness) - static_cast<double>(least);
        if (ball < sum) return parent.genome;
      }
      return parents.back().genome;
    };
    population.clear();
    for (std::uint64_t i = 0; i < size / 2; ++i) {
      RandomStream random(settings.seed, i, generation);
      const Genome& first = roulette(random);
      const Genome& second = roulette(random);
      const auto [copy, hybrid] =
          Breed(first, second, kSmall, settings.variation, settings.genetic.rates, random);
      population.push_back(copy);
      population.push_back(hybrid);
    }
  }
}

/// Figure 3, word for word.
Outcome SerialSsga(const SearchSettings& settings) {
  Log log;
  const auto size = static_cast<std::size_t>(settings.genetic.population);
  std::vector<Member> ranked;
  const auto insert = [&](const Genome& genome, float fitness) {
    std::size_t at = 0;
    while (at < ranked.size() && ranked[at].fitness >= fitness) ++at;
    ranked.insert(ranked.begin() + static_cast<std::ptrdiff_t>(at), {genome, fitness});
  };
  for (std::size_t i = 0; i < size; ++i) {
    const Genome genome = Random(settings, i);
    insert(genome, log.Evaluate(genome));
  }
  for (std::uint64_t iteration = 1;; ++iteration) {
    RandomStream random(settings.seed, 0, iteration);
    const auto chosen = [&]() -> const Genome& {
      const auto b = static_cast<double>(settings.genetic.rank_bias);
      const double u = random.Uniform();
      const double index =
          static_cast<double>(size) * ((b - std::sqrt(b * b - 4 * (b - 1) * u)) / (2 * (b - 1)));
      return ranked[static_cast<std::size_t>(index)].genome;
    };
    const Genome& first = chosen();
    const Genome& second = chosen();
    const auto [copy, hybrid] =
        Breed(first, second, kSmall, settings.variation, settings.genetic.rates, random);
    float fitness[2] = {};
    fitness[0] = log.Evaluate(copy);
    if (log.evaluations == settings.evaluations) return log.outcome;
    fitness[1] = log.Evaluate(hybrid);
    if (log.evaluations == settings.evaluations) return log.outcome;
    insert(copy, fitness[0]);
    insert(hybrid, fitness[1]);
    ranked.resize(size);
  }
}

/// Figure 4, word for word.
Outcome SerialShc(const SearchSettings& settings) {
  Log log;
  Genome genome = Random(settings, 0);
  float fitness = log.Evaluate(genome);
  for (std::uint64_t evaluation = 1; log.evaluations < settings.evaluations; ++evaluation) {
    RandomStream random(settings.seed, 0, evaluation);
    Genome perturbed = Perturb(genome, kSmall.shape, kSmall.senses, settings.variation, random);
    const float now = log.Evaluate(perturbed);
    if (now > fitness) {
      fitness = now;
      genome = std::move(perturbed);
    }
  }
  return log.outcome;
}

/// Figure 1 with mates found on walks.
Outcome SerialMpga(const SearchSettings& settings) {
  Log log;
  const int side = settings.torus.side;
  std::map<std::pair<int, int>, Member> torus;
  std::uint64_t born = 0;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) torus[{y, x}].genome = Random(settings, born++);
  }
  for (std::uint64_t generation = 1;; ++generation) {
    for (auto& [place, cell] : torus) {
      cell.fitness = log.Evaluate(cell.genome);
      if (log.evaluations == settings.evaluations) return log.outcome;
    }
    auto next = torus;
    for (auto& [place, cell] : next) {
      auto [y, x] = place;
      RandomStream random(settings.seed, static_cast<std::uint64_t>(y * side + x), generation);
      const Member* mate = nullptr;
      for (int step = 0; step < settings.torus.walk_steps; ++step) {
        const std::uint32_t way = random.Below(4);
        if (way == 0) y = (y + 1) % side;
        if (way == 1) y = (y + side - 1) % side;
        if (way == 2) x = (x + 1) % side;
        if (way == 3) x = (x + side - 1) % side;
        if (mate == nullptr || torus[{y, x}].fitness > mate->fitness) mate = &torus[{y, x}];
      }
      cell.genome = Cross(mate->genome, torus[place].genome, kSmall.shape, settings.genetic.rates, random);
      Mutate(cell.genome, kSmall, settings.variation, settings.genetic.rates, random);
    }
    torus = next;
  }
}

/// van de Panne and Fiume's two stages.
Outcome SerialTwoStage(const SearchSettings& settings) {
  Log log;
  std::vector<Member> drawn;
  for (std::uint64_t i = 0; std::cmp_less(i, settings.two_stage.random); ++i) {
    const Genome genome = Random(settings, i);
    drawn.push_back({genome, log.Evaluate(genome)});
    if (log.evaluations == settings.evaluations) return log.outcome;
  }
  std::ranges::stable_sort(drawn, [](const Member& a, const Member& b) { return a.fitness > b.fitness; });
  drawn.resize(static_cast<std::size_t>(settings.two_stage.kept));
  for (std::uint64_t generation = 1;; ++generation) {
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      RandomStream random(settings.seed, i, generation);
      const Genome child = Perturb(drawn[i].genome, kSmall.shape, kSmall.senses, settings.variation, random);
      const float fitness = log.Evaluate(child);
      if (fitness > drawn[i].fitness) drawn[i] = {child, fitness};
      if (log.evaluations == settings.evaluations) return log.outcome;
    }
  }
}

}  // namespace

TEST_CASE("searches of the paper: exactly its loops, however many genomes are asked at a time", "[search]") {
  const std::pair<Algorithm, Outcome (*)(const SearchSettings&)> figures[] = {
      {Algorithm::kMpga, SerialMpga},
      {Algorithm::kGga, SerialGga},
      {Algorithm::kSsga, SerialSsga},
      {Algorithm::kShc, SerialShc},
      {Algorithm::kTwoStage, SerialTwoStage}};
  for (const auto& [algorithm, serial] : figures) {
    for (const RateReading reading : {RateReading::kPerChild, RateReading::kPerComponent}) {
      for (const int budget : {25, 26, 333, 1500}) {
        SearchSettings settings = Settings(algorithm, budget);
        settings.genetic.rates.reading = reading;
        const Outcome paper = serial(settings);
        for (const int wanted : {1, 7, 64, 5000}) {
          CAPTURE(Name(algorithm), static_cast<int>(reading), budget, wanted);
          const auto search = MakeSearch(settings, kSmall);
          REQUIRE(Same(Run(*search, wanted, Sphere), paper));
        }
      }
    }
  }
}

TEST_CASE("every search: the same result for any number of genomes asked, the budget spent exactly",
          "[search]") {
  for (const Algorithm algorithm : kAll) {
    for (const int budget : {25, 777, 2000}) {
      const auto one = MakeSearch(Settings(algorithm, budget), kSmall);
      const Outcome serial = Run(*one, 1, Rastrigin);
      REQUIRE(serial.curve.front().evaluation == 1);
      REQUIRE(serial.curve.back().best == serial.fitness);
      REQUIRE(Rastrigin(serial.best) == serial.fitness);
      for (const int wanted : {3, 10, 128, 100000}) {
        CAPTURE(Name(algorithm), budget, wanted);
        const auto search = MakeSearch(Settings(algorithm, budget), kSmall);
        const Outcome many = Run(*search, wanted, Rastrigin);
        REQUIRE(Same(many, serial));
        REQUIRE(search->Evaluations() == budget);
        // Only climbers look ahead.
        if (algorithm != Algorithm::kSphc && algorithm != Algorithm::kShc) REQUIRE(many.told == budget);
      }
    }
  }
}

TEST_CASE("every search: intervals stay in order, so that what is found can be shared", "[search]") {
  for (const Algorithm algorithm : kAll) {
    CAPTURE(Name(algorithm));
    const auto search = MakeSearch(Settings(algorithm, 1500), kSmall);
    Run(*search, 40, [](const Genome& genome) {
      const BankShape& bank = kSmall.shape.Bank();
      for (int rule = 0; rule < bank.rules; ++rule) {
        REQUIRE(genome[bank.Low(rule, 0)] <= genome[bank.High(rule, 0)]);
      }
      return Ellipsoid(genome);
    });
  }
}

TEST_CASE("every search: saved and loaded at any point, it goes on as if nothing had happened", "[search]") {
  for (const Algorithm algorithm : kAll) {
    CAPTURE(Name(algorithm));
    const SearchSettings settings = Settings(algorithm, 1200);
    const auto whole = MakeSearch(settings, kSmall);
    const Outcome uninterrupted = Run(*whole, 50, Rosenbrock);
    auto search = MakeSearch(settings, kSmall);
    RandomStream random(3, static_cast<std::uint64_t>(algorithm), 0);
    while (!search->Done()) {
      std::vector<float> fitness;
      for (const Genome& genome : search->Ask(1 + static_cast<int>(random.Below(30)))) {
        fitness.push_back(Rosenbrock(genome));
      }
      search->Tell(fitness);
      if (random.Chance(0.5)) continue;
      BitWriter saved;
      search->Save(saved);
      search = MakeSearch(settings, kSmall);
      BitReader reader(saved.Bytes());
      REQUIRE(search->Load(reader));
      BitWriter again;
      search->Save(again);
      REQUIRE(again.Bytes() == saved.Bytes());
    }
    REQUIRE(Same({search->BestGenome(), search->BestFitness(), search->Curve()}, uninterrupted));
  }
}

TEST_CASE("every search: a damaged state is refused, or at least does no harm", "[search]") {
  for (const Algorithm algorithm : kAll) {
    CAPTURE(Name(algorithm));
    const SearchSettings settings = Settings(algorithm, 600);
    const auto search = MakeSearch(settings, kTiny);
    for (int i = 0; i < 13; ++i) {
      std::vector<float> fitness;
      for (const Genome& genome : search->Ask(10)) fitness.push_back(Sphere(genome));
      search->Tell(fitness);
    }
    BitWriter saved;
    search->Save(saved);
    const auto unchanged = [&] {
      BitWriter now;
      search->Save(now);
      return now.Bytes() == saved.Bytes();
    };
    for (std::size_t size = 0; size < saved.Bytes().size(); size += 1 + size / 16) {
      BitReader cut(std::span(saved.Bytes()).first(size));
      const auto loaded = search->Load(cut);
      REQUIRE(!loaded);
      REQUIRE(loaded.error().code == ErrorCode::kTruncated);
      REQUIRE(unchanged());
    }
    auto longer = saved.Bytes();
    longer.push_back(1);
    BitReader trailing(longer);
    REQUIRE(!search->Load(trailing));
    REQUIRE(unchanged());
    // Whatever a changed bit makes of it, a search that accepts it comes to its end.
    for (std::size_t bit = 0; bit < saved.Bytes().size() * 8; bit += 1 + bit / 40) {
      auto flipped = saved.Bytes();
      flipped[bit / 8] = static_cast<std::uint8_t>(flipped[bit / 8] ^ (1u << (bit % 8)));
      const auto other = MakeSearch(settings, kTiny);
      BitReader reader(flipped);
      if (!other->Load(reader)) continue;
      Run(*other, 20, Sphere);
      REQUIRE(other->Done());
    }
  }
}

TEST_CASE("every search: NaN loses to everything, and so do motions that broke physics", "[search]") {
  for (const Algorithm algorithm : kAll) {
    for (const float bad : {kNan, -std::numeric_limits<float>::infinity(), -1e9f}) {
      CAPTURE(Name(algorithm), bad);
      int asked = 0;
      const auto search = MakeSearch(Settings(algorithm, 800), kSmall);
      const Outcome outcome =
          Run(*search, 30, [&](const Genome& genome) { return ++asked % 3 == 1 ? bad : Sphere(genome); });
      REQUIRE(outcome.fitness == Sphere(outcome.best));
      // Nothing but bad ones is still a search with an end.
      const auto hopeless = MakeSearch(Settings(algorithm, 800), kSmall);
      REQUIRE(!(Run(*hopeless, 30, [&](const Genome&) { return bad; }).fitness > -1e9f));
    }
  }
}

TEST_CASE("every search: begins with the given genome", "[search]") {
  SearchSpace space = kSmall;
  RandomStream random(5, 6, 7);
  space.start = RandomGenome(space.shape, space.senses, Variation{}, random);
  for (const Algorithm algorithm : kAll) {
    CAPTURE(Name(algorithm));
    REQUIRE(MakeSearch(Settings(algorithm, 300), space)->Ask(5).front() == space.start);
    const auto search = MakeSearch(Settings(algorithm, 300), space);
    REQUIRE(Run(*search, 5, Sphere).fitness >= Sphere(space.start));
  }
}

TEST_CASE("searches find known optima within their budgets", "[search]") {
  struct Expectation {
    Algorithm algorithm;
    float (*function)(std::span<const Gene>);
    const SearchSpace* space;
    int evaluations;
    float at_least;  // for each of the seeds 1 to 3
  };
  // Bounds are set from what was measured with these seeds: they guard against decay, they prove no rate.
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

TEST_CASE("roulette wheel: chances in proportion to fitness above the least", "[search]") {
  const std::vector<Individual> population = {{{}, -3.0f}, {{}, -1.0f}, {{}, 5.0f}, {{}, -1e9f}, {{}, -3.0f}};
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
    // Rates of nothing change nothing.
    const Rates none{.mutation = 0.0f, .crossover = 0.0f, .reading = reading};
    const Offspring children = Breed(a, b, space, Variation{}, none, random);
    CHECK(children.copy == a);
    CHECK(children.hybrid == b);
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
  SearchSettings settings = Settings(Algorithm::kMapElites, 2000);  // its end cuts a batch
  settings.elites.bins = 4;
  MapElites search(settings, kTiny);
  // Style: three genes on their way to the ends of the grid and beyond.
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
    const MapElites::Elite& elite = search.Cells()[cell];
    REQUIRE(elite.genome.empty() == !best.contains(cell));
    if (!elite.genome.empty()) REQUIRE(elite.score.fitness == best[cell]);
  }
  // Motions without a style are in no cell, but the best of them is still the best.
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
