// SPDX-License-Identifier: MIT
// A search that may change the body: the stage, results and Undo have body and controller together; the drawn
// body comes back, and a controller drives a body that is not its own.
#include <catch_amalgamated.hpp>

#include "tests/shell/session/quiet_host.h"

namespace gaitsmith::shell::test {
namespace {

/// Begins a search that may change the body a lot.
void SearchBody(Session& session) {
  session.Set([](Document& d) { d.search.body = BodyFreedom::kLot; });
  session.Synthesize();
}

}  // namespace

TEST_CASE("body: what a search finds changes the figure, and Undo brings back both",
          "[shell][session][body]") {
  QuietHost host;
  Session session(host);
  REQUIRE(session.Begin(""));
  const std::vector<Rod> drawn = session.Doc().figure.rods;
  SearchBody(session);
  REQUIRE(host.started.size() == 1);
  End(session, host, 20000);
  CHECK(session.Doc().figure.rods != drawn);
  CHECK(session.Doc().drawn == drawn);
  CHECK(session.Doc().controllers.size() == 1);
  const auto shown = session.Results().Motions().Sorted(FoundMotions::Order::kNewest);
  REQUIRE(shown.size() == 1);
  CHECK(shown.front()->motion.document.figure.rods == session.Doc().figure.rods);
  const std::vector<Rod> found = session.Doc().figure.rods;

  // The next search begins with the drawn body, and pressing twice is another seed.
  session.Synthesize();
  REQUIRE(host.started.size() == 2);
  CHECK(host.started[1].search.seed != host.started[0].search.seed);
  CHECK(ProblemOf(host.started[1]).figure.rods == drawn);
  End(session, host, 45000);
  CHECK(session.Doc().figure.rods != found);
  CHECK(session.Doc().drawn == drawn);
  session.Undo();
  CHECK(session.Doc().figure.rods == found);
  session.Undo();
  CHECK(session.Doc().figure.rods == drawn);
  CHECK(session.Doc().drawn.empty());
}

TEST_CASE("body: the drawn one comes back, and keeps the controller", "[shell][session][body]") {
  QuietHost host;
  Session session(host);
  REQUIRE(session.Begin(""));
  const std::vector<Rod> drawn = session.Doc().figure.rods;
  SearchBody(session);
  End(session, host, 20000);
  REQUIRE(session.ReplaceFigure(AsDrawn(session.Doc())));
  CHECK(session.Doc().figure.rods == drawn);
  CHECK(session.Doc().drawn.empty());
  CHECK(session.Doc().controllers.size() == 1);
}

TEST_CASE("body: a result's controller drives the body in hand", "[shell][session][body]") {
  QuietHost host;
  Session session(host);
  REQUIRE(session.Begin(""));
  SearchBody(session);
  End(session, host, 20000);
  const std::string id = session.Results().Motions().Sorted(FoundMotions::Order::kNewest).front()->id;
  const Document first = session.Doc();
  CHECK_FALSE(session.CanTryBrain(first));
  session.Synthesize();
  End(session, host, 45000);
  const Document second = session.Doc();
  REQUIRE(session.CanTryBrain(first));
  session.TryBrain(id);
  CHECK(session.Doc().figure.rods == second.figure.rods);
  CHECK(session.Doc().drawn == second.drawn);
  CHECK(session.Doc().controllers.front().genes == first.controllers.front().genes);
  CHECK(host.status == "Another brain drives this body. Undo restores the previous version.");
  session.Undo();
  CHECK(session.Doc().controllers.front().genes == second.controllers.front().genes);
  // A search that started from a motion began with a body that no document has.
  FoundMotion found{.document = second, .origin = Origin::kDone};
  CHECK(found.CanRepeat());
  found.document.search.start = 0;
  CHECK_FALSE(found.CanRepeat());
  // Not for a figure with another tree.
  session.ChooseFigure(0);
  CHECK_FALSE(session.CanTryBrain(first));
}

TEST_CASE("body: attempts are shown with their own bodies", "[shell][session][body]") {
  QuietHost host;
  Session session(host);
  REQUIRE(session.Begin(""));
  SearchBody(session);
  const std::size_t genes = ProblemOf(host.started.back()).Shape().Genes();
  session.OnSearchProgress({.state = SearchState::kRunning,
                            .evaluations = 0,
                            .budget = 50,
                            .curve = {},
                            .best_genome = {},
                            .attempt = Genome(genes, 9000)});
  REQUIRE(session.Tried().Shown().size() == 1);
  CHECK(session.Tried().Shown().front().Shown().Bones().limbs[1].max_rad !=
        session.Player().Shown().Bones().limbs[1].max_rad);
}

}  // namespace gaitsmith::shell::test
