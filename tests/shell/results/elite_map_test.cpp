// SPDX-License-Identifier: MIT
// The map of styles that results from a MAP-Elites search.
#include "shell/results/elite_map.h"

#include <catch_amalgamated.hpp>
#include <set>

#include "shell/words/wording.h"
#include "tests/scene.h"
#include "tests/shell/session/quiet_host.h"
#include "tests/style_map.h"

namespace gaitsmith::shell::test {
namespace {

Document StyleProblem() {
  QuietHost host;
  Session session(host);
  Document d = SearchOf(session.Doc());
  d.task.duration_steps = d.duration_steps = 200;
  d.search.algorithm = Algorithm::kMapElites;
  d.search.evaluations = 1500;
  d.search.elites.bins = 4;
  d.search.elites.most = {2.0f, 4.0f, 1.0f};
  return d;
}

}  // namespace

TEST_CASE("elite map: every motion has the style of its cell, and the map has the best motion",
          "[shell][elites]") {
  const Document d = StyleProblem();
  const SearchProgress done = gaitsmith::test::SearchedToEnd(d);
  const auto map = EliteMap::Of(d, done.saved);
  REQUIRE(map);
  CHECK(map->Count() > 3);
  CHECK(map->Best() == done.best_fitness);
  int sum = 0;
  const auto bin_of = [&](float value, std::size_t axis) {
    return std::min(3, static_cast<int>(value / d.search.elites.most[axis] * 4.0f));
  };
  for (int turns = 0; turns < map->Bins(); ++turns) {
    sum += map->Count(turns);
    for (int height = 0; height < map->Bins(); ++height) {
      for (int slip = 0; slip < map->Bins(); ++slip) {
        if (map->At(height, slip, turns) == nullptr) continue;
        const Document motion = map->MotionAt(height, slip, turns);
        REQUIRE(Validate(motion));
        const Motion seen = Simulate(motion);
        const Terms& terms = seen.TermsAt(seen.Frames() - 1);
        CHECK(Fitness(motion.task, terms) == map->At(height, slip, turns)->score.fitness);
        CHECK(bin_of(terms.max_cm_height_m, 0) == height);
        CHECK(bin_of(terms.slip_sum_m, 1) == slip);
        CHECK(bin_of(terms.rotations, 2) == turns);
      }
    }
  }
  CHECK(sum == map->Count());
}

TEST_CASE("elite map: its ranges are just those of its motions", "[shell][elites]") {
  const Document d = StyleProblem();
  const auto map = EliteMap::Of(d, gaitsmith::test::SearchedToEnd(d).saved);
  REQUIRE(map);
  std::array<std::set<int>, 3> filled;
  std::set<std::string> names;
  for (int cell = 0; cell < 64; ++cell) {
    const std::array<int, 3> bins = {cell / 16, cell / 4 % 4, cell % 4};
    if (map->At(bins[0], bins[1], bins[2]) == nullptr) continue;
    names.insert(map->CellName(bins[0], bins[1], bins[2]));
    for (std::size_t axis = 0; axis < 3; ++axis) filled[axis].insert(bins[axis]);
  }
  CHECK(names.size() == static_cast<std::size_t>(map->Count()));
  for (int axis = 0; axis < 3; ++axis) {
    const std::set<int>& bins = filled[static_cast<std::size_t>(axis)];
    CHECK(map->RangeOf(axis).first == *bins.begin());
    CHECK(map->RangeOf(axis).last == *bins.rbegin());
  }
  const float width = d.search.elites.most[0] / 4.0f;
  const auto [first, last] = map->RangeOf(0);
  CHECK(map->LowText(0) == Fixed(static_cast<float>(first) * width, 1));
  CHECK(map->HighText(0) == Fixed(static_cast<float>(last + 1) * width, 1) + (last == 3 ? "+" : ""));
}

TEST_CASE("elite map: rejects states of other searches", "[shell][elites]") {
  const Document d = StyleProblem();
  const SearchProgress done = gaitsmith::test::SearchedToEnd(d);
  CHECK_FALSE(EliteMap::Of(d, {}));
  for (std::size_t size = 0; size < done.saved.size(); size += 97)
    CHECK_FALSE(EliteMap::Of(d, std::span(done.saved).first(size)));
  Document other = d;
  other.search.algorithm = Algorithm::kSphc;
  CHECK_FALSE(EliteMap::Of(other, done.saved));
}

TEST_CASE("elite map: a session has the map of its last MAP-Elites search and can show its motions",
          "[shell][elites][session]") {
  QuietHost host;
  Session session(host);
  REQUIRE(session.Open(gaitsmith::EncodeJson(StyleProblem())));
  session.ForgetPast();
  const std::string before = State(session);
  CHECK_FALSE(session.Search().Elites());
  session.Search().Synthesize();
  SearchProgress done = gaitsmith::test::SearchedToEnd(host.started.back());
  session.OnSearchProgress(done);
  REQUIRE(session.Search().Elites());
  CHECK(session.Search().Elites()->Count() > 3);
  const EliteMap& map = *session.Search().Elites();
  for (int cell = 0; cell < 64; ++cell) {
    if (map.At(cell / 16, cell / 4 % 4, cell % 4) == nullptr) continue;
    session.ShowElite(map.MotionAt(cell / 16, cell / 4 % 4, cell % 4));
    CHECK(session.Doc().timeline.size() == 1);
  }
  while (session.CanUndo()) session.Undo();
  CHECK(State(session) == before);
}

}  // namespace gaitsmith::shell::test
