// SPDX-License-Identifier: MIT
#include "shell/arrangement.h"

#include <algorithm>

#include "core/document/binary.h"

namespace gaitsmith::shell {
namespace {

constexpr std::array<const char*, kPanels.size()> kPanelNames = {"figure", "controller", "style",
                                                                 "search", "lab",        "timeline"};

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

void CopyPart(LockedPart part, const Document& from, Document& to) {
  switch (part) {
    case LockedPart::kFigure:
      to.figure = from.figure;
      break;
    case LockedPart::kController:
      to.controllers = from.controllers;
      to.kind = from.kind;
      to.senses = from.senses;
      to.rules = from.rules;
      break;
    case LockedPart::kStyle:
      to.task.kind = from.task.kind;
      to.task.weights = from.task.weights;
      break;
    case LockedPart::kSearch:
      to.search = from.search;
      to.task.duration_steps = from.task.duration_steps;
      break;
    case LockedPart::kTimeline:
      to.timeline = from.timeline;
      to.duration_steps = from.duration_steps;
      break;
    case LockedPart::kWorld:
      to.environment = from.environment;
      to.start = from.start;
      to.pushes = from.pushes;
      break;
  }
}

}  // namespace

bool Arrangement::LocksPanel(int panel) const {
  const std::string_view name = kPanelNames[static_cast<std::size_t>(panel)];
  const auto part = std::ranges::find(kLockedPartNames, name);
  return name != "search" && part != kLockedPartNames.end() &&
         locked[static_cast<std::size_t>(part - kLockedPartNames.begin())];
}

std::optional<std::string_view> ShowPanels(std::string_view list, Arrangement& arrangement) {
  return Choose(list, kPanelNames, arrangement.shown);
}

std::optional<std::string_view> LockParts(std::string_view list, Arrangement& arrangement) {
  return Choose(list, kLockedPartNames, arrangement.locked);
}

std::optional<LockedPart> LockedDifference(const Arrangement& arrangement, const Document& before,
                                           const Document& after) {
  for (std::size_t i = 0; i < kLockedPartNames.size(); ++i) {
    if (!arrangement.locked[i]) continue;
    Document mixed = before;
    CopyPart(static_cast<LockedPart>(i), after, mixed);
    if (EncodeBinary(mixed) != EncodeBinary(before)) return static_cast<LockedPart>(i);
  }
  return std::nullopt;
}

}  // namespace gaitsmith::shell
