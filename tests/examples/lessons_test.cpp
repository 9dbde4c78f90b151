// SPDX-License-Identifier: MIT
// Every lesson has its parts and opens valid documents, and its goal is not met when it opens.
// lessons_on_*_test.cpp measure the numbers in lessons. tests/web checks
// how a page displays the text.
#include <algorithm>
#include <catch_amalgamated.hpp>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "core/document/json.h"
#include "tests/lesson.h"
#include "tests/scene.h"

namespace gaitsmith::test {

namespace {

const std::vector<std::string> kLessons = {"1-a-rule",      "2-how-search-finds",  "3-timer-or-senses",
                                           "4-style",       "5-which-search-wins", "6-wind-up-toys",
                                           "7-chaining",    "8-the-judge",         "9-many-ways",
                                           "10-how-strong", "11-by-heart",         "12-no-bones"};

}  // namespace

TEST_CASE("lessons: each has its parts, and opens documents that are valid", "[lessons]") {
  const std::vector<std::string> known = {"title", "minutes", "open", "panels", "lock", "goal"};
  std::set<std::string> linked;
  for (const std::string& name : kLessons) {
    CAPTURE(name);
    const Lesson lesson = LessonOf(name);
    for (const std::string& field : known) CHECK(lesson.fields.contains(field));
    CHECK(lesson.fields.size() == known.size());
    CHECK(lesson.fields.at("minutes") == "10");
    CHECK(lesson.words >= 250);
    CHECK(lesson.words <= 450);
    for (const char* part : {"## Do ", "## Notice ", "## Explain "}) Says(lesson, part);
    REQUIRE(lesson.fences.contains("predict"));
    REQUIRE(lesson.fences.contains("quiz"));
    CHECK(lesson.fences.at("quiz").size() <= 2);
    REQUIRE(lesson.fences.contains("goal"));
    REQUIRE(lesson.fences.at("goal").size() == 1);
    CHECK(lesson.fences.at("goal")[0].starts_with(lesson.fields.at("goal") + "\n"));
    CHECK(lesson.links.size() >= 2);
    for (const std::string& path : lesson.links) {
      CAPTURE(path);
      linked.insert(path);
      const auto document = DecodeJson(ReadFile(path));
      REQUIRE(document);
      CHECK(Validate(*document));
      CHECK(document->hash);
    }
    const auto opened = DecodeJson(ReadFile(lesson.links[0]));
    CHECK_FALSE(Reaches(lesson.fields.at("goal"), *opened));
  }
  for (const std::string& path : LessonDocuments()) {
    CAPTURE(path);
    CHECK(linked.contains(path));
  }
}

}  // namespace gaitsmith::test
