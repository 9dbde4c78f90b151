// SPDX-License-Identifier: MIT
#include "shell/words/figure_words.h"

#include <algorithm>

#include "core/physics/figure.h"
#include "shell/words/goal_words.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

using enum Gait;

// In the order of Gait.
constexpr const char* kTeach[] = {TrLater("Teach it to move"), TrLater("Teach it to run"),
                                  TrLater("Teach it to hop"), TrLater("Teach it to crawl"),
                                  TrLater("Teach it to roll")};

struct FigureWords {
  std::string_view figure;
  const char* cannot_move;
  Gait gait;
};
/// Figures with a name of their own, such as Mr. Star-Man, are called by it.
constexpr FigureWords kFigures[] = {
    {"Acrobat", TrLater("This acrobat can’t move yet."), kRun},
    {"Beryl Biped", nullptr, kRun},
    {"Caterpillar", TrLater("This caterpillar can’t move yet."), kCrawl},
    {"Crab", TrLater("This crab can’t move yet."), kCrawl},
    {"Fish", TrLater("This fish can’t move yet."), kHop},
    {"Frog", TrLater("This frog can’t move yet."), kHop},
    {"Hopper", TrLater("This hopper can’t move yet."), kHop},
    {"Horse", TrLater("This horse can’t move yet."), kRun},
    {"Inchworm", TrLater("This inchworm can’t move yet."), kCrawl},
    {"Jelly", TrLater("This jelly can’t move yet."), kHop},
    {"Kangaroo", TrLater("This kangaroo can’t move yet."), kHop},
    {"Ostrich", TrLater("This ostrich can’t move yet."), kRun},
    {"Seven-Pointed Star", TrLater("This star can’t move yet."), kRoll},
    {"Snake", TrLater("This snake can’t move yet."), kCrawl},
    {"Soft Star", TrLater("This star can’t move yet."), kRoll},
    {"Soft Wheel", TrLater("This wheel can’t move yet."), kRoll},
    {"Soft Worm", TrLater("This worm can’t move yet."), kCrawl},
    {"Spider", TrLater("This spider can’t move yet."), kCrawl},
    {"Torsoless Biped", TrLater("This pair of legs can’t move yet."), kRun},
    {"Tumbler", TrLater("This tumbler can’t move yet."), kRoll},
    {"Walking Table", TrLater("This table can’t move yet."), kRun},
};

const FigureWords* WordsAbout(std::string_view name) {
  const auto* const row = std::ranges::find(kFigures, KindOf(name), &FigureWords::figure);
  return row == std::end(kFigures) ? nullptr : row;
}

}  // namespace

std::string CannotMoveWords(std::string_view name) {
  const FigureWords* row = WordsAbout(name);
  if (row != nullptr && row->cannot_move != nullptr) return Tr(row->cannot_move);
  return Tr("{1} can’t move yet.", name.empty() ? Tr("A figure") : TrTitle(name));
}

const char* TeachWords(const Document& document) {
  const auto goal = GoalOf(document);
  if (goal && WordsOf(*goal).teach != nullptr) return Tr(WordsOf(*goal).teach);
  return Tr(kTeach[static_cast<std::size_t>(GaitOf(document.figure.name))]);
}

Gait GaitOf(std::string_view name) {
  const FigureWords* row = WordsAbout(name);
  return row == nullptr ? kMove : row->gait;
}

}  // namespace gaitsmith::shell
