// SPDX-License-Identifier: MIT
#include "shell/words/hints.h"

#include <catch_amalgamated.hpp>

namespace gaitsmith::shell {

TEST_CASE("hints: the first family that fits counts, and a reason is only of a disabled widget") {
  REQUIRE(SetHints(R"({"found/keep": "Saves.", "found/*/keep": "Keeps.", "found/*": "Plays.",
                       "found/*/keep!": "Nothing to keep.", "play": "Plays all."})"));
  CHECK(HintFor("found/keep") == "Saves.");
  CHECK(HintFor("found/7/keep") == "Keeps.");
  CHECK(HintFor("found/7") == "Plays.");
  CHECK(HintFor("found/7/keep", true) == "Keeps. Nothing to keep.");
  CHECK(HintFor("found/7/keep", true, "It is locked.") == "Keeps. It is locked.");
  CHECK(HintFor("found/7", true) == "Plays.");  // its own sentence is no reason
  CHECK(HintFor("foun").empty());
  CHECK(HintFor("play/0").empty());
  REQUIRE(SetHints("{}"));
}

TEST_CASE("hints: a damaged table changes nothing") {
  REQUIRE(SetHints(R"({"play": "Plays."})"));
  CHECK_FALSE(SetHints(R"({"play": )"));
  CHECK_FALSE(SetHints("[1]"));
  CHECK(HintFor("play") == "Plays.");
  REQUIRE(SetHints("{}"));
}

}  // namespace gaitsmith::shell
