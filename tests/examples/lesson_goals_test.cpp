// SPDX-License-Identifier: MIT
// The goal of each lesson is reached by what the lesson asks for, and not by what the lesson itself opens,
// nor by a way around. tests/examples/lesson_goals.json lists them:
//
//   ways    meet the goal
//   doors   do not meet it, although the motion gets as far as the goal wants: such a door was open once
//   misses  do not meet it
#include <catch_amalgamated.hpp>
#include <string>

#include "tests/lesson_visit.h"
#include "tests/scene.h"

namespace gaitsmith::test {

TEST_CASE("lessons: each goal is reached as intended, and by no side door", "[lessons]") {
  const auto table = ParseJson(ReadFile("tests/examples/lesson_goals.json"));
  REQUIRE(table);
  CHECK(table->names.size() == 12);
  const auto lesson_index = static_cast<std::size_t>(GENERATE(range(0, 11)));
  const std::string& name = table->names[lesson_index];
  CAPTURE(name);
  const Lesson lesson = LessonOf(name);
  const std::string& goal = lesson.fields.at("goal");
  for (const char* kind : {"ways", "doors", "misses"}) {
    const JsonValue* visits = table->items[lesson_index].Find(kind);
    REQUIRE(visits != nullptr);
    CHECK_FALSE(visits->items.empty());
    for (std::size_t i = 0; i < visits->items.size(); ++i) {
      CAPTURE(kind, visits->names[i]);
      LessonVisit visit(lesson);
      for (const JsonValue& step : visits->items[i].items) visit.Do(step);
      const bool way = kind == std::string("ways");
      CHECK(visit.Meets(goal) == way);
      if (kind == std::string("doors")) CHECK(Reaches(goal, visit.Doc()));
    }
  }
}

}  // namespace gaitsmith::test
