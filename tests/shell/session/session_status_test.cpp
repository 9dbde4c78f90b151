// SPDX-License-Identifier: MIT
// The status line reports the last action or is empty: no action leaves the sentence of an earlier one.
#include <catch_amalgamated.hpp>
#include <functional>
#include <utility>

#include "tests/shell/session/quiet_host.h"

namespace gaitsmith::shell::test {

namespace {

using Action = std::pair<const char*, std::function<void(Session&)>>;

const Action kActions[] = {
    {"mirror", [](Session& s) { s.Timeline().MirrorClip(); }},
    {"split",
     [](Session& s) {
       s.Player().Seek(1.0);
       s.Timeline().SplitClip();
     }},
    {"duplicate", [](Session& s) { s.Timeline().DuplicateClip(); }},
    {"add a clip", [](Session& s) { s.Timeline().AddClip(); }},
    {"repeat", [](Session& s) { s.Timeline().Repeat(); }},
    {"edit the world", [](Session& s) { s.Change([](Document& d) { d.environment.friction = 0.3f; }); }},
    {"set the search", [](Session& s) { s.Set([](Document& d) { d.search.seed = 99; }); }},
    {"edit the figure",
     [](Session& s) {
       Figure figure = s.Doc().figure;
       figure.rods[1].length_m *= 0.9f;
       s.ReplaceFigure(figure);
     }},
    {"remove from the queue", [](Session& s) { s.Queue().List().Clear(); }},
    {"bookmark a result",
     [](Session& s) {
       FoundMotions& motions = s.Results().Motions();
       motions.Keep(motions.Sorted(FoundMotions::Order::kNewest).front()->id, false);
     }},
};

}  // namespace

TEST_CASE("session: no action leaves the sentence of an earlier one", "[shell][session][status]") {
  for (const auto& [name, act] : kActions) {
    CAPTURE(name);
    QuietHost host;
    Session session(host);
    REQUIRE(session.Results().KeepShown());
    REQUIRE(session.Queue().Add(session.Doc()));
    session.New();  // Say: on the panel, too
    session.Undo();
    REQUIRE_FALSE(session.Doc().timeline.empty());
    const std::string before = "An earlier sentence.";
    host.status = before;
    session.Notice() = before;
    session.BeginGesture();
    act(session);
    CHECK(host.status != before);
    CHECK(session.Notice() != before);
  }
}

TEST_CASE("session: mirroring and snapping report what they did", "[shell][session][status]") {
  QuietHost host;
  Session session(host);
  session.Timeline().MirrorClip();
  CHECK(host.status == "Mirrored: clip 1 goes the other way.");
  session.Undo();
  CHECK(host.status == "Undone: the motion.");
  session.Timeline().AddClip();
  CHECK(host.status.empty());
}

}  // namespace gaitsmith::shell::test
