// SPDX-License-Identifier: MIT
// Evaluations on several threads are those of one thread.
#include "shell/search/parallel_evaluation.h"

#include <catch_amalgamated.hpp>

#include "core/document/document.h"
#include "tests/scene.h"

namespace gaitsmith::shell::test {

namespace {

/// Mr. Star-Man for 1 s, and random genomes for him.
struct Load {
  Document document;
  std::vector<Genome> genomes;
  std::vector<std::span<const Gene>> views;

  explicit Load(int count) {
    document.figure = gaitsmith::test::ShippedFigure("mr-star-man");
    document.task.duration_steps = 100;
    for (int i = 0; i < count; ++i)
      genomes.push_back(FirstGenome(SpaceOf(document), document.search.variation, 1, i));
    views.assign(genomes.begin(), genomes.end());
  }
};

}  // namespace

TEST_CASE("parallel evaluation: results are bit-identical for any number of threads", "[shell][search]") {
  const Load load(GENERATE(0, 1, 4, 23));
  const Evaluator evaluator(ProblemOf(load.document), true);
  const std::vector<Evaluation> alone = evaluator.Evaluate(load.genomes);
  for (const int threads : {1, 2, 3, 16}) {
    const auto together = EvaluateInParallel(evaluator, load.views, threads, [] { return false; });
    REQUIRE(together.size() == alone.size());
    for (std::size_t i = 0; i < alone.size(); ++i) {
      CHECK(together[i].trajectory_hash == alone[i].trajectory_hash);
      CHECK(together[i].fitness == alone[i].fitness);
    }
  }
}

TEST_CASE("parallel evaluation: a stop ends it early", "[shell][search]") {
  const Load load(200);
  const Evaluator evaluator(ProblemOf(load.document), true);
  int asked = 0;
  const auto found = EvaluateInParallel(evaluator, load.views, 1, [&] { return ++asked == 2; });
  CHECK(asked == 2);
  CHECK(found.size() == 200);
  CHECK(found.back().trajectory_hash == 0);
}

}  // namespace gaitsmith::shell::test
