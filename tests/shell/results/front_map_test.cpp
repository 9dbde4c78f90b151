// SPDX-License-Identifier: MIT
// The front that results from an NSGA-II search.
#include "shell/results/front_map.h"

#include <catch_amalgamated.hpp>
#include <set>

#include "shell/results/elite_map.h"
#include "tests/scene.h"
#include "tests/shell/session/quiet_host.h"
#include "tests/style_map.h"

namespace gaitsmith::shell::test {
namespace {

Document FrontProblem(Cost cost) {
  QuietHost host;
  Session session(host);
  Document d = SearchOf(session.Doc());
  d.task.duration_steps = d.duration_steps = 200;
  d.search.algorithm = Algorithm::kNsga;
  d.search.evaluations = 1500;
  d.search.genetic.population = 50;
  d.search.cost = cost;
  return d;
}

}  // namespace

TEST_CASE("front map: its motions have their scores and costs, and none beats another", "[shell][front]") {
  for (const Cost cost : {Cost::kEffort, Cost::kSlip}) {
    const Document d = FrontProblem(cost);
    const SearchProgress done = gaitsmith::test::SearchedToEnd(d);
    const auto front = FrontMap::Of(d, done.saved);
    REQUIRE(front);
    REQUIRE(front->Count() > 3);
    CHECK(front->Score(front->Count() - 1) == done.best_fitness);
    std::set<std::string> names;
    for (std::size_t i = 0; i < front->Count(); ++i) {
      if (i > 0) {
        CHECK(front->Score(i) > front->Score(i - 1));
        CHECK(front->Cost(i) > front->Cost(i - 1));
      }
      names.insert(front->Name(i));
      const Document motion = front->MotionAt(i);
      REQUIRE(Validate(motion));
      const Motion seen = Simulate(motion);
      const Terms& terms = seen.TermsAt(seen.Frames() - 1);
      CHECK(Fitness(motion.task, terms) == front->Score(i));
      // By second, and for each joint or in sizes of the figure.
      const auto joints = static_cast<float>(motion.figure.rods.size() - 1);
      const float spent = cost == Cost::kEffort ? terms.effort_rad / 2.0f / joints
                                                : terms.slip_sum_m / 2.0f / SizeOf(motion.figure);
      CHECK_THAT(front->Cost(i), Catch::Matchers::WithinRel(spent, 1e-5f));
    }
    CHECK(names.size() == front->Count());
    CHECK(!FrontMap::Of(d, {}));
    CHECK(!EliteMap::Of(d, done.saved));
  }
}

TEST_CASE("front map: searches that weigh nothing against the score have none", "[shell][front]") {
  Document d = FrontProblem(Cost::kEffort);
  d.search.algorithm = Algorithm::kSsga;
  CHECK(!FrontMap::Of(d, gaitsmith::test::SearchedToEnd(d).saved));
}

}  // namespace gaitsmith::shell::test
