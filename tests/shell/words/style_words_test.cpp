// SPDX-License-Identifier: MIT
#include "shell/words/style_words.h"

#include <catch_amalgamated.hpp>

namespace gaitsmith::shell::test {

TEST_CASE("style words: travel to the left has a minus sign", "[shell][style_words]") {
  Terms terms{.travel_m = -18.334f, .max_cm_height_m = 0.97f, .slip_sum_m = 20.86f, .rotations = 0.02f};
  CHECK(TermsLine(terms) == "−18.33 m · up to 0.97 m · slip 20.9 m · turns 0.02");
  terms.travel_m = -0.001f;
  CHECK(TermsLine(terms).starts_with("0.00 m"));
}

}  // namespace gaitsmith::shell::test
