// SPDX-License-Identifier: MIT
// The panels that a lesson shows and the parts that it locks: valid and invalid lists, and edits that a lock
// permits. Does not pin how a locked panel is drawn.
#include "shell/workspace/arrangement.h"

#include <catch_amalgamated.hpp>

#include "shell/session/session.h"
#include "tests/shell/session/quiet_host.h"

namespace gaitsmith::shell::test {

TEST_CASE("arrangement: a list shows exactly its panels", "[arrangement]") {
  Arrangement arrangement;
  CHECK(arrangement.Shows(0));
  REQUIRE_FALSE(ShowPanels("style,search", arrangement));
  CHECK(arrangement.shown == std::array{false, false, true, true, false, false, false});
  REQUIRE_FALSE(ShowPanels("none", arrangement));
  CHECK(arrangement.shown == std::array{false, false, false, false, false, false, false});
  REQUIRE_FALSE(ShowPanels("all", arrangement));
  CHECK(arrangement.shown == std::array{true, true, true, true, true, true, true});

  const auto wrong = ShowPanels("style,kitchen,search", arrangement);
  REQUIRE(wrong);
  CHECK(*wrong == "kitchen");
  CHECK(arrangement.shown == std::array{true, true, true, true, true, true, true});
  REQUIRE(LockParts("figure,,", arrangement));
  REQUIRE(LockParts("lab", arrangement));  // not lockable
  REQUIRE_FALSE(LockParts("", arrangement));
  CHECK(arrangement.locked == std::array{false, false, false, false, false, false});
}

TEST_CASE("arrangement: a lock refuses edits of its part and permits all others", "[arrangement]") {
  QuietHost host;
  Session session(host);
  const Document before = session.Doc();
  REQUIRE_FALSE(before.controllers.empty());

  const struct {
    const char* part;
    Session::Edit edit;
  } edits[] = {
      {"figure", [](Document& d) { d.figure.rods[0].length_m *= 1.5f; }},
      {"controller",
       [](Document& d) {
         d.controllers[0].genes[0] = static_cast<std::uint16_t>(d.controllers[0].genes[0] ^ 1);
       }},
      {"style", [](Document& d) { d.task.weights[1] += 1.0f; }},
      {"search", [](Document& d) { d.search.seed += 1; }},
      {"timeline", [](Document& d) { d.duration_steps -= 100; }},
      {"world", [](Document& d) { d.environment.friction = 0.1f; }},
  };
  for (const auto& [locked, refused] : edits) {
    session.Layout() = {};
    REQUIRE_FALSE(LockParts(locked, session.Layout()));
    for (const auto& [part, edit] : edits) {
      CAPTURE(locked, part);
      const bool same = std::string_view(part) == locked;
      const bool done = session.Change(edit);
      CHECK(done == !same);
      CHECK(session.Notice().empty() == !same);
      if (done) session.Undo();
    }
  }
}

TEST_CASE("arrangement: locks refuse other shipped figures and problems, but not opened documents",
          "[arrangement]") {
  QuietHost host;
  Session session(host);
  REQUIRE_FALSE(LockParts("figure,style,world", session.Layout()));
  const std::string name = session.Doc().figure.name;

  for (int figure = 0; figure < static_cast<int>(session.Shipped().Figures().size()); ++figure)
    session.ChooseFigure(figure);
  CHECK(session.Doc().figure.name == name);
  for (int problem = 0; problem < static_cast<int>(session.Shipped().Problems().size()); ++problem) {
    if (session.Shipped().Problems()[static_cast<std::size_t>(problem)].figure.name != name)
      session.ChooseProblem(problem);
  }
  CHECK(session.Doc().figure.name == name);

  // Locks do not apply to opened documents.
  REQUIRE(session.Open(R"({"title": "Other", "figure": {"name": "Tail", "rods": [{}, {"parent": 0}]}})"));
  CHECK(session.Doc().figure.name == "Tail");
}

}  // namespace gaitsmith::shell::test
