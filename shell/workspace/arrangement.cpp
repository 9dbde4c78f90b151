// SPDX-License-Identifier: MIT
#include "shell/workspace/arrangement.h"

#include <algorithm>
#include <iterator>

#include "core/document/parts.h"

namespace gaitsmith::shell {
namespace {

// Sets the flags that a list names and clears all others.
template <std::size_t N>
std::optional<std::string_view> Choose(std::string_view list, const std::array<const char*, N>& names,
                                       std::array<bool, N>& flags) {
  std::array<bool, N> chosen = {};
  while (!list.empty()) {
    const std::string_view word = list.substr(0, list.find(','));
    list.remove_prefix(std::min(list.size(), word.size() + 1));
    if (word == "none") continue;
    if (word == "all") {
      chosen.fill(true);
      continue;
    }
    const auto name = std::ranges::find(names, word);
    if (name == names.end()) return word;
    chosen[static_cast<std::size_t>(name - names.begin())] = true;
  }
  flags = chosen;
  return std::nullopt;
}

/// Ignores kept controllers: the timeline decides which controllers exist.
bool RulesDiffer(const Document& before, const Document& after) {
  return before.controllers.size() == after.controllers.size() &&
         !std::ranges::equal(before.controllers, after.controllers, SameBehaviour);
}

// The document parts behind each lock. Controllers are compared by behaviour alone, since the figure decides
// their length.
constexpr Parts kLockedParts[] = {
    Part::kFigure,
    Part::kSought,
    Part::kGoal,
    {Part::kSearch, Part::kTakeover, Part::kTaskLength},
    {Part::kTimeline, Part::kDuration, Part::kPlan},
    {Part::kModel, Part::kEnvironment, Part::kStart, Part::kPushes},
};
static_assert(std::size(kLockedParts) == kLockedPartNames.size());

}  // namespace

bool Arrangement::LocksPanel(int panel) const {
  const auto part = std::ranges::find(kLockedPartNames, kPanels[static_cast<std::size_t>(panel)].lock);
  return part != kLockedPartNames.end() && locked[static_cast<std::size_t>(part - kLockedPartNames.begin())];
}

std::optional<std::string_view> ShowPanels(std::string_view list, Arrangement& arrangement) {
  return Choose(list, kPanelIds, arrangement.shown);
}

std::optional<std::string_view> LockParts(std::string_view list, Arrangement& arrangement) {
  return Choose(list, kLockedPartNames, arrangement.locked);
}

std::optional<LockedPart> LockedDifference(const Arrangement& arrangement, const Document& before,
                                           const Document& after) {
  const Parts differing = DifferingParts(before, after);
  for (std::size_t i = 0; i < kLockedPartNames.size(); ++i) {
    if (!arrangement.locked[i]) continue;
    const auto part = static_cast<LockedPart>(i);
    const bool rules = part == LockedPart::kController && RulesDiffer(before, after);
    if (rules || differing.HasAny(kLockedParts[i])) return part;
  }
  return std::nullopt;
}

}  // namespace gaitsmith::shell
