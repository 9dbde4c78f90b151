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

TEST_CASE("style words: muscles move in drawn lengths, joints in radians", "[shell][style_words]") {
  Document document;
  document.task.weights[static_cast<std::size_t>(StyleTerm::kEffort)] = -0.5f;
  Terms terms;
  terms.effort_rad = 12.0f;
  terms.smoothness_radps2 = -3.0f;
  const std::string joints = ScoreWords(document, terms);
  CHECK(joints.find("effort 12.0 rad times −0.5 takes away 6.00") != std::string::npos);
  CHECK(joints.find("smoothness −3.0 rad/s²") != std::string::npos);
  document.figure = {
      .name = "", .rods = {}, .nodes = {{.x_m = 0.0f}, {.x_m = 1.0f}}, .springs = {{.min_rest = 0.5f}}};
  const std::string muscles = ScoreWords(document, terms);
  CHECK(muscles.find("effort 12.0 lengths times −0.5 takes away 6.00") != std::string::npos);
  CHECK(muscles.find("smoothness −3.0 lengths/s²") != std::string::npos);
  CHECK(muscles.find("rad") == std::string::npos);
}

}  // namespace gaitsmith::shell::test
