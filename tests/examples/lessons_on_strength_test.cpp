// SPDX-License-Identifier: MIT
// Every number of the lesson about limited joints is searched for and measured again here, as
// examples/lessons/make does.
#include <catch_amalgamated.hpp>
#include <cmath>
#include <string>

#include "core/document/joints.h"
#include "tests/lesson.h"

namespace gaitsmith::test {

namespace {

double WayOf(const Document& document) { return Rounded(std::abs(TermsOf(document).travel_m), 1); }

/// The document's search again.
Document Again(const Document& document) {
  return FindWith(document, Algorithm::kPoseCycle, document.search.seed, document.search.evaluations)
      .document;
}

}  // namespace

TEST_CASE("lessons: how strong is Mr. Star-Man", "[lessons]") {
  const Lesson lesson = LessonOf("10-how-strong");
  const Document strong = Shipped("lessons/10-strong"), animal = Shipped("lessons/10-animal");
  const Document weak = Shipped("lessons/10-weak");
  CHECK(strong.search.algorithm == Algorithm::kPoseCycle);
  for (const Document* searched : {&strong, &animal, &weak})
    CHECK(Again(*searched).controllers[0].genes == searched->controllers[0].genes);

  Says(lesson, "Mr. Star-Man gets 21.6 m far in 10 s.");
  CHECK_FALSE(HasLimitedJoints(strong));
  CHECK(strong.duration_steps == 1000);
  CHECK(WayOf(strong) == 21.6);

  Document limited = strong;
  LimitJoints(limited);
  Says(lesson, "| strength 2 | the same | [2.1 m]");
  CHECK(JointStrength(limited) == 2.0f);
  CHECK(WayOf(limited) == 2.1);
  CHECK(WayOf(Shipped("lessons/10-strong-limited")) == 2.1);

  Says(lesson, "| strength 2 | found for them | [15.5 m]");
  CHECK(JointStrength(animal) == 2.0f);
  CHECK(WayOf(animal) == 15.5);
  Says(lesson, "| strength 0.5 | found for them | [10.1 m]");
  CHECK(JointStrength(weak) == 0.5f);
  CHECK(WayOf(weak) == 10.1);
  Says(lesson, "he turned over 2.7 times");
  CHECK(Rounded(TermsOf(weak).rotations, 1) == 2.7);

  // The answer in docs/lesson-answers.md.
  SetJointStrength(20.0f, limited);
  CHECK(WayOf(limited) == 20.7);
  SetJointStrength(8.0f, limited);
  CHECK(WayOf(limited) == 2.5);
}

}  // namespace gaitsmith::test
