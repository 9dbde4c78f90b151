// SPDX-License-Identifier: MIT
// The goals that the page offers: their tasks, their names, and why one is not offered.
#include "shell/words/goal_words.h"

#include <algorithm>
#include <catch_amalgamated.hpp>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "core/document/json.h"
#include "core/document/standing.h"
#include "shell/embedded/embedded.h"
#include "shell/workspace/shipped_documents.h"

namespace gaitsmith::shell::test {
namespace {

std::string KeyOf(std::string_view figure, std::string_view goal) {
  std::string key(figure);
  return key.append(",").append(goal);
}

/// A result file of docs/studies/goals: seeds that meet a goal, by KeyOf and strength.
std::map<std::string, std::map<float, int>> Counts(const char* name) {
  std::ifstream file(std::string(GAITSMITH_SOURCE_DIR "/docs/studies/goals/") + name);
  std::map<std::string, std::map<float, int>> counts;
  std::string line;
  for (std::getline(file, line); std::getline(file, line);) {
    std::istringstream fields(line);
    std::string figure, goal, strength, seeds, met;
    for (std::string* field : {&figure, &goal, &strength, &seeds, &met}) std::getline(fields, *field, ',');
    counts[KeyOf(figure, goal)][std::stof(strength)] = std::stoi(met);
  }
  return counts;
}

}  // namespace

TEST_CASE("goals: strengths and counts are those of the study", "[shell][goals]") {
  const auto tuning = Counts("tuning-met.csv"), table = Counts("table.csv");
  std::size_t measured = 0;
  for (const Example& example : ExampleFigures()) {
    const auto figure = DecodeFigureJson(example.json);
    REQUIRE(figure);
    ++measured;
    for (int i = 0; i < kGoals; ++i) {
      const auto goal = static_cast<Goal>(i);
      const std::string key = KeyOf(example.name, kGoalNames[static_cast<std::size_t>(i)]);
      CAPTURE(key);
      const float strength = StrengthOf(goal, figure->name);
      CHECK(table.at(key) ==
            std::map<float, int>{{strength, SeedsThatMeet(goal, figure->name).value_or(-1)}});
      if (!tuning.contains(key)) continue;  // goals without weights have no strength
      // The most seeds, the smallest strength of equals: the map is in their order.
      const auto& tried = tuning.at(key);
      CHECK(strength ==
            std::ranges::max_element(tried, {}, [](const auto& one) { return one.second; })->first);
    }
  }
  CHECK(table.size() == measured * kGoals);
}

TEST_CASE("goals: a document has the goal that was set, at every strength a valid task", "[shell][goals]") {
  const ShippedDocuments shipped;
  for (const Figure& figure : shipped.Figures()) {
    for (int i = 0; i < kGoals; ++i) {
      const auto goal = static_cast<Goal>(i);
      Document document = Standing(figure);
      document.task.duration_steps = 500;
      SetGoal(goal, document);
      CAPTURE(figure.name, kGoalNames[static_cast<std::size_t>(i)]);
      CHECK(GoalOf(document) == goal);
      CHECK(document.task.duration_steps == 500);
      for (const float strength : kGoalStrengths) {
        SetGoal(goal, strength, document);
        CHECK(Validate(document));
      }
      document.task.weights[0] += 0.5f;
      CHECK_FALSE(GoalOf(document));
    }
    // The first visit asks for distance.
    CHECK(GoalOf(Standing(figure)) == Goal::kFar);
    for (int i = 0; i < kGoals; ++i) CHECK(SeedsThatMeet(static_cast<Goal>(i), figure.name));
  }
  CHECK_FALSE(SeedsThatMeet(Goal::kFar, "A figure of one’s own"));
}

TEST_CASE("goals: one is offered if sixteen of twenty tries meet it, and for every other figure",
          "[shell][goals]") {
  const ShippedDocuments shipped;
  for (const Figure& figure : shipped.Figures()) {
    for (int i = 0; i < kGoals; ++i) {
      const auto goal = static_cast<Goal>(i);
      const int met = SeedsThatMeet(goal, figure.name).value_or(-1);
      CAPTURE(figure.name, kGoalNames[static_cast<std::size_t>(i)], met);
      CHECK(Offers(goal, figure.name) == (met >= 16));
      CHECK(WhyNotOffered(goal, figure.name) ==
            "Only " + std::to_string(met) + " of 20 tries with this figure managed it.");
    }
  }
  CHECK(Offers(Goal::kCartwheel, "A figure of one’s own"));
}

}  // namespace gaitsmith::shell::test
