// SPDX-License-Identifier: MIT
#include "shell/session/arrangement.h"

#include <algorithm>

#include "core/document/binary.h"

namespace gaitsmith::shell {
namespace {

// Sets the flags that a list names, and no others.
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

/// Whether they are encoded alike, but for what belongs to controllers, whose length the figure decides.
bool Alike(Document a, Document b) {
  for (Document* d : {&a, &b}) {
    d->controllers.clear();
    d->timeline.clear();
    d->search.start = -1;
  }
  return EncodeBinary(a) == EncodeBinary(b);
}

bool SameMotion(const Controller& a, const Controller& b) {
  return a.kind == b.kind && a.senses == b.senses && a.rules == b.rules && a.genes == b.genes;
}

/// A controller that stays is another one. Which of them there are is the timeline's concern.
bool RulesDiffer(const Document& before, const Document& after) {
  return before.controllers.size() == after.controllers.size() &&
         !std::ranges::equal(before.controllers, after.controllers, SameMotion);
}

bool ClipsDiffer(const Document& before, const Document& after) {
  return before.duration_steps != after.duration_steps ||
         !std::ranges::equal(before.timeline, after.timeline, [](const Clip& a, const Clip& b) {
           return a.controller == b.controller && a.start_step == b.start_step;
         });
}

bool Differs(LockedPart part, const Document& before, const Document& after) {
  Document mixed = before;
  switch (part) {
    case LockedPart::kFigure:
      mixed.figure = after.figure;
      break;
    case LockedPart::kController:
      mixed.kind = after.kind;
      mixed.senses = after.senses;
      mixed.rules = after.rules;
      if (RulesDiffer(before, after)) return true;
      break;
    case LockedPart::kStyle:
      mixed.task.kind = after.task.kind;
      mixed.task.weights = after.task.weights;
      break;
    case LockedPart::kSearch:
      mixed.search = after.search;
      mixed.task.duration_steps = after.task.duration_steps;
      break;
    case LockedPart::kTimeline:
      return ClipsDiffer(before, after);
    case LockedPart::kWorld:
      mixed.environment = after.environment;
      mixed.start = after.start;
      mixed.pushes = after.pushes;
      break;
  }
  return !Alike(before, mixed);
}

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
  for (std::size_t i = 0; i < kLockedPartNames.size(); ++i) {
    const auto part = static_cast<LockedPart>(i);
    if (arrangement.locked[i] && Differs(part, before, after)) return part;
  }
  return std::nullopt;
}

}  // namespace gaitsmith::shell
