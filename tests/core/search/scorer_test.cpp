// SPDX-License-Identifier: MIT
// A scorer remembers what small batches sensed, and no search can tell.
#include <algorithm>

#include "core/search/evaluation_score.h"
#include "tests/scene.h"
#include "tests/search_run.h"

namespace gaitsmith::test {
namespace {

bool SameSightings(const std::vector<Sighting>& one, const std::vector<Sighting>& other) {
  return std::ranges::equal(one, other, [](const Sighting& a, const Sighting& b) {
    return a.rule == b.rule && a.senses == b.senses;
  });
}

Genome Random(const Problem& problem, std::uint64_t seed) {
  RandomStream random(seed, 4, 2);
  return RandomGenome(problem.Shape(), problem.senses, Variation{}, random);
}

}  // namespace

TEST_CASE("scorer: sightings recorded beside a score are those of a motion of its own", "[search][scorer]") {
  for (const SenseKind senses : {SenseKind::kPhysical, SenseKind::kTimer}) {
    for (const BodyFreedom body : {BodyFreedom::kNone, BodyFreedom::kLot}) {
      Document d = StarManTravel(senses);
      d.search.body = body;
      // Also motions with fewer steps than sightings.
      for (const int steps : {500, 20}) {
        d.task.duration_steps = steps;
        const Problem problem = ProblemOf(d);
        std::vector<Genome> genomes;
        genomes.reserve(7);
        for (std::uint64_t i = 0; i < 7; ++i) genomes.push_back(Random(problem, i));
        std::vector<std::vector<Sighting>> seen(genomes.size());
        const auto watched = Evaluator(problem).Evaluate(genomes, {32, seen});
        const auto plain = Evaluator(problem).Evaluate(genomes);
        for (std::size_t i = 0; i < genomes.size(); ++i) {
          CAPTURE(steps, i);
          CHECK(watched[i].fitness == plain[i].fitness);
          CHECK(seen[i].size() == 32);
          CHECK(SameSightings(seen[i], SightingsOf(problem, genomes[i], 32)));
        }
      }
    }
  }
}

TEST_CASE("scorer: a search finds the same, whether its batches were remembered or not", "[search][scorer]") {
  for (const SenseKind senses : {SenseKind::kPhysical, SenseKind::kTimer}) {
    Document d = StarManTravel(senses);
    d.search.algorithm = Algorithm::kPoseCycle;
    d.search.evaluations = 2000;
    const Outcome simulated = RunSearchOf(d);  // knows nothing of the search's space
    const Scorer scorer(ProblemOf(d));
    const auto search = MakeSearch(d.search, scorer.Space(StartOf(d)));
    while (!search->Done()) search->Tell(scorer.ScoresOf(search->Ask(40)));
    CHECK(search->BestGenome() == simulated.best);
    CHECK(search->BestFitness() == simulated.fitness);
  }
}

TEST_CASE("scorer: a genome that was not among the last ones is simulated", "[search][scorer]") {
  const Problem problem = ProblemOf(StarManTravel(SenseKind::kPhysical));
  const Scorer scorer(problem);
  const SearchSpace space = scorer.Space();
  const Genome one = Random(problem, 1), other = Random(problem, 2);
  CHECK(SameSightings(space.sightings(one, 9), SightingsOf(problem, one, 9)));
  CHECK(scorer.ScoresOf(std::vector<Genome>{one}).size() == 1);
  CHECK(SameSightings(space.sightings(one, 9), SightingsOf(problem, one, 9)));
  CHECK(SameSightings(space.sightings(one, 5), SightingsOf(problem, one, 5)));
  CHECK(SameSightings(space.sightings(other, 5), SightingsOf(problem, other, 5)));
}

TEST_CASE("scorer: networks have no rules to be sighted", "[search][scorer]") {
  Document d = StarManTravel(SenseKind::kPhysical);
  d.kind = ControllerKind::kNetwork;
  const Problem problem = ProblemOf(d);
  CHECK(SightingsOf(problem, Random(problem, 3), 8).empty());
}

}  // namespace gaitsmith::test
