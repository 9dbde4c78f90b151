// SPDX-License-Identifier: MIT
// Compares our searches with the paper's loops, transcribed literally.
#include <map>

#include "tests/known_functions.h"
#include "tests/search_run.h"

namespace gaitsmith::test {

namespace {

/// Records evaluations as the paper's loops make them, one after another.
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

/// Figure 2, transcribed literally.
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

/// Figure 3, transcribed literally.
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

/// Figure 4, transcribed literally.
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

/// Figure 1, with mates found on random walks.
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

/// The two stages of van de Panne and Fiume.
Outcome SerialTwoStage(const SearchSettings& settings) {
  Log log;
  std::vector<Member> drawn;
  for (std::uint64_t i = 0; std::cmp_less(i, settings.two_stage.random); ++i) {
    const Genome genome = Random(settings, i);
    drawn.push_back({genome, log.Evaluate(genome)});
    if (log.evaluations == settings.evaluations) return log.outcome;
  }
  // Insertion keeps equally fit members in the order in which they were drawn.
  for (std::size_t i = 1; i < drawn.size(); ++i) {
    for (std::size_t at = i; at > 0 && drawn[at].fitness > drawn[at - 1].fitness; --at) {
      std::swap(drawn[at], drawn[at - 1]);
    }
  }
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

}  // namespace gaitsmith::test
