// SPDX-License-Identifier: MIT
// Bodies as genes keep what they must: totals, ranges, symmetric halves, and every bit of the motion.
#include <cmath>
#include <limits>

#include "core/physics/symmetry.h"
#include "core/rollout/evaluator.h"
#include "tests/scene.h"
#include "tests/search_run.h"

namespace gaitsmith::test {
namespace {

Genome RandomBody(const BodyShape& shape, std::uint64_t seed) {
  RandomStream random(seed, 17, 3);
  Genome genes(shape.Genes());
  for (Gene& gene : genes) gene = random.Gene();
  return genes;
}

double TotalOf(const Figure& figure, float Rod::* number) {
  double total = 0.0;
  for (const Rod& rod : figure.rods) total += static_cast<double>(rod.*number);
  return total;
}

bool Within(float value, float drawn, float times) {
  const float slack = 1e-5f * std::abs(drawn);
  return std::abs(value) <= std::abs(drawn) * times + slack &&
         std::abs(value) >= std::abs(drawn) / times - slack && value * drawn >= 0.0f;
}

}  // namespace

TEST_CASE("bodies: totals and ranges are kept, whatever the genes", "[rollout][body]") {
  for (const std::string& name : ShippedFigureFiles()) {
    const Figure drawn = ShippedFigure(name);
    for (const float times : {1.25f, 2.0f}) {
      const BodyShape shape({drawn, times}, drawn);
      for (std::uint64_t seed = 0; seed < 40; ++seed) {
        CAPTURE(name, times, seed);
        Genome genes = RandomBody(shape, seed);
        if (seed == 0) genes.assign(genes.size(), 0);
        if (seed == 1) genes.assign(genes.size(), kGeneMax);
        const Figure figure = shape.FigureOf(genes);
        REQUIRE(Validate(figure));
        REQUIRE(SameTree(figure, drawn));
        for (float Rod::* const number : {&Rod::length_m, &Rod::mass_kg}) {
          const double total = TotalOf(drawn, number);
          CHECK(std::abs(TotalOf(figure, number) - total) < 2e-6 * total);
        }
        for (std::size_t i = 0; i < drawn.rods.size(); ++i) {
          const Rod &rod = figure.rods[i], &was = drawn.rods[i];
          CHECK(Within(rod.length_m, was.length_m, times));
          CHECK(Within(rod.mass_kg, was.mass_kg, times));
          CHECK(rod.rest_rad == was.rest_rad);
          // A full circle is the most there is.
          CHECK((Within(rod.min_rad, was.min_rad, times) || rod.min_rad == -3.1415927f));
          CHECK((Within(rod.max_rad, was.max_rad, times) || rod.max_rad == 3.1415927f));
        }
      }
    }
  }
}

TEST_CASE("bodies: what was symmetric or alike stays so", "[rollout][body]") {
  int symmetric = 0;
  for (const std::string& name : ShippedFigureFiles()) {
    const Figure drawn = ShippedFigure(name);
    const BodyShape shape({drawn, 2.0f}, drawn);
    const bool was = SymmetryOf(drawn).has_value();
    symmetric += was ? 1 : 0;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      CAPTURE(name, seed);
      CHECK(SymmetryOf(shape.FigureOf(RandomBody(shape, seed))).has_value() == was);
    }
  }
  CHECK(symmetric >= 4);
  // The ostrich is drawn from the side: its two legs, three rods each, stay a pair.
  const Figure ostrich = ShippedFigure("ostrich");
  const BodyShape shape({ostrich, 2.0f}, ostrich);
  const Figure changed = shape.FigureOf(RandomBody(shape, 5));
  int pairs = 0;
  for (std::size_t i = 0; i < ostrich.rods.size(); ++i) {
    for (std::size_t j = i + 1; j < ostrich.rods.size(); ++j) {
      const Rod &a = ostrich.rods[i], &b = ostrich.rods[j];
      if (a.length_m != b.length_m || a.mass_kg != b.mass_kg || a.min_rad != b.min_rad) continue;
      ++pairs;
      CHECK(changed.rods[i].length_m == changed.rods[j].length_m);
      CHECK(changed.rods[i].mass_kg == changed.rods[j].mass_kg);
      CHECK(changed.rods[i].min_rad == changed.rods[j].min_rad);
      CHECK(changed.rods[i].max_rad == changed.rods[j].max_rad);
    }
  }
  CHECK(pairs == 3);
}

TEST_CASE("bodies: a limb in the middle stays like its two neighbours", "[rollout][body]") {
  Figure drawn;
  drawn.name = "trident";
  Rod shaft;
  shaft.rest_rad = 1.5707964f;
  drawn.rods.push_back(shaft);
  for (const float rest_rad : {0.6f, 0.0f, -0.6f}) {
    Rod prong;
    prong.parent = 0;
    prong.rest_rad = rest_rad;
    prong.min_rad = -0.8f;
    prong.max_rad = 0.8f;
    drawn.rods.push_back(prong);
  }
  REQUIRE(Validate(drawn));
  REQUIRE(SymmetryOf(drawn));
  const BodyShape shape({drawn, 2.0f}, drawn);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    const Figure figure = shape.FigureOf(RandomBody(shape, seed));
    CHECK(SymmetryOf(figure));
    for (const std::size_t prong : {1u, 2u, 3u}) {
      CHECK(figure.rods[prong].min_rad == figure.rods[1].min_rad);
      CHECK(figure.rods[prong].max_rad == -figure.rods[1].min_rad);
    }
  }
}

