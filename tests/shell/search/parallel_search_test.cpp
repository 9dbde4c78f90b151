// SPDX-License-Identifier: MIT
// A search on several threads has the same result as on one thread.
#include "shell/search/parallel_search.h"

#include <catch_amalgamated.hpp>

#include "core/document/document.h"
#include "tests/scene.h"

namespace gaitsmith::shell::test {

TEST_CASE("parallel search: the result is bit-identical for any number of threads", "[shell][search]") {
  Document d;
  d.figure = gaitsmith::test::ShippedFigure("mr-star-man");
  d.task.duration_steps = d.duration_steps = 150;
  d.search.evaluations = 700;
  d.search.algorithm = GENERATE(Algorithm::kSphc, Algorithm::kSsga, Algorithm::kMapElites);
  CAPTURE(d.search.algorithm);
  const auto found = [&](int threads) {
    SearchControl control;
    return RunParallelSearch(ProblemOf(d), d.search, threads, control, [](const SearchProgress&) {}, {});
  };
  const SearchProgress alone = found(1);
  REQUIRE(alone.state == SearchState::kDone);
  REQUIRE(alone.evaluations == 700);
  for (const int threads : {2, 3}) {
    const SearchProgress together = found(threads);
    CHECK(together.best_genome == alone.best_genome);
    CHECK(together.saved == alone.saved);
  }
}

TEST_CASE("parallel search: cancelling ends it before its budget", "[shell][search]") {
  Document d;
  d.figure = gaitsmith::test::ShippedFigure("mr-star-man");
  d.search.evaluations = 1'000'000;
  SearchControl control;
  const SearchProgress done = RunParallelSearch(ProblemOf(d), d.search, 2, control,
                                                [&](const SearchProgress&) { control.Cancel(); }, {});
  CHECK(done.state == SearchState::kStopped);
  CHECK(done.evaluations < 1'000'000);
}

}  // namespace gaitsmith::shell::test
