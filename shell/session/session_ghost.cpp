// SPDX-License-Identifier: MIT
// The session's second motion, which the shown one is compared with: behind it as a ghost, or beside it.
#include <algorithm>

#include "shell/session/session.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

// For this figure and task, decided in the wanted way.
bool SuitsAsRival(const FoundMotion& found, const Document& wanted) {
  if (!found.Moves()) return false;
  const Document& d = found.document;
  return d.controllers.back().kind == wanted.kind && d.controllers.back().senses.kind == wanted.senses.kind &&
         d.figure.name == wanted.figure.name && SameTree(d.figure, wanted.figure) &&
         d.task.kind == wanted.task.kind;
}

}  // namespace

void Session::ChooseGhost(Ghost::Kind kind, int controller) {
  ghost_.StandFor(kind, controller, GhostDocuments());
  host_.DocumentChanged(document_.title);
}

bool Session::ChooseFoundGhost(const std::string& id) {
  const FoundMotions::Entry* entry = found.Find(id);
  if (entry == nullptr || !entry->motion.Moves() ||
      !SameTree(entry->motion.document.figure, document_.figure))
    return false;
  ghost_.StandFor(id, entry->motion.document, GhostDocuments());
  host_.DocumentChanged(document_.title);
  return true;
}

void Session::PutSideBySide(bool beside) {
  ghost_.PutBeside(beside);
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
    ghost_.PutBeside(true);
    return;
  }
  if (AwaitsRival() || !Enqueue(wanted)) return;
  rival_ = std::move(wanted);
  if (!Searching() && !lab.Running()) RunQueue();
}

void Session::StopComparing() {
  ghost_.PutBeside(false);
  ChooseGhost(Ghost::Kind::kNone);
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
  if (ChooseFoundGhost(noted_)) ghost_.PutBeside(true);
}

Decider RivalOf(const Controller& controller) {
  const bool timer = controller.kind == ControllerKind::kRules && controller.senses.kind == SenseKind::kTimer;
  return timer ? Decider::kSenses : Decider::kTimer;
}

}  // namespace gaitsmith::shell
