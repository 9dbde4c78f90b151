// SPDX-License-Identifier: MIT
// Undo and Redo of a session, and what each step changed.
#include <utility>

#include "core/document/parts.h"
#include "shell/session/session.h"
#include "shell/words/language.h"

namespace gaitsmith::shell {
namespace {

constexpr const char* kFigureWords = TrLater("the figure");

// What a step changed, in a few words. The first difference is the person's edit; later ones follow from it.
const char* ChangeWords(const Document& a, const Document& b) {
  const Parts changed = DifferingParts(a, b);
  const bool clips = changed.HasAny({Part::kTimeline, Part::kDuration});
  if (changed.HasAny(Part::kFigure)) return kFigureWords;
  if (a.controllers.size() == b.controllers.size() && clips) return TrLater("the timeline");
  if (changed.HasAny(Part::kPlan)) return TrLater("the keyframes");
  if (changed.HasAny({Part::kControllers, Part::kTimeline})) return TrLater("the motion");
  if (changed.HasAny(kTask)) return TrLater("the task and its weights");
  if (changed.HasAny({Part::kModel, Part::kEnvironment, Part::kStart, Part::kPushes}))
    return TrLater("the surroundings");
  if (changed.HasAny(Part::kSought)) return TrLater("the senses of the next search");
  return TrLater("settings of the next search");
}

}  // namespace

void Session::Undo() {
  live_.Drop();
  // If a search has found nothing yet, Undo only stops the search.
  const bool only_search = search_.HasChangedNothing();
  search_.Abandon();
  if (only_search) return workspace_.Say(Tr("Search stopped. The motion is unchanged."));
  if (const auto before = workspace_.TakeBack()) {
    Return(*before, TrLater("Undone: {1}."));
  } else {
    workspace_.Report(Tr("Nothing to undo."));
  }
}

void Session::Redo() {
  live_.Drop();
  // The search's last improvement is a separate step and leaves nothing to redo.
  if (CanRedo()) search_.Abandon();
  if (const auto after = workspace_.TakeForward()) {
    Return(*after, TrLater("Redone: {1}."));
  } else {
    workspace_.Report(Tr("Nothing to redo."));
  }
}

void Session::Return(const Document& document, const char* words) {
  const std::string what = ChangeWords(Doc(), document);
  BeginGesture();
  const bool rested = Doc().timeline.empty();
  workspace_.Show(document, what == kFigureWords);
  WakeFrom(rested);
  workspace_.Report(Tr(words, Tr(what.c_str())));
}

void Session::ForgetPast() {
  workspace_.ForgetPast();
  workspace_.Redraw();
}

}  // namespace gaitsmith::shell
