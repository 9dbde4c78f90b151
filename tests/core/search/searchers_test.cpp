// SPDX-License-Identifier: MIT
// Properties that every search must have.

#include "tests/known_functions.h"
#include "tests/search_run.h"

namespace gaitsmith::test {

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
        if (algorithm != Algorithm::kSphc && algorithm != Algorithm::kShc) REQUIRE(many.scored == budget);
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
  std::vector<SearchSettings> all;
  all.reserve(std::size(kAll) + 1);
  for (const Algorithm algorithm : kAll) all.push_back(Settings(algorithm, 1200));
  all.push_back(Settings(Algorithm::kPowell, 1200));
  all.back().refine.step = 1.0f;  // the largest step
  for (const SearchSettings& settings : all) {
    CAPTURE(Name(settings.algorithm));
    const auto whole = MakeSearch(settings, kSmall);
    const Outcome uninterrupted = Run(*whole, 50, Rosenbrock);
    auto search = MakeSearch(settings, kSmall);
    RandomStream random(3, static_cast<std::uint64_t>(settings.algorithm), 0);
    bool saves = true;  // also before the first Ask, and after it
    while (true) {
      if (saves) {
        BitWriter saved;
        search->Save(saved);
        search = MakeSearch(settings, kSmall);
        BitReader reader(saved.Bytes());
        REQUIRE(search->Load(reader));
        BitWriter again;
        search->Save(again);
        REQUIRE(again.Bytes() == saved.Bytes());
      }
      if (search->Done()) break;
      std::vector<float> fitness;
      for (const Genome& genome : search->Ask(saves ? 1 : 1 + static_cast<int>(random.Below(30)))) {
        fitness.push_back(Rosenbrock(genome));
      }
      search->Tell(fitness);
      saves = search->Evaluations() == 1 || !random.Chance(0.5);
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
    // If a search accepts damaged bits, the result is a complete search that reaches its end.
    const auto accepts_or_refuses = [&](const std::vector<std::uint8_t>& damaged) {
      const auto other = MakeSearch(settings, kTiny);
      BitReader reader(damaged);
      if (!other->Load(reader)) return;
      BitWriter again;
      other->Save(again);
      REQUIRE(again.Bytes() == damaged);
      Run(*other, 20, Sphere);
      REQUIRE(other->Done());
    };
    for (std::size_t bit = 0; bit < saved.Bytes().size() * 8; bit += 1 + bit / 40) {
      auto flipped = saved.Bytes();
      flipped[bit / 8] = static_cast<std::uint8_t>(flipped[bit / 8] ^ (1u << (bit % 8)));
      accepts_or_refuses(flipped);
    }
    for (std::size_t at = 0; at + 8 <= saved.Bytes().size(); at += 8 + at / 40) {
      auto numbers = saved.Bytes();  // NaN and huge counts are written into these bytes
      std::fill_n(numbers.begin() + static_cast<std::ptrdiff_t>(at), 8, std::uint8_t{0xff});
      accepts_or_refuses(numbers);
    }
  }
}

TEST_CASE("search: a state with more scores than its batch has is refused", "[search]") {
  SearchSettings settings = Settings(Algorithm::kGga, 600);
  settings.genetic.population = 100;
  const auto large = MakeSearch(settings, kTiny);
  large->Tell(std::vector<float>(large->Ask(50).size()));
  BitWriter saved;
  large->Save(saved);
  for (const auto& [population, takes] : {std::pair(100, true), std::pair(20, false)}) {
    settings.genetic.population = population;
    BitReader reader(saved.Bytes());
    CHECK(MakeSearch(settings, kTiny)->Load(reader).has_value() == takes);
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
      // A search with only bad scores still ends.
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

}  // namespace gaitsmith::test