TEST_CASE("bodies: unchanged genes give the same body to the bit, also from one that was found",
          "[rollout][body]") {
  for (const std::string& name : ShippedFigureFiles()) {
    CAPTURE(name);
    const Figure drawn = ShippedFigure(name);
    const BodyShape shape({drawn, 2.0f}, drawn);
    const Genome unchanged(shape.Genes(), kUnchangedGene);
    CHECK(shape.FigureOf(unchanged).rods == drawn.rods);
    const Figure found = shape.FigureOf(RandomBody(shape, 8));
    CHECK(found.rods != drawn.rods);
    CHECK(BodyShape({drawn, 2.0f}, found).FigureOf(unchanged).rods == found.rods);
    // In a narrower range it is brought into that.
    const Figure narrowed = BodyShape({drawn, 1.25f}, found).FigureOf(unchanged);
    for (std::size_t i = 0; i < drawn.rods.size(); ++i)
      CHECK(Within(narrowed.rods[i].length_m, drawn.rods[i].length_m, 1.25f));
  }
}

TEST_CASE("bodies: a genome's score is that of its controller on its body, in any number of lanes",
          "[rollout][body]") {
  Document d = StarManTravel(SenseKind::kPhysical);
  d.search.body = BodyFreedom::kLot;
  const Problem problem = ProblemOf(d);
  const ControllerShape shape = problem.Shape();
  std::vector<Genome> genomes;
  for (std::size_t i = 0; i < 12; ++i) {
    RandomStream random(i, 1, 1);
    genomes.push_back(RandomGenome(shape, d.senses, Variation{}, random));
    // Some neighbours share a body.
    if (i % 3 != 0)
      std::ranges::copy(std::span(genomes[i - 1]).last(shape.BodyGenes()),
                        genomes[i].end() - static_cast<std::ptrdiff_t>(shape.BodyGenes()));
  }
  const auto reference = Evaluator(problem, 1, true).Evaluate(genomes);
  for (const int lanes : {2, 4, 16}) {
    const auto results = Evaluator(problem, lanes, true).Evaluate(genomes);
    for (std::size_t i = 0; i < genomes.size(); ++i)
      CHECK(results[i].trajectory_hash == reference[i].trajectory_hash);
  }
  for (std::size_t i = 0; i < genomes.size(); ++i) {
    Document found = d;
    found.controllers = {TakeFound(d, genomes[i], found)};
    found.timeline = {{0, 0}};
    found.duration_steps = d.task.duration_steps;
    REQUIRE(Validate(found));
    CHECK(found.drawn == d.figure.rods);
    CHECK(Simulate(found).Hash() == reference[i].trajectory_hash);
  }
}

TEST_CASE("bodies: every search changes them, and finds what its document shows", "[search][body]") {
  for (const auto& row : kAlgorithms) {
    CAPTURE(row.name);
    Document d = StarManTravel(SenseKind::kPhysical);
    d.search.algorithm = row.algorithm;
    d.search.body = BodyFreedom::kLittle;
    d.search.evaluations = 600;
    d.search.genetic.population = 50;
    d.search.torus.side = 6;
    const Outcome outcome = RunSearchOf(d);
    Document found = d;
    found.controllers = {TakeFound(d, outcome.best, found)};
    found.timeline = {{0, 0}};
    found.duration_steps = d.task.duration_steps;
    REQUIRE(Validate(found));
    if (row.algorithm != Algorithm::kPoseCycle) CHECK(found.figure.rods != d.figure.rods);
    const auto replayed = Evaluator(ReplayProblem(found, found.controllers[0]))
                              .Evaluate(std::vector<Genome>{found.controllers[0].genes});
    CHECK(replayed[0].fitness == outcome.fitness);
    // A search that starts from what was found begins with exactly that.
    found.search.start = 0;
    const SearchSpace space = SpaceOf(found);
    CHECK(Evaluator(ProblemOf(found)).Evaluate(std::vector<Genome>{space.start})[0].fitness ==
          outcome.fitness);
    // One that does not begins with the body as drawn.
    found.search.start = -1;
    CHECK(ProblemOf(found).figure.rods == d.figure.rods);
  }
}

TEST_CASE("bodies: the climb of pose cycles changes the body, too", "[search][body]") {
  Document d = StarManTravel(SenseKind::kPhysical);
  d.search.algorithm = Algorithm::kPoseCycle;
  d.search.body = BodyFreedom::kLot;
  d.search.evaluations = 3000;
  Document found = d;
  found.controllers = {TakeFound(d, RunSearchOf(d).best, found)};
  CHECK(found.figure.rods != d.figure.rods);
  CHECK(found.drawn == d.figure.rods);
}

TEST_CASE("bodies: a document says what is wrong with the body as drawn", "[document][body]") {
  Document d = StarManTravel(SenseKind::kPhysical);
  d.drawn = d.figure.rods;
  CHECK(Validate(d));
  d.drawn.pop_back();
  REQUIRE_FALSE(Validate(d));
  CHECK(Validate(d).error().where == "drawn");
  d.drawn = d.figure.rods;
  d.drawn[1].length_m = std::numeric_limits<float>::quiet_NaN();
  REQUIRE_FALSE(Validate(d));
  CHECK(Validate(d).error().where == "drawn[1].length_m");
}

}  // namespace gaitsmith::test
