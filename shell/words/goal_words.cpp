// SPDX-License-Identifier: MIT
#include "shell/words/goal_words.h"

#include "shell/words/language.h"

namespace gaitsmith::shell {

const std::array<GoalWords, kGoals>& GoalTexts() {
  static constexpr std::array<GoalWords, kGoals> kTexts = {{
      {TrLater("Far"), TrLater("As far to the right as it can."), nullptr},
      {TrLater("High jump"), TrLater("Its body as high as it can."), TrLater("Teach it to jump")},
      {TrLater("Cartwheel"), TrLater("Far, and over and over."), TrLater("Teach it to tumble")},
      {TrLater("Glide"), TrLater("Far, with feet that slide."), TrLater("Teach it to glide")},
      {TrLater("Calm"), TrLater("Far, with little and smooth movement."), TrLater("Teach it to move calmly")},
      {TrLater("Head up"), TrLater("Far, upright and with its head high."),
       TrLater("Teach it to keep its head up")},
  }};
  return kTexts;
}

const GoalWords& WordsOf(Goal goal) { return GoalTexts()[static_cast<std::size_t>(goal)]; }

bool Offers(Goal goal, std::string_view figure) {
  return SeedsThatMeet(goal, figure).value_or(kGoalSeeds) >= kSeedsToOffer;
}

std::string WhyNotOffered(Goal goal, std::string_view figure) {
  return Tr("Only {1} of {2} tries with this figure managed it.", SeedsThatMeet(goal, figure).value_or(0),
            kGoalSeeds);
}

}  // namespace gaitsmith::shell
