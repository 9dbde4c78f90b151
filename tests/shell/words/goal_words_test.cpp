// SPDX-License-Identifier: MIT
// The goals that the page offers: their tasks, their names, and why one is not offered.
#include "shell/words/goal_words.h"

#include <catch_amalgamated.hpp>

#include "core/document/standing.h"
#include "shell/workspace/shipped_documents.h"

namespace gaitsmith::shell::test {

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
