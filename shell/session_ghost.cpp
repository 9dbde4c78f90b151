// SPDX-License-Identifier: MIT
// The session's second motion, which the shown one is compared with: behind it as a ghost, or beside it.
#include <algorithm>

#include "shell/language.h"
#include "shell/search_words.h"
#include "shell/session.h"

namespace gaitsmith::shell {
namespace {

// For this figure and task, decided in the wanted way.
bool SuitsAsRival(const FoundMotion& found, const Document& wanted) {
  if (!found.Moves()) return false;
  const Document& d = found.document;
  return d.controllers.back().kind == wanted.kind && d.controllers.back().senses.kind == wanted.senses.kind &&
         d.figure.name == wanted.figure.name && SameRods(d.figure, wanted.figure) &&
         d.task.kind == wanted.task.kind;
}

}  // namespace

void Session::ChooseGhost(int choice) {
  ghost_ = std::clamp(choice, kNoGhost, static_cast<int>(document_.controllers.size()) - 1);
  LoadGhost();
  host_.DocumentChanged(document_.title);
}

bool Session::ChooseFoundGhost(const std::string& id) {
  const FoundMotions::Entry* entry = found.Find(id);
  if (entry == nullptr || !entry->motion.Moves() ||
      !SameRods(entry->motion.document.figure, document_.figure))
    return false;
  found_ghost_ = entry->motion.document;
  found_ghost_id_ = id;
  ghost_ = kFoundGhost;
  LoadGhost();
  host_.DocumentChanged(document_.title);
  return true;
}

std::string Session::GhostWords() const {
  if (ghost_ == kEarlierGhost) return Tr("before the last search");
  if (ghost_ == kCalmGhost) return Tr("without your changes");
  if (ghost_ == kNoGhost) return "";
  const Controller& controller = ghost_ == kFoundGhost
                                     ? found_ghost_.controllers.back()
                                     : document_.controllers[static_cast<std::size_t>(ghost_)];
  return DeciderWords(controller.kind, controller.senses);
}

void Session::PutSideBySide(bool beside) {
  side_by_side_ = beside;
  host_.DocumentChanged(document_.title);
}

void Session::CompareDeciders() {
  const Controller* shown = ShownController();
  if (shown == nullptr) {
    Say(Tr("There is no motion to compare: press Synthesize."));
    return;
  }
  Document wanted = document_;
  Decide(wanted, RivalOf(*shown));
  wanted.search.start = -1;
  for (const FoundMotions::Entry* entry : found.Sorted(FoundMotions::Order::kBest)) {
    if (!SuitsAsRival(entry->motion, wanted) || !ChooseFoundGhost(entry->id)) continue;
    side_by_side_ = true;
    return;
  }
  if (AwaitsRival() || !Enqueue(wanted)) return;
  rival_ = std::move(wanted);
  if (!Searching() && !lab.Running()) RunQueue();
}

void Session::StopComparing() {
  side_by_side_ = false;
  ChooseGhost(kNoGhost);
}

bool Session::AwaitsRival() const {
  if (!rival_) return false;
  const auto same = [&](const Document& other) { return SameSearch(other, *rival_); };
  return (Searched() != nullptr && same(*Searched())) ||
         std::ranges::any_of(queue.Waiting(), same, &SearchQueue::Entry::document);
}

void Session::MeetRival() {
  const FoundMotions::Entry* entry = rival_ ? found.Find(noted_) : nullptr;
  if (entry == nullptr || !SuitsAsRival(entry->motion, *rival_)) return;
  rival_.reset();
  if (ChooseFoundGhost(noted_)) side_by_side_ = true;
}

void Session::LoadGhost() {
  const bool fits = ghost_ == kEarlierGhost ? SameRods(earlier_.figure, document_.figure)
                    : ghost_ == kFoundGhost ? SameRods(found_ghost_.figure, document_.figure)
                                            : ghost_ < static_cast<int>(document_.controllers.size());
  if (!fits) ghost_ = kNoGhost;
  if (ghost_ == kNoGhost) return;
  Document document = ghost_ == kEarlierGhost ? earlier_ : document_;
  if (ghost_ == kFoundGhost) {
    document.controllers = found_ghost_.controllers;
    document.timeline = found_ghost_.timeline;
  } else if (ghost_ >= 0) {
    document.timeline = {{.controller = ghost_, .start_step = 0}};
  }
  const Document& world = ghost_ == kCalmGhost ? calm_ : document_;
  document.environment = world.environment;
  document.pushes = world.pushes;
  ghost_player_.Load(document, false);
}

Decider RivalOf(const Controller& controller) {
  const bool timer = controller.kind == ControllerKind::kRules && controller.senses.kind == SenseKind::kTimer;
  return timer ? Decider::kSenses : Decider::kTimer;
}

}  // namespace gaitsmith::shell
