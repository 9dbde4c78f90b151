// SPDX-License-Identifier: MIT
// Every number of the lesson about trajectories is searched for and measured again here, as
// examples/lessons/make does.
#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>
#include <vector>

#include "core/document/recording.h"
#include "tests/lesson.h"

namespace gaitsmith::test {

namespace {

double DistanceOf(const Document& document) {
  return std::abs(static_cast<double>(TermsOf(document).travel_m));
}

Push PushAt(int step, float impulse_x_ns) { return {.step = step, .impulse_x_ns = impulse_x_ns}; }

/// How often of ten pushes, 3.0 s to 3.9 s, more than half of the way is left.
int Survives(Document document, float impulse_x_ns) {
  const double half = 0.5 * DistanceOf(document);
  int count = 0;
  for (int step = 300; step < 400; step += 10) {
    document.pushes = {PushAt(step, impulse_x_ns)};
    count += DistanceOf(document) > half ? 1 : 0;
  }
  return count;
}

}  // namespace

TEST_CASE("lessons: by heart", "[lessons][trajectory]") {
  const Lesson lesson = LessonOf("11-by-heart");
  const Document rules = Shipped("lessons/10-strong"), heart = Shipped("lessons/11-by-heart");
  const Document practised = Shipped("lessons/11-practised");

  Says(lesson, "Mr. Star-Man gets 21.6 m far in 10 s.");
  CHECK(Rounded(TermsOf(rules).travel_m, 1) == 21.6);
  Says(lesson, "a smooth curve for each joint, through 32 points");
  const auto recording = RecordAsCurves(rules, 32);
  REQUIRE(recording);
  CHECK(recording->document.controllers[0].genes == heart.controllers[0].genes);
  // By heart each joint differs from his by less than 2 degrees, usually.
  CHECK(recording->typical_rad < 2.0 * 3.14159 / 180.0);
  Says(lesson, "by heart | [6.5 m]");
  CHECK(Rounded(TermsOf(heart).travel_m, 1) == 6.5);

  Says(lesson, "practised | [18.0 m]");
  CHECK(FindWith(practised, Algorithm::kPoseCycle, 1, 4000).document.controllers[0].genes ==
        practised.controllers[0].genes);
  CHECK(Rounded(TermsOf(practised).travel_m, 1) == 18.0);

  Says(lesson, "Now push both at 3 s, straight back with 10 N s");
  for (const char* pushed : {"lessons/11-pushed", "lessons/11-practised-pushed"}) {
    const Document document = Shipped(pushed);
    REQUIRE(document.pushes.size() == 1);
    CHECK(document.pushes[0].step == 300);
    CHECK(document.pushes[0].impulse_x_ns == -10.0f);
  }
  Says(lesson, "Both still got more than half of their way, ten times of ten.");
  CHECK(Survives(rules, -10.0f) == 10);
  CHECK(Survives(practised, -10.0f) == 10);
  Says(lesson, "Pushed from behind, the curves managed it nine times, the rules three times.");
  CHECK(Survives(practised, 10.0f) == 9);
  CHECK(Survives(rules, 10.0f) == 3);
}

}  // namespace gaitsmith::test
