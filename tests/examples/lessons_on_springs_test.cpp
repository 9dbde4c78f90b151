// SPDX-License-Identifier: MIT
// Every number of the lesson about a figure of springs is searched for and measured again here, as
// examples/lessons/make does.
#include <catch_amalgamated.hpp>

#include "tests/lesson.h"

namespace gaitsmith::test {

TEST_CASE("lessons: no bones", "[lessons][springs]") {
  const Lesson lesson = LessonOf("12-no-bones");
  const Document drawn = Shipped("lessons/12-table"), soft = Shipped("lessons/12-soft");
  const Document stiff = Shipped("lessons/12-stiff");

  Says(lesson, "ten masses and 19 springs");
  CHECK(drawn.figure.nodes.size() == 10);
  CHECK(drawn.figure.springs.size() == 19);
  Says(lesson, "Eight springs, in its legs, are **muscles**");
  CHECK(drawn.figure.Muscles() == 8);
  Says(lesson, "it gets 10.3 m far in 8 s");
  CHECK(Rounded(TermsOf(drawn).travel_m, 1) == 10.3);
  CHECK(drawn.duration_steps == 800);
  CHECK(FindWith(drawn, Algorithm::kPoseCycle, 6, 4000).document.controllers[0].genes ==
        drawn.controllers[0].genes);

  Says(lesson, "All springs get a quarter as stiff. The rules stay the same.");
  CHECK(soft.controllers[0].genes == drawn.controllers[0].genes);
  CHECK(stiff.controllers[0].genes == drawn.controllers[0].genes);
  for (std::size_t i = 0; i < drawn.figure.springs.size(); ++i) {
    CHECK(soft.figure.springs[i].stiffness_npm == 0.25f * drawn.figure.springs[i].stiffness_npm);
    CHECK(stiff.figure.springs[i].stiffness_npm == 4.0f * drawn.figure.springs[i].stiffness_npm);
  }
  Says(lesson, "[0.5 m]");
  CHECK(Rounded(TermsOf(soft).travel_m, 1) == 0.5);
  Says(lesson, "[3.6 m]");
  CHECK(Rounded(TermsOf(stiff).travel_m, 1) == 3.6);

  const Document soft_taught = Shipped("lessons/12-soft-taught");
  const Document stiff_taught = Shipped("lessons/12-stiff-taught");
  Says(lesson, "[11.6 m]");
  CHECK(Rounded(TermsOf(soft_taught).travel_m, 1) == 11.6);
  CHECK(FindWith(soft, Algorithm::kPoseCycle, 6, 4000).document.controllers[0].genes ==
        soft_taught.controllers[0].genes);
  Says(lesson, "[5.7 m]");
  CHECK(Rounded(TermsOf(stiff_taught).travel_m, 1) == 5.7);
  CHECK(FindWith(stiff, Algorithm::kPoseCycle, 6, 4000).document.controllers[0].genes ==
        stiff_taught.controllers[0].genes);
}

}  // namespace gaitsmith::test
