// SPDX-License-Identifier: MIT
#include "shell/session/motion_comparison.h"

#include <algorithm>
#include <utility>

#include "core/document/joints.h"
#include "core/document/timeline_edit.h"
#include "shell/words/control_modes.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

// Whether a found motion has this figure, with the same joints, this task and the wanted control mode.
bool FitsComparison(const FoundMotion& found, const Document& wanted) {
  if (!found.Moves()) return false;
  const Document& d = found.document;
  return d.controllers.back().kind == wanted.kind && d.controllers.back().senses.kind == wanted.senses.kind &&
         d.figure.name == wanted.figure.name && SameRods(d, wanted) && SameJoints(d, wanted) &&
         d.task.kind == wanted.task.kind;
}

}  // namespace

void MotionComparison::Choose(Ghost::Kind kind, int controller) {
  ghost_.SetSource(kind, controller, Documents());
  workspace_.Redraw();
}

bool MotionComparison::ChooseFound(const std::string& id) {
  const FoundMotions::Entry* entry = results_.Motions().Find(id);
  if (entry == nullptr || !entry->motion.Moves() ||
      !SameTree(entry->motion.document.figure, workspace_.Doc().figure))
    return false;
  ghost_.SetSource(id, entry->motion.document, Documents());
  workspace_.Redraw();
  return true;
}

void MotionComparison::ShowBeside(bool beside) {
  ghost_.ShowBeside(beside);
  workspace_.Redraw();
}

void MotionComparison::ShowBeside(const Document& other) {
  ghost_.SetSource("", other, Documents());
  ShowBeside(true);
}

void MotionComparison::ShowPlanned(const Document& planned) {
  ghost_.SetPlanned(planned, Documents());
  workspace_.Redraw();
}

void MotionComparison::Stop() {
  ghost_.ShowBeside(false);
  Choose(Ghost::Kind::kNone);
}

void MotionComparison::CompareControlModes() {
  const Controller* shown = workspace_.ShownController();
  if (shown == nullptr) {
    workspace_.Say(Tr("There is no motion to compare yet. Press Synthesize."));
    return;
  }
  Document wanted = workspace_.Doc();
  SetControlMode(wanted, ContrastTo(*shown));
  wanted.search.start = -1;
  for (const FoundMotions::Entry* entry : results_.Motions().Sorted(FoundMotions::Order::kBest)) {
    if (!FitsComparison(entry->motion, wanted) || !ChooseFound(entry->id)) continue;
    ghost_.ShowBeside(true);
    return;
  }
  if (Awaits() || !queue_.Add(wanted)) return;
  requested_ = std::move(wanted);
  if (!queue_.Busy()) queue_.Run();
}

bool MotionComparison::Awaits() const {
  if (!requested_) return false;
  const auto same = [&](const Document& other) { return SameSearch(other, *requested_); };
  return (search_.Searched() != nullptr && same(*search_.Searched())) ||
         std::ranges::any_of(queue_.List().Waiting(), same, &SearchQueue::Entry::document);
}

void MotionComparison::ShowIfRequested(const std::string& id) {
  const FoundMotions::Entry* entry = requested_ ? results_.Motions().Find(id) : nullptr;
  if (entry == nullptr || !FitsComparison(entry->motion, *requested_)) return;
  requested_.reset();
  if (ChooseFound(id)) ghost_.ShowBeside(true);
}

std::optional<Controller> MotionComparison::ComparedController() const {
  const auto index = ghost_.ControllerIndex();
  if (!index) return std::nullopt;
  return workspace_.Doc().controllers[static_cast<std::size_t>(*index)];
}

void MotionComparison::FindAgain(const Controller& controller) {
  // If the document has lost the controller, the index is past the end and the ghost is empty.
  Document searched = workspace_.Doc();
  const auto index = AddController(searched, controller);
  ghost_.SetSource(Ghost::Kind::kController, index.value_or(-1), Documents());
}

}  // namespace gaitsmith::shell
