// SPDX-License-Identifier: MIT
// What Calmer, Quicker and Higher do to motions that the first press finds.
#include <catch_amalgamated.hpp>

#include "core/document/standing.h"
#include "shell/search/parallel_search.h"
#include "tests/shell/session/quiet_host.h"

namespace gaitsmith::shell::test {
namespace {

// Runs the last search that the session asked for to its end.
void RunLast(Session& session, const QuietHost& host) {
  const Document& document = host.started.back();
  SearchControl control;
  session.OnSearchProgress(RunParallelSearch(
      ProblemOf(document), document.search, 1, control, [](const SearchProgress&) {},
      SpaceOf(document).start));
}

Terms TermsOf(const Session& session) {
  const Motion& motion = session.Player().Shown();
  return motion.TermsAt(motion.Frames() - 1);
}

}  // namespace

TEST_CASE("session: Calmer, Quicker and Higher change a found motion as they say",
          "[shell][session][manner]") {
  for (const char* name : {"Ostrich", "Mr. Star-Man", "Acrobat"}) {
    CAPTURE(name);
    QuietHost host;
    Session session(host);
    const auto& figures = session.Shipped().Figures();
    const auto figure = std::ranges::find(figures, std::string(name), &Figure::name);
    REQUIRE(figure != figures.end());
    session.ChooseFigure(static_cast<int>(figure - figures.begin()));
    session.Synthesize();
    RunLast(session, host);
    const Terms found = TermsOf(session);
    const auto after = [&](Manner manner) {
      session.TryManner(manner);
      RunLast(session, host);
      const Terms changed = TermsOf(session);
      session.Undo();
      return changed;
    };
    const Terms calm = after(Manner::kCalmer), quick = after(Manner::kQuicker), high = after(Manner::kHigher);
    INFO("effort " << found.Style(StyleTerm::kEffort) << ", calmer " << calm.Style(StyleTerm::kEffort)
                   << ", quicker " << quick.Style(StyleTerm::kEffort) << "; travel " << found.travel_m
                   << ", quicker " << quick.travel_m << "; height " << found.max_cm_height_m << ", higher "
                   << high.max_cm_height_m);
    CHECK(calm.Style(StyleTerm::kEffort) < found.Style(StyleTerm::kEffort));
    CHECK(quick.Style(StyleTerm::kEffort) > found.Style(StyleTerm::kEffort));
    CHECK(high.max_cm_height_m > found.max_cm_height_m);
  }
}

}  // namespace gaitsmith::shell::test
